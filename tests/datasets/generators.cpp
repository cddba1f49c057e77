// Every dataset is what its summary says.

#include "datasets/dataset.hpp"
#include "datasets/generators/square.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tribunal {
namespace {
using test::distinct;
using test::orient;
using test::wide;
using test::Wide;

std::vector<Point2> generate(std::string_view name, std::uint64_t n, std::uint64_t seed = 1) {
  const Dataset* dataset = find_dataset(name);
  if (dataset == nullptr) throw std::invalid_argument(std::string(name));
  return dataset->generate(n, seed);
}

bool same_bytes(std::span<const Point2> a, std::span<const Point2> b) {
  return std::ranges::equal(a, b, [](const Point2& p, const Point2& q) {
    return std::bit_cast<std::array<std::uint64_t, 2>>(p) == std::bit_cast<std::array<std::uint64_t, 2>>(q);
  });
}

bool is_integer(double c) { return c == std::floor(c) && std::fabs(c) <= 0x1p53; }

// ---- laws of all datasets

class EveryDataset : public ::testing::TestWithParam<Dataset> {};

TEST_P(EveryDataset, GivesThePointsAskedFor) {
  const auto& [about, generator, graph] = GetParam();
  for (const std::uint64_t n : {1, 2, 3, 4, 5, 17, 100}) {
    const std::uint64_t expected = about.name == "lawson-worst-case" && n > 3 ? n / 4 * 4 : n;
    EXPECT_EQ(generator(n, 1).size(), expected) << n;
  }
}

TEST_P(EveryDataset, IsTheSameBytesForTheSameSeed) {
  const auto& generator = GetParam().generate;
  EXPECT_TRUE(same_bytes(generator(500, 7), generator(500, 7)));
}

TEST_P(EveryDataset, IsFinite) {
  for (const Point2& p : GetParam().generate(2000, 1))
    ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]));
}

TEST_P(EveryDataset, IsOfIntegersJustWhenItSaysSo) {
  const auto points = GetParam().generate(2000, 1);
  const bool integers =
      std::ranges::all_of(points, [](auto& p) { return is_integer(p[0]) && is_integer(p[1]); });
  EXPECT_EQ(integers, GetParam().about.integer);
}

TEST_P(EveryDataset, IsFoundByItsNameAndDescribed) {
  const DatasetAbout& about = GetParam().about;
  ASSERT_NE(find_dataset(about.name), nullptr);
  EXPECT_EQ(find_dataset(about.name)->generate, GetParam().generate);
  EXPECT_FALSE(about.cites.empty());
  EXPECT_FALSE(about.summary.empty());
  EXPECT_LE(about.summary.size(), 90U);
}

TEST_P(EveryDataset, OfFixedSizeEndsThere) {
  const auto& [about, generator, graph] = GetParam();
  if (about.fixed_size > 0) {
    EXPECT_EQ(generator(about.fixed_size, 1).size(), about.fixed_size);
    EXPECT_EQ(generator(about.fixed_size + 1000, 1).size(), about.fixed_size);
  } else if (about.name != "circle" && about.name != "lawson-worst-case") {
    EXPECT_EQ(generator(10000, 1).size(), 10000U);
  }
}

std::string test_name(const ::testing::TestParamInfo<Dataset>& dataset) {
  std::string name(dataset.param.about.name);
  std::ranges::replace(name, '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(List, EveryDataset, ::testing::ValuesIn(datasets().begin(), datasets().end()),
                         test_name);

TEST(Datasets, UnknownNameIsNull) { EXPECT_EQ(find_dataset("no such dataset"), nullptr); }

TEST(Datasets, AreTheFilesOfTheirFolderByName) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TRIBUNAL_GENERATORS)) {
    if (entry.path().extension() != ".cpp") continue;
    std::string name = entry.path().stem().string();
    std::ranges::replace(name, '_', '-');
    EXPECT_NE(find_dataset(name), nullptr) << entry.path();
    ++files;
  }
  EXPECT_EQ(files, datasets().size());
}

TEST(Datasets, SeedsMatterWhereThereIsChance) {
  for (const std::string_view name : {"uniform", "normal", "clusters", "circle", "near-circle", "collinear",
                                      "near-collinear", "duplicates", "spiral", "mixed-exponents"})
    EXPECT_FALSE(same_bytes(generate(name, 50, 1), generate(name, 50, 2))) << name;
}

// ---- the law of each

TEST(Uniform, FillsTheUnitSquareEvenly) {
  std::array<int, 16> cells{};
  for (const Point2& p : generate("uniform", 16000))
    ++cells.at(static_cast<std::size_t>(4 * p[0]) + 4 * static_cast<std::size_t>(4 * p[1]));
  for (const int count : cells) EXPECT_NEAR(count, 1000, 130);  // four deviations
}

