#include "bench/outsider/timing.hpp"

#include "bench/fuzz/points_of.hpp"
#include "bench/measure.hpp"
#include "predicates/predicate.hpp"

#include <algorithm>
#include <cassert>
#include <variant>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr int most_passes = 7;
constexpr double enough_seconds = 0.02;  // a slow predicate is timed well by one pass

Sign ask(const Kernel2& kernel, Predicate predicate, const Point2* p) {
  return predicate == Predicate::orient2d ? kernel.orient2d(p[0], p[1], p[2])
                                          : kernel.incircle(p[0], p[1], p[2], p[3]);
}

Sign ask(const Kernel3& kernel, Predicate predicate, const Point3* p) {
  return predicate == Predicate::orient3d ? kernel.orient3d(p[0], p[1], p[2], p[3])
                                          : kernel.insphere(p[0], p[1], p[2], p[3], p[4]);
}

/// Seconds per query of each pass.
template <int D>
std::vector<double> time_passes(const auto& kernel, Predicate predicate,
                                const std::vector<Point<D>>& points) {
  const auto each = static_cast<std::size_t>(points_of(predicate));
  const std::size_t count = points.size() / each;
  const auto queries = static_cast<double>(count);
  std::vector<double> passes;
  double spent = 0;
  volatile int signs = 0;  // read by nobody, so that no query is left out
  while (passes.empty() || (spent < enough_seconds && passes.size() < most_passes)) {
    const double start = thread_seconds();
    int sum = 0;
    for (std::size_t i = 0; i < points.size(); i += each)
      sum += static_cast<int>(ask(kernel, predicate, points.data() + i));
    const double seconds = thread_seconds() - start;
    signs = sum;
    spent += seconds;
    passes.push_back(seconds / queries);
  }
  (void)signs;
  return passes;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double seconds_per_query(const PredicatePlugin& plugin, std::span<const fuzz::Case> cases) {
  assert(!cases.empty());
  const Predicate predicate = cases.front().predicate;
  if (dimension_of(predicate) == 2) {
    const auto points = fuzz::points_of_all<2>(cases);
    return median(time_passes(*std::get<0>(plugin.bind2(points)), predicate, points));
  }
  const auto points = fuzz::points_of_all<3>(cases);
  return median(time_passes(*std::get<0>(plugin.bind3(points)), predicate, points));
}

}  // namespace tribunal::bench
