// Law: queries decided many at a time have the signs that they have one at a time.
#include "predicates/batch/batch.hpp"

#include "predicates/batch/lanes.hpp"
#include "predicates/filters/sign_beyond.hpp"
#include "tests/laws/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace tribunal::laws {
namespace {

/// The cases of a family in columns, one for each coordinate of each of a formula's points.
template <class Formula, int D>
struct Transposed {
  explicit Transposed(const std::vector<Case<D>>& cases) {
    for (int k = 0; k < Formula::points; ++k)
      for (int axis = 0; axis < D; ++axis) {
        auto& column = columns[k * D + axis];
        for (const auto& points : cases) column.push_back(points[k][axis]);
        operands[k][axis] = column.data();
      }
  }
  std::array<std::vector<double>, std::size_t{Formula::points} * D> columns;
  ColumnArguments<Formula> operands;
};

template <class Formula, int D>
Query<Formula> query_from(const Case<D>& points) {
  Query<Formula> query;
  std::copy_n(points.begin(), Formula::points, query.begin());
  return query;
}

template <class Formula, int D>
void expect_same_signs() {
  for (const auto& family : families<D>()) {
    const auto points = family.points();
    const auto kernel = std::get<Filtered>(Filtered::bind(std::span<const Point<D>>(points)));
    const Transposed<Formula, D> transposed(family.cases);
    std::vector<Sign> signs(family.cases.size());
    decide_batch<Formula>(kernel, transposed.operands, signs);
    for (std::size_t i = 0; i < signs.size(); ++i)
      ASSERT_EQ(signs[i], kernel.template decide<Formula>(query_from<Formula, D>(family.cases[i])).sign)
          << family.name << ": " << hexadecimal<D>(family.cases[i]);
  }
}

TEST(Batch, HasTheSignsOfSingleQueries) {
  expect_same_signs<Orient<2>, 2>();
  expect_same_signs<InSphere<2>, 2>();
  expect_same_signs<Orient<3>, 3>();
  expect_same_signs<InSphere<3>, 3>();
}

/// Registers are filled with whole groups of queries; what is left over is decided all the same, and nothing
/// is written behind it.
TEST(Batch, AnyNumberOfQueriesWillDo) {
  const auto family = shared_domain<2>(40, 9);
  const auto points = family.points();
  const auto kernel = std::get<Filtered>(Filtered::bind(std::span<const Point2>(points)));
  const Transposed<InSphere<2>, 2> transposed(family.cases);
  for (std::size_t count = 0; count <= 33; ++count) {
    std::vector<Sign> signs(count + 1, Sign::zero);
    decide_batch<InSphere<2>>(kernel, transposed.operands, std::span(signs).first(count));
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(signs[i], kernel.decide<InSphere<2>>(query_from<InSphere<2>, 2>(family.cases[i])).sign);
    EXPECT_EQ(signs[count], Sign::zero);
  }
}

/// The instruction sets that this processor has, so that each is held to the law and not the widest alone.
std::vector<std::pair<std::string_view, const LaneFilters*>> instruction_sets() {
  std::vector<std::pair<std::string_view, const LaneFilters*>> sets{{"baseline", &baseline::lane_filters}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) sets.emplace_back("avx2", &avx2::lane_filters);
  if (batch_instructions() == "avx512") sets.emplace_back("avx512", &avx512::lane_filters);
#endif
  return sets;
}

template <class Formula, int D>
void expect_same_filter(LaneFilters::Filter LaneFilters::*filter) {
  for (const auto& family : families<D>()) {
    const Transposed<Formula, D> transposed(family.cases);
    std::array<const double*, std::size_t{Formula::points} * D> columns;
    std::transform(transposed.columns.begin(), transposed.columns.end(), columns.begin(),
                   [](const auto& column) { return column.data(); });
    for (const double threshold : {0.0, 0x1p-54, 1.0, 0x1p200, static_cast<double>(HUGE_VAL)})
      for (const auto& [name, filters] : instruction_sets()) {
        std::vector<std::int8_t> signs(family.cases.size(), 7);
        const std::size_t decided = (filters->*filter)(columns.data(), threshold, signs.data(), signs.size());
        EXPECT_LT(signs.size() - decided, 8u);
        for (std::size_t i = 0; i < decided; ++i)
          ASSERT_EQ(static_cast<Sign>(signs[i]),
                    sign_beyond(Formula::determinant(query_from<Formula, D>(family.cases[i])), threshold))
              << name << ", " << family.name << ": " << hexadecimal<D>(family.cases[i]);
      }
  }
}

/// Overflow and NaN included: they are decided in no lane.
TEST(Lanes, ComputeWhatScalarsDo) {
  expect_same_filter<Orient<2>, 2>(&LaneFilters::orient2d);
  expect_same_filter<InSphere<2>, 2>(&LaneFilters::incircle);
  expect_same_filter<Orient<3>, 3>(&LaneFilters::orient3d);
  expect_same_filter<InSphere<3>, 3>(&LaneFilters::insphere);
}

}  // namespace
}  // namespace tribunal::laws