TEST(Normal, HasTheMomentsAndQuantilesOfTheNormalDistribution) {
  double sum = 0;
  double squares = 0;
  double fourths = 0;
  int within_one = 0;
  int beyond_three = 0;
  constexpr int n = 100000;
  for (const Point2& p : generate("normal", n / 2)) {
    for (const double c : p.coordinate) {
      sum += c;
      squares += c * c;
      fourths += c * c * c * c;
      within_one += std::fabs(c) < 1 ? 1 : 0;
      beyond_three += std::fabs(c) > 3 ? 1 : 0;
    }
  }
  EXPECT_NEAR(sum / n, 0, 0.013);  // four deviations of each
  EXPECT_NEAR(squares / n, 1, 0.018);
  EXPECT_NEAR(fourths / n, 3, 0.125);
  EXPECT_NEAR(within_one / double{n}, 0.682689, 0.006);
  EXPECT_NEAR(beyond_three / double{n}, 0.0026998, 0.0007);
}

TEST(Clusters, MembersInTurnStayWithTheirTenCentres) {
  const auto points = generate("clusters", 5000);
  for (std::size_t i = 10; i < points.size(); ++i)
    ASSERT_LT(std::hypot(points[i][0] - points[i % 10][0], points[i][1] - points[i % 10][1]), 0.1);
}

TEST(Square, SideIsTheSmallestThatHoldsN) {
  for (std::uint64_t n = 1; n < 2000; ++n) {
    const std::uint64_t side = generators::square_side(n);
    ASSERT_GE(side * side, n);
    ASSERT_LT((side - 1) * (side - 1), n);
  }
}

TEST(Grid, IsTheFirstCellsOfTheSmallestSquare) {
  EXPECT_EQ(generate("grid", 5), (std::vector<Point2>{{{0, 0}}, {{1, 0}}, {{2, 0}}, {{0, 1}}, {{1, 1}}}));
  EXPECT_EQ(distinct(generate("grid", 1000)), 1000U);
}

TEST(TiltedGrid, TurnsBackIntoTheGrid) {
  const auto grid = generate("grid", 1000);
  const auto tilted = generate("tilted-grid", 1000);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_EQ(3 * tilted[i][0] + 4 * tilted[i][1], 25 * grid[i][0]);
    EXPECT_EQ(3 * tilted[i][1] - 4 * tilted[i][0], 25 * grid[i][1]);
  }
}

TEST(RotatedGrid, KeepsDistancesButForRounding) {
  const auto points = generate("rotated-grid", 1024);
  for (std::size_t i = 0; i + 32 < points.size(); ++i)
    EXPECT_NEAR(std::hypot(points[i + 32][0] - points[i][0], points[i + 32][1] - points[i][1]), 1, 1e-13);
  // Rows are no longer exactly collinear: in units of 2^-56, coordinates from 1/16 to 64 are integers.
  int bent = 0;
  for (std::size_t i = 0; i < points.size(); i += 32) {
    std::array<Point2, 3> row{points[i], points[i + 15], points[i + 31]};
    bool representable = true;
    for (Point2& p : row) {
      representable = representable && std::fabs(p[0]) >= 0x1p-4 && std::fabs(p[1]) >= 0x1p-4;
      p = {{p[0] * 0x1p56, p[1] * 0x1p56}};
    }
    if (representable && orient(row[0], row[1], row[2]) != 0) ++bent;
  }
  EXPECT_GT(bent, 0);
}

TEST(Circle, IsExactlyCocircularAndDistinctForEveryLength) {
  for (const std::uint64_t n : {1, 2, 3, 4, 12, 13, 1000, 6804, 6805, 50000}) {
    const auto points = generate("circle", n);
    ASSERT_EQ(points.size(), n);
    const auto square = [](const Point2& p) { return wide(p[0]) * wide(p[0]) + wide(p[1]) * wide(p[1]); };
    for (const Point2& p : points) ASSERT_TRUE(square(p) == square(points[0])) << n;
    ASSERT_EQ(distinct(points), n);
  }
}

TEST(Circle, HasShortCoordinatesAsDocumented) {
  const auto longest = [](std::uint64_t n) {
    double most = 0;
    for (const Point2& p : generate("circle", n)) most = std::max({most, std::fabs(p[0]), std::fabs(p[1])});
    return most;
  };
  EXPECT_LT(longest(1620), 0x1p23);
  EXPECT_LT(longest(6804), 0x1p31);
}

TEST(Circle, EndsAtTheDocumentedCap) {
  const auto points = generate("circle", 1000000);
  EXPECT_EQ(points.size(), 393660U);
  EXPECT_EQ(distinct(points), points.size());
  for (const Point2& p : points)
    ASSERT_TRUE(wide(p[0]) * wide(p[0]) + wide(p[1]) * wide(p[1]) ==
                Wide{5105454762421325} * 5105454762421325);
}

