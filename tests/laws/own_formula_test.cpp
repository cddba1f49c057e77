// The worked example of docs/predicates.md: a formula of one's own, and every backend for it.
#include "predicates/filters/dynamic.hpp"
#include "predicates/formulas/query.hpp"
#include "tests/laws/backend_types.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tribunal::laws {
namespace {

/// Whether the segment p2 p3 turns left of p0 p1: the sign of the cross product of two directions.
struct Turn {
  static constexpr int dimension = 2, points = 4;
  static constexpr auto determinant(const auto& p) {
    const auto ux = p[1][0] - p[0][0], uy = p[1][1] - p[0][1];
    const auto vx = p[3][0] - p[2][0], vy = p[3][1] - p[2][1];
    return ux * vy - uy * vx;
  }
};

TEST(OwnFormula, EveryExactBackendGivesItsTrueSign) {
  std::vector<Point2> grid;
  for (int i = 0; i < 25; ++i) grid.push_back({double(i % 5), double(i / 5)});
  const int asked = for_each_exact_backend<Turn>(grid, [&](const auto& backend) {
    for (const Point2& a : grid)
      for (const Point2& b : grid)
        for (const Point2& c : grid) {
          const Query<Turn> query{a, b, c, {2, 3}};
          const auto integer = [](double x) { return static_cast<std::int64_t>(x); };
          const std::int64_t cross =
              integer(b[0] - a[0]) * integer(3 - c[1]) - integer(b[1] - a[1]) * integer(2 - c[0]);
          ASSERT_EQ(backend.template decide<Turn>(query).sign, sign_of(cross));
        }
  });
  EXPECT_EQ(asked, 7) << "redundant, fortune-van-wyk, interval, adaptive, filtered, fixed, gmp";
}

/// The determinant of three directions in other shapes than the listed formulas have: products of two
/// products, sums of differences, a factor on the right.
struct RightFactor {
  static constexpr auto of(const auto& b, const auto& c, const auto& d) {
    return (b[0] * c[1] - b[1] * c[0]) * d[2] + (c[0] * d[1] - c[1] * d[0]) * b[2] +
           (d[0] * b[1] - d[1] * b[0]) * c[2];
  }
};
struct ThreeFactors {
  static constexpr auto of(const auto& b, const auto& c, const auto& d) {
    return b[0] * c[1] * d[2] - b[1] * c[0] * d[2] + c[0] * d[1] * b[2] - c[1] * d[0] * b[2] +
           d[0] * b[1] * c[2] - d[1] * b[0] * c[2];
  }
};
struct SumOfDifferences {
  static constexpr auto of(const auto& b, const auto& c, const auto& d) {
    return b[0] * (c[1] + d[1]) - b[1] * (c[0] - d[0]) + b[0] * c[0] - b[1] * c[1];
  }
};
struct ProductOfProducts {
  static constexpr auto of(const auto& b, const auto& c, const auto&) {
    return (b[0] * c[0]) * (b[0] * c[0]) - b[1] * c[1] * b[1] * c[1];
  }
};

template <class Shape>
struct OfDirections {
  static constexpr int dimension = 3, points = 4;
  static constexpr auto determinant(const auto& p) {
    const auto from_first = [&p](int i) {
      return std::array{p[i][0] - p[0][0], p[i][1] - p[0][1], p[i][2] - p[0][2]};
    };
    return Shape::of(from_first(1), from_first(2), from_first(3));
  }
};

template <class Shape>
class FormulaShape : public testing::Test {};
using Shapes = testing::Types<RightFactor, ThreeFactors, SumOfDifferences, ProductOfProducts>;
TYPED_TEST_SUITE(FormulaShape, Shapes);

/// The rules for a formula ask nothing of its shape: every exact backend evaluates it, random and tied.
TYPED_TEST(FormulaShape, IsEvaluatedByEveryExactBackend) {
  using Formula = OfDirections<TypeParam>;
  Random random(3);
  std::vector<Point3> points;
  for (int i = 0; i < 400; ++i) points.push_back(draw_point<3>([&] { return double(random.below(7)); }));
  const int asked = for_each_exact_backend<Formula>(points, [&](const auto& backend) {
    for (std::size_t i = 0; i + 4 <= points.size(); i += 2) {
      const Query<Formula> query{points[i], points[i + 1], points[i + 2], points[i + 3]};
      const auto counts = convert_arguments<std::int64_t, Formula>(
          query, [](double c) { return static_cast<std::int64_t>(c); });
      ASSERT_EQ(backend.template decide<Formula>(query).sign, sign_of(Formula::determinant(counts)));
    }
  });
  EXPECT_EQ(asked, 7);
}

/// Two parallel directions whose coordinates were rounded: doubles get some wrong that all the others get
/// right.
TEST(OwnFormula, NearTiesAreWhereRoundingShows) {
  Random random(1);
  std::vector<Query<Turn>> queries;
  std::vector<Point2> points;
  for (int i = 0; i < 1000; ++i) {
    const Point2 u{random.unit(), random.unit()};
    const double factor = random.unit();
    queries.push_back({Point2{0, 0}, u, Point2{0, 0}, {u[0] * factor, u[1] * factor}});
    points.insert(points.end(), queries.back().begin(), queries.back().end());
  }
  const Gmp exact = std::get<Gmp>(Gmp::bind(std::span<const Point2>(points)));
  const Double naive = std::get<Double>(Double::bind(std::span<const Point2>(points)));
  const auto filtered_binding = Filtered::bind(std::span<const Point2>(points));
  const Filtered& filtered = std::get<Filtered>(filtered_binding);
  int wrong = 0;
  for (const auto& query : queries) {
    wrong += naive.decide<Turn>(query).sign != exact.decide<Turn>(query).sign;
    EXPECT_EQ(filtered.decide<Turn>(query).sign, exact.decide<Turn>(query).sign);
  }
  EXPECT_GT(wrong, 100);
}

/// Bounds and widths come with it: this one errs like orientation, which it is but for the second origin.
static_assert(error_coefficient<Turn> == error_coefficient<Orient<2>>);

}  // namespace
}  // namespace tribunal::laws
