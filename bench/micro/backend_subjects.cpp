#include "bench/micro/subject.hpp"
#include "predicates/backends/all.hpp"
#include "predicates/formulas/with_formula.hpp"

#include <benchmark/benchmark.h>

#include <utility>

namespace tribunal::bench {
namespace {

template <class B, class Formula>
class BackendLoop final : public SignLoop {
 public:
  BackendLoop(B backend, std::span<const Query<Formula>> queries)
      : backend_(std::move(backend)), queries_(queries) {}

  void sign(std::span<Sign> signs) const override {
    for (std::size_t i = 0; i < signs.size(); ++i) {
      const Sign sign = backend_.template decide<Formula>(queries_[i]).sign;
      // An engine asks one question at a time; the compiler shall not answer several at once here.
      benchmark::DoNotOptimize(sign);
      signs[i] = sign;
    }
  }
  void decide(std::span<Decision> decisions) const override {
    for (std::size_t i = 0; i < decisions.size(); ++i)
      decisions[i] = backend_.template decide<Formula>(queries_[i]);
  }

 private:
  B backend_;
  std::span<const Query<Formula>> queries_;
};

template <class B>
SignLoopBinding bind(const QuerySet& queries) {
  return with_formula(queries.predicate, [&]<class Formula>() -> SignLoopBinding {
    if constexpr (Backend<B, Formula::dimension>) {
      Binding<B> bound = B::bind(queries.points<Formula::dimension>());
      if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
      return std::make_unique<const BackendLoop<B, Formula>>(std::get<B>(std::move(bound)),
                                                             queries.arguments<Formula>());
    } else {
      return Refusal{0, "it has no predicates in space"};
    }
  });
}

template <class... B>
std::vector<Subject> subjects_of(BackendTypes<B...>) {
  return {Subject{std::string(B::about.name), B::about.exact, bind<B>}...};
}

}  // namespace

std::vector<Subject> backend_subjects() { return subjects_of(AllBackends{}); }

}  // namespace tribunal::bench
