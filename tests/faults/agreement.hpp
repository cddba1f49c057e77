// The verdict against the naive checker's: both name the same faults.
#pragma once

#include "tests/faults/naive_checker.hpp"

#include <set>
#include <vector>

namespace tribunal::faults {

/// The faults of a verdict.
std::set<Finding> findings(const verify::Verdict& verdict);

/// For a verdict that kept all its faults, on points that are not all collinear: of the kinds that the naive
/// checker decides both name the same, no fault is named twice, and a crossing is named just when there is
/// one and is one.
void expect_agreement(const std::vector<LatticePoint>& points, const std::vector<Triangle>& triangles,
                      const verify::Verdict& verdict);

}  // namespace tribunal::faults
