#include "bench/micro/subject.hpp"
#include "predicates/batch/batch.hpp"
#include "predicates/formulas/with_formula.hpp"

#include <array>
#include <utility>

namespace tribunal::bench {
namespace {

template <class Formula>
class BatchLoop final : public SignLoop {
 public:
  BatchLoop(Filtered kernel, std::span<const Point<Formula::dimension>> points) : kernel_(kernel) {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t axis = 0; axis < Formula::dimension; ++axis)
        columns_[i % Formula::points][axis].push_back(points[i][axis]);
  }

  void sign(std::span<Sign> signs) const override {
    ColumnArguments<Formula> operands;
    for (std::size_t k = 0; k < Formula::points; ++k)
      for (std::size_t axis = 0; axis < Formula::dimension; ++axis)
        operands[k][axis] = columns_[k][axis].data();
    decide_batch<Formula>(kernel_, operands, signs);
  }
  /// The signs of the batch; it keeps no stages, so they are those of the kernel asked one by one.
  void decide(std::span<Decision> decisions) const override {
    std::vector<Sign> signs(decisions.size());
    sign(signs);
    for (std::size_t i = 0; i < decisions.size(); ++i)
      decisions[i] = {signs[i], kernel_.decide<Formula>(query(i)).stage};
  }

 private:
  Query<Formula> query(std::size_t i) const {
    Query<Formula> query;
    for (std::size_t k = 0; k < Formula::points; ++k)
      for (std::size_t axis = 0; axis < Formula::dimension; ++axis) query[k][axis] = columns_[k][axis][i];
    return query;
  }

  Filtered kernel_;
  std::array<std::array<std::vector<double>, Formula::dimension>, Formula::points> columns_;
};

SignLoopBinding bind(const QuerySet& queries) {
  return with_formula(queries.predicate, [&]<class Formula>() -> SignLoopBinding {
    const auto points = queries.points<Formula::dimension>();
    Binding<Filtered> bound = Filtered::bind(points);
    if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
    return std::make_unique<const BatchLoop<Formula>>(std::get<Filtered>(std::move(bound)), points);
  });
}

}  // namespace

Subject batch_subject() {
  return {std::string(Filtered::about.name) + "-batch", Filtered::about.exact, bind};
}

}  // namespace tribunal::bench
