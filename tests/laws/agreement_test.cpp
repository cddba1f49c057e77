// Law: a backend that promises exactness agrees with the oracle on its whole domain; one that does not is
// caught.
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace tribunal::laws {
namespace {

/// A family together with the truth about it, which the oracle is asked for once.
template <int D>
struct Judged {
  Family<D> family;
  std::vector<Sign> orient, in_sphere;
};

template <int D>
const std::vector<Judged<D>>& judged_families() {
  static const std::vector<Judged<D>> all = [] {
    std::vector<Judged<D>> judged;
    for (auto& family : families<D>()) {
      auto& last = judged.emplace_back(Judged<D>{std::move(family), {}, {}});
      for (const auto& points : last.family.cases) {
        last.orient.push_back(true_orient<D>(points));
        last.in_sphere.push_back(true_in_sphere<D>(points));
      }
    }
    return judged;
  }();
  return all;
}

class Agreement : public EveryBackend {
 protected:
  /// Wrong signs over all families that the backend accepts; an exact one fails at the first.
  template <int D>
  int disagreements() const {
    int wrong = 0;
    for (const auto& [family, orients, in_spheres] : judged_families<D>()) {
      const auto kernel = bind<D>(entry(), family.points());
      if (!kernel) continue;
      for (std::size_t i = 0; i < family.cases.size(); ++i) {
        const bool right = orient(*kernel, family.cases[i]) == orients[i] &&
                           in_sphere(*kernel, family.cases[i]) == in_spheres[i];
        EXPECT_TRUE(right || !exact()) << family.name << ": " << hexadecimal<D>(family.cases[i]);
        if (!right && ++wrong == 1000) return wrong;
      }
    }
    return wrong;
  }
};

TEST_P(Agreement, IsCompleteWherePromisedAndElsewhereCaught) {
  const int least = exact() ? 0 : 100;
  EXPECT_GE(disagreements<2>(), least);
  if (entry().bind3 != nullptr) {
    EXPECT_GE(disagreements<3>(), least);
  }
}

/// The law above is empty where there is nothing near or at zero to get wrong.
TEST(Families, HoldAllThreeSignsOfBothPredicates) {
  const auto count = [](const auto& judged, Sign sign) {
    std::ptrdiff_t n = 0;
    for (const auto& [family, orients, in_spheres] : judged)
      n += std::min(std::count(orients.begin(), orients.end(), sign),
                    std::count(in_spheres.begin(), in_spheres.end(), sign));
    return n;
  };
  for (const Sign sign : {Sign::negative, Sign::zero, Sign::positive}) {
    EXPECT_GT(count(judged_families<2>(), sign), 1000);
    EXPECT_GT(count(judged_families<3>(), sign), 1000);
  }
}

// Witnesses of each backend that makes no promise.

TEST(Witness, DoubleCallsAThinTriangleFlat) {
  const Case<2> points{{{{0.5, 0.5 + 0x1p-53}}, {{12, 12}}, {{24, 24}}, {{0, 0}}}};
  const auto kernel = bind<2>(*find_backend("double"), {points.begin(), points.end()});
  EXPECT_EQ(true_orient<2>(points), Sign::positive);
  EXPECT_EQ(orient(*kernel, points), Sign::zero);
}

TEST(Witness, FusedProductsGiveACollinearTripleAnArea) {
  // Opposite vectors from the pivot: b.x c.y and b.y c.x are the same real number, but only one of them is
  // rounded.
  const Case<2> points{{{{0, 0}}, {{0.1, 0.3}}, {{-0.1, -0.3}}, {{1, 1}}}};
  const auto kernel = bind<2>(*find_backend("double-fma"), {points.begin(), points.end()});
  EXPECT_EQ(true_orient<2>(points), Sign::zero);
  EXPECT_NE(orient(*kernel, points), Sign::zero);
  EXPECT_EQ(orient(*bind<2>(*find_backend("double"), {points.begin(), points.end()}), points), Sign::zero);
}

TEST(Witness, PrintedProgramMisjudgesAUnitSquare) {
  const Case<2> points{{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
  const auto kernel = bind<2>(*find_backend("knuth-as-printed"), {points.begin(), points.end()});
  EXPECT_EQ(true_in_sphere<2>(points), Sign::zero);
  EXPECT_NE(in_sphere(*kernel, points), Sign::zero);
}

TRIBUNAL_FOR_EVERY_BACKEND(Agreement);

}  // namespace
}  // namespace tribunal::laws
