// What is read from the user's system: left out of "all", found by name, and either missing, which it says,
// or a domain.
#include "datasets/external/external.hpp"

#include "datasets/files/files.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace tribunal {
namespace {

class EveryExternalDataset : public ::testing::TestWithParam<ExternalDataset> {
 protected:
  void TearDown() override { ::unsetenv("TRIBUNAL_GSHHG"); }
};

TEST_P(EveryExternalDataset, IsFoundByNameAndNotAmongAll) {
  const DatasetAbout& about = GetParam().dataset.about;
  const Dataset* found = find_dataset(about.name);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->generate, GetParam().dataset.generate);
  EXPECT_FALSE(about.cites.empty());
  EXPECT_LE(about.summary.size(), 90U);
  EXPECT_GT(about.fixed_size, 0U);
  for (const Dataset& dataset : datasets()) EXPECT_NE(dataset.about.name, about.name);
}

TEST_P(EveryExternalDataset, SaysWhatToInstall) {
  const test::Folder empty;
  ::setenv("TRIBUNAL_GSHHG", (empty / "").c_str(), 1);
  const std::string missing = GetParam().missing();
  EXPECT_NE(missing.find("install"), std::string::npos) << missing;
  EXPECT_NE(missing.find("gmt-gshhg-"), std::string::npos) << missing;
  EXPECT_EQ(missing_for(GetParam().dataset.about.name), missing);
  try {
    GetParam().dataset.generate(10, 1);
    FAIL() << "made of nothing";
  } catch (const BadInput& error) {
    EXPECT_EQ(error.what(), std::string(GetParam().dataset.about.name) + ": " + missing);
  }
}

TEST_P(EveryExternalDataset, IsADomainOfItsSizeWhereItIsThere) {
  const auto& [about, generate, graph] = GetParam().dataset;
  if (!GetParam().missing().empty()) {
    EXPECT_THROW(graph(1, 1), BadInput);
    return;
  }
  const DatasetGraph sea = graph(1, 1);
  EXPECT_EQ(sea.points.size(), about.fixed_size);
  EXPECT_EQ(test::distinct(sea.points), sea.points.size());
  EXPECT_EQ(generate(100, 1), std::vector(sea.points.begin(), sea.points.begin() + 100));
  std::map<std::uint32_t, int> degree;
  for (const auto& [a, b] : sea.segments) ++degree[a], ++degree[b];
  for (const auto& [vertex, count] : degree) ASSERT_EQ(count % 2, 0) << vertex;
  EXPECT_GT(sea.holes.size(), 100U);
  for (const Point2& p : sea.points)
    for (const double c : p.coordinate) ASSERT_EQ(std::ldexp(c, 33), std::floor(std::ldexp(c, 33)));
}

/// In steps of the lattice of `gulf`, a tenth of a kilometre: from each point of its shore the way to this
/// one.
TEST_P(EveryExternalDataset, LiesOverGulf) {
  const auto& [about, generate, graph] = GetParam().dataset;
  if (!GetParam().missing().empty()) {
    EXPECT_THROW(generate(1, 1), BadInput);
    return;
  }
  const DatasetGraph sea = graph(1, 1);
  std::vector<double> distances;
  for (const Point2& p : find_dataset("gulf")->generate(820, 1)) {
    double least = 1e300;
    for (const auto& [i, j] : sea.segments) {
      const Point2 &a = sea.points[i], &b = sea.points[j];
      const double x = b[0] - a[0], y = b[1] - a[1],
                   t = std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y), 0.0, 1.0);
      const double dx = p[0] - a[0] - t * x, dy = p[1] - a[1] - t * y;
      least = std::min(least, dx * dx + dy * dy);
    }
    distances.push_back(std::sqrt(least));
  }
  std::ranges::sort(distances);
  RecordProperty("median", std::to_string(distances[410]));
  EXPECT_LT(distances[410], 25);
  EXPECT_LT(distances[700], 120);
}

INSTANTIATE_TEST_SUITE_P(List, EveryExternalDataset,
                         ::testing::ValuesIn(external_datasets().begin(), external_datasets().end()),
                         [](const auto& entry) {
                           std::string name(entry.param.dataset.about.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(ExternalDatasets, NothingIsMissingForOthers) {
  EXPECT_EQ(missing_for("uniform"), "");
  EXPECT_EQ(missing_for("no such dataset"), "");
}

}  // namespace
}  // namespace tribunal
