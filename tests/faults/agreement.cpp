#include "tests/faults/agreement.hpp"

#include <gtest/gtest.h>

namespace tribunal::faults {

std::set<Finding> findings(const verify::Verdict& verdict) {
  std::set<Finding> found;
  for (const verify::Fault& fault : verdict.faults) found.insert(finding(fault));
  return found;
}

void expect_agreement(const std::vector<LatticePoint>& points, const std::vector<Triangle>& triangles,
                      const verify::Verdict& verdict) {
  std::set<Finding> found = findings(verdict);
  EXPECT_EQ(found.size(), verdict.found) << "a fault is named twice";
  std::erase_if(found, [](const Finding& f) { return !naive_kinds().contains(f.kind); });
  const std::set<Finding> naive = naive_findings(points, triangles);
  for (const Finding& f : naive) EXPECT_TRUE(found.contains(f)) << "missed: " << f;
  for (const Finding& f : found) EXPECT_TRUE(naive.contains(f)) << "false alarm: " << f;

  bool crossing = false;
  for (const verify::Fault& fault : verdict.faults) {
    for (const std::uint32_t t : fault.simplices) EXPECT_LT(t, triangles.size()) << fault.detail;
    if (fault.kind != verify::FaultKind::crossing_edges) continue;
    crossing = true;
    EXPECT_TRUE(is_overlap(points, fault.points)) << fault.detail;
    EXPECT_FALSE(fault.simplices.empty());
  }
  EXPECT_EQ(crossing, naive_overlap(points, triangles));
}

}  // namespace tribunal::faults
