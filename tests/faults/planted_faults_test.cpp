// Who checks the checker: every planted fault is found, named by its kind and its simplices, and nothing else
// is named.
#include "tests/faults/agreement.hpp"
#include "tests/faults/plants.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tribunal::faults {
namespace {

using verify::FaultKind;

constexpr int meshes_per_fault = 100;

std::vector<Plant> all_plants() {
  std::vector<Plant> all;
  for (const auto plants : {triangle_plants(), point_plants(), sheet_plants()})
    all.insert(all.end(), plants.begin(), plants.end());
  return all;
}

verify::Verdict judge(const Planted& planted) {
  const verify::Mesh mesh{planted.triangles, planted.neighbours};
  return verify::verify_planar(as_points(planted.points), mesh, {verify::Kind::delaunay, 100000});
}

/// The planted fault is among those named; kinds that were neither planted nor to be foreseen are not.
void expect_named(const Planted& planted, const std::set<Finding>& found) {
  Kinds foreseen = planted.alongside;
  for (const Finding& expected : planted.expected) {
    EXPECT_TRUE(found.contains(expected)) << "not named: " << expected;
    foreseen.insert(expected.kind);
  }
  for (const Finding& f : found) EXPECT_TRUE(foreseen.contains(f.kind)) << "not foreseen: " << f;
}

class PlantedFault : public testing::TestWithParam<Plant> {};

TEST_P(PlantedFault, IsFoundAndNamed) {
  Random random(20);
  int planted_meshes = 0;
  for (std::uint32_t i = 0; planted_meshes < meshes_per_fault && i < 20 * meshes_per_fault; ++i) {
    const Sample sample = make_sample(i);
    const auto planted = GetParam().plant(sample, random);
    if (!planted) continue;
    ++planted_meshes;
    SCOPED_TRACE("sample " + std::to_string(i) + ", " + std::string(sample.family));
    const verify::Verdict verdict = judge(*planted);
    EXPECT_FALSE(verdict.valid());
    expect_named(*planted, findings(verdict));
    expect_agreement(planted->points, planted->triangles, verdict);
    if (HasFailure()) break;
  }
  if (!HasFailure()) {
    EXPECT_EQ(planted_meshes, meshes_per_fault) << "too few samples have a place for it";
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, PlantedFault, testing::ValuesIn(all_plants()),
                         [](const auto& test) { return std::string(test.param.name); });

// Every kind of fault that the checker knows is planted by something above.
TEST(PlantedFaults, CoverEveryKind) {
  Kinds planted_kinds;
  Random random(21);
  for (const Sample& sample : make_samples(3 * families))
    for (const Plant& plant : all_plants())
      if (const auto planted = plant.plant(sample, random))
        for (const Finding& f : planted->expected) planted_kinds.insert(f.kind);
  for (std::size_t kind = 0; kind < verify::fault_kinds_of_point_meshes; ++kind)
    EXPECT_TRUE(planted_kinds.contains(static_cast<FaultKind>(kind)))
        << to_string(static_cast<FaultKind>(kind));
}

}  // namespace
}  // namespace tribunal::faults
