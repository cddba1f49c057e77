// A triangulator on trial: every dataset, each mesh checked exactly.
#pragma once

#include "bench/outsider/finding.hpp"
#include "bench/outsider/triangulator.hpp"
#include "datasets/dataset.hpp"
#include "predicates/point.hpp"

#include <span>

namespace tribunal::bench {

/// Has each dataset triangulated, at sizes from one point to options.points, each in a child of its own, up
/// to the first failure; meshes are normalised and checked exactly in this process. A failure is cut down to
/// few points. After three hangs the rest is left untried.
TrialResult try_triangulator(const Triangulator& triangulator, std::span<const Dataset> datasets,
                             const TrialOptions& options, const Watcher& watcher);

/// The user's points alone.
TrialResult try_points(const Triangulator& triangulator, std::span<const Point2> points,
                       const TrialOptions& options);

}  // namespace tribunal::bench
