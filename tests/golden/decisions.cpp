// Prints a digest of the decisions (sign and stage) of every backend on every query family. Built at several
// optimisation levels and by both compilers, and compared with one golden file: what a compiler is told must
// not change a sign, nor which stage found it.
#include "datasets/queries/queries.hpp"
#include "predicates/backends/all.hpp"
#include "predicates/predicate.hpp"

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tribunal {
namespace {

constexpr std::size_t queries = 300;

/// FNV-1a over bytes.
class Digest {
 public:
  void add(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001B3; }
  void add(Decision decision) {
    add(static_cast<std::uint8_t>(decision.sign));
    add(static_cast<std::uint8_t>(decision.stage));
  }
  unsigned long long value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325;
};

template <int D>
std::vector<Point<D>> draw(const QueryFamily& family, Predicate predicate) {
  if constexpr (D == 2)
    return draw_queries2(family, predicate, queries, 1);
  else
    return draw_queries3(family, predicate, queries, 1);
}

template <class B, class Formula>
void print_predicate(Predicate predicate) {
  constexpr int D = Formula::dimension;
  Digest digest;
  int refused = 0;
  for (const QueryFamily& family : query_families()) {
    const std::vector<Point<D>> points = draw<D>(family, predicate);
    const auto binding = B::bind(std::span<const Point<D>>(points));
    if (std::holds_alternative<Refusal>(binding)) {
      ++refused;
      continue;
    }
    for (std::size_t i = 0; i < points.size(); i += Formula::points) {
      Query<Formula> query;
      for (int k = 0; k < Formula::points; ++k) query[k] = points[i + static_cast<std::size_t>(k)];
      digest.add(std::get<B>(binding).template decide<Formula>(query));
    }
  }
  std::printf("%-18s %-8s %016llx, %d families refused\n", std::string(B::about.name).c_str(),
              std::string(to_string(predicate)).c_str(), digest.value(), refused);
}

template <class... B>
void print_all(BackendTypes<B...>) {
  const auto print = [&]<class Each>(BackendTypes<Each>) {
    print_predicate<Each, Orient<2>>(Predicate::orient2d);
    print_predicate<Each, InSphere<2>>(Predicate::incircle);
    if constexpr (Backend<Each, 3>) {
      print_predicate<Each, Orient<3>>(Predicate::orient3d);
      print_predicate<Each, InSphere<3>>(Predicate::insphere);
    }
  };
  (print(BackendTypes<B>{}), ...);
}

}  // namespace
}  // namespace tribunal

int main() { tribunal::print_all(tribunal::AllBackends{}); }
