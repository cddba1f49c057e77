// Laws of insertion orders.
#include "datasets/dataset.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tribunal {
namespace {

constexpr std::array orders{Order::random, Order::input, Order::hilbert, Order::x, Order::brio};

double length(std::span<const Point2> points, Order order) {
  const auto path = insertion_order(points, order, 1);
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum +=
        std::hypot(points[path[i]][0] - points[path[i - 1]][0], points[path[i]][1] - points[path[i - 1]][1]);
  return sum;
}

TEST(Orders, ArePermutations) {
  for (const std::string_view name : {"uniform", "duplicates", "collinear", "mixed-exponents", "counties"}) {
    for (const std::uint64_t n : {0, 1, 2, 3, 1000}) {
      auto points = find_dataset(name)->generate(std::max<std::uint64_t>(n, 1), 1);
      points.resize(n);
      for (const Order order : orders) {
        auto indices = insertion_order(points, order, 5);
        std::ranges::sort(indices);
        std::vector<std::uint32_t> all(n);
        std::iota(all.begin(), all.end(), 0U);
        EXPECT_EQ(indices, all) << name << n;
      }
    }
  }
}

TEST(Orders, OnlyRandomAndBrioDependOnTheSeed) {
  const auto points = find_dataset("uniform")->generate(100, 1);
  for (const Order order : orders)
    EXPECT_EQ(insertion_order(points, order, 1) != insertion_order(points, order, 2),
              order == Order::random || order == Order::brio);
}

TEST(Orders, InputIsTheIdentity) {
  const auto order = insertion_order(find_dataset("uniform")->generate(100, 1), Order::input, 1);
  EXPECT_TRUE(std::ranges::is_sorted(order));
}

TEST(Orders, XSortsLexicographicallyWithTiesByIndex) {
  const auto points = find_dataset("duplicates")->generate(400, 1);
  const auto order = insertion_order(points, Order::x, 1);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point2& before = points[order[i - 1]];
    const Point2& after = points[order[i]];
    ASSERT_TRUE(before < after || (before == after && order[i - 1] < order[i]));
  }
}

TEST(Orders, HilbertWalksAFullLatticeInUnitSteps) {
  for (const std::uint64_t side : {2, 4, 16, 256}) {
    const auto points = find_dataset("grid")->generate(side * side, 1);
    EXPECT_EQ(length(points, Order::hilbert), static_cast<double>(side * side - 1));
    EXPECT_EQ(insertion_order(points, Order::hilbert, 1).front(), 0U);
  }
}

TEST(Orders, HilbertIsLocal) {
  const auto points = find_dataset("uniform")->generate(10000, 1);
  EXPECT_LT(length(points, Order::hilbert), length(points, Order::random) / 40);
  EXPECT_LT(length(points, Order::hilbert), 1.0 * std::sqrt(10000));  // about 0.92 sqrt(n) for uniform points
}

TEST(Orders, BrioIsHilbertWithinRoundsThatDoubleAndRandomBetweenThem) {
  const auto points = find_dataset("uniform")->generate(4096, 1);
  const auto curve = insertion_order(points, Order::hilbert, 1);
  std::vector<std::size_t> along(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) along[curve[i]] = i;
  const auto brio = insertion_order(points, Order::brio, 1);
  std::size_t begin = 0;
  for (std::size_t end = 64; end <= brio.size(); begin = end, end *= 2) {
    std::size_t wide_gaps = 0;
    for (std::size_t i = begin + 1; i < end; ++i) {
      ASSERT_LT(along[brio[i - 1]], along[brio[i]]);
      // A sample spread over the whole curve leaves no gap much wider than its mean.
      if (along[brio[i]] - along[brio[i - 1]] > 12 * brio.size() / (end - begin)) ++wide_gaps;
    }
    EXPECT_EQ(wide_gaps, 0U);
  }
}

TEST(Orders, HilbertKeepsEqualPointsByIndex) {
  const auto order = insertion_order(std::vector<Point2>(50, Point2{{3, 4}}), Order::hilbert, 1);
  EXPECT_TRUE(std::ranges::is_sorted(order));
}

TEST(Orders, NamesAndOrdersBelongTogether) {
  ASSERT_EQ(order_names().size(), orders.size());
  for (const Order order : orders) {
    Order parsed{};
    EXPECT_TRUE(parse_order(order_names()[static_cast<std::size_t>(order)], parsed));
    EXPECT_EQ(parsed, order);
  }
  Order parsed = Order::x;
  EXPECT_FALSE(parse_order("Hilbert", parsed));
  EXPECT_FALSE(parse_order("", parsed));
  EXPECT_EQ(parsed, Order::x);
}

}  // namespace
}  // namespace tribunal