TEST(NearCircle, IsWithinOneUnitButNotOnOneCircle) {
  std::set<Wide> squares;
  for (const Point2& p : generate("near-circle", 2000)) {
    squares.insert(wide(p[0]) * wide(p[0]) + wide(p[1]) * wide(p[1]));
    ASSERT_NEAR(std::hypot(p[0], p[1]), 0x1p26, 0.75);
  }
  EXPECT_GT(squares.size(), 1000U);
}

TEST(Collinear, IsExactlyOnOneLineAndDistinct) {
  const auto points = generate("collinear", 5000);
  for (const Point2& p : points) ASSERT_TRUE(orient(points[0], points[1], p) == 0);
  EXPECT_EQ(distinct(points), points.size());
  EXPECT_FALSE(std::is_sorted(points.begin(), points.end()));
}

TEST(NearCollinear, IsWithinThreeUlpsOfTheLineButNotOnOne) {
  const auto points = generate("near-collinear", 2000);
  int off = 0;
  for (const Point2& p : points) {
    const double ulps = (p[1] - std::sqrt(2.0) * p[0]) / (p[1] >= 2 ? 0x1p-51 : 0x1p-52);
    ASSERT_LE(std::fabs(ulps), 3);
    const auto integer = [](const Point2& q) { return Point2{{q[0] * 0x1p52, q[1] * 0x1p52}}; };
    off += orient(integer(points[0]), integer(points[1]), integer(p)) != 0 ? 1 : 0;
  }
  EXPECT_GT(off, 1900);
}

TEST(Duplicates, AreAboutRootNSitesEachMet) {
  for (const std::uint64_t n : {2, 3, 4, 100, 10000}) {
    const auto points = generate("duplicates", n);
    EXPECT_LT(distinct(points), n);
    EXPECT_LE(distinct(points), generators::square_side(n));
  }
  EXPECT_EQ(distinct(generate("duplicates", 10000)), 100U);
}

TEST(Spiral, EachPointLiesFartherOutThanAllBefore) {
  const auto points = generate("spiral", 20000);
  for (std::size_t i = 1; i < points.size(); ++i)
    ASSERT_GT(std::hypot(points[i][0], points[i][1]), std::hypot(points[i - 1][0], points[i - 1][1]));
  EXPECT_NEAR(std::hypot(points.back()[0], points.back()[1]), 20000, 1);
}

TEST(Kettner, IsTheUlpGridOfThePaperAndFoolsRoundedOrientation) {
  const auto points = generate("kettner", 65538);
  ASSERT_EQ(points.size(), 65538U);
  EXPECT_EQ(points[0], (Point2{{12, 12}}));
  EXPECT_EQ(points[1], (Point2{{24, 24}}));
  EXPECT_EQ(points[2], (Point2{{0.5, 0.5}}));
  EXPECT_EQ(points.back(), (Point2{{0.5 + 255 * 0x1p-53, 0.5 + 255 * 0x1p-53}}));
  EXPECT_EQ(distinct(points), points.size());
  // q and r lie on the diagonal: the exact sign is that of row - column. Rounded, far more vanish than the
  // 256 on it.
  int zeros = 0;
  for (const Point2& p : points) {
    const double determinant = (12 - p[0]) * (24 - p[1]) - (12 - p[1]) * (24 - p[0]);
    zeros += determinant == 0 ? 1 : 0;
  }
  EXPECT_GT(zeros, 1000);
}

TEST(MixedExponents, SpansTheRangeYetDegreeFourStaysInDoubles) {
  double least = 1;
  double most = 1;
  for (const Point2& p : generate("mixed-exponents", 2000)) {
    for (const double c : p.coordinate) {
      least = std::min(least, std::fabs(c));
      most = std::max(most, std::fabs(c));
    }
  }
  EXPECT_LT(least, 1e-29);
  EXPECT_GT(most, 1e29);
  EXPECT_TRUE(std::isfinite(16 * std::pow(2 * most, 4)));
  EXPECT_GE(std::pow(least, 4), std::numeric_limits<double>::min());
}

TEST(LawsonWorstCase, IsTwoStrictlyConvexFacingChains) {
  for (const std::uint64_t n : {4, 20, 400, 10000}) {
    const auto points = generate("lawson-worst-case", n);
    const std::size_t m = points.size() / 2;
    EXPECT_EQ(points.size(), std::min<std::uint64_t>(n, 7116));
    for (std::size_t i = 0; i + 2 < m; ++i) {
      ASSERT_TRUE(orient(points[i], points[i + 1], points[i + 2]) > 0);  // upper: convex downwards
      ASSERT_TRUE(orient(points[m + i], points[m + i + 1], points[m + i + 2]) < 0);  // lower: convex upwards
    }
    for (std::size_t i = 0; i < m; ++i) {
      ASSERT_GT(points[i][1], 0);
      ASSERT_EQ(points[m + i], (Point2{{points[i][0] + 1, -points[i][1]}}));
    }
    for (const Point2& p : points) ASSERT_TRUE(is_integer(p[0]) && is_integer(p[1]));
  }
}

}  // namespace
}  // namespace tribunal
