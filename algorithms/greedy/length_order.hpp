// Candidates for edges and their exact order: by length, ties by their ends.
#pragma once

#include "algorithms/greedy/problem.hpp"

#include <algorithm>
#include <vector>

namespace tribunal {

/// A segment between two sites.
struct Candidate {
  double key;  ///< its squared length, rounded
  Edge ends;   ///< the smaller index first
};

// Let u = 2^-53. The rounded key K of a squared length L takes two differences, two squares and a sum: |K -
// L| <= 4u L (1 + O(u)) where nothing underflows, and underflow adds 2^-1074 at most. Hence K (1 + 16u) < K'
// with K' >= 2^-960 proves L < L', K = 0 included; an infinite K' stands for a length near the end of the
// range, and then K (1 + 16u) may not be infinite, too.

/// The order in which a greedy method takes candidates. Exact where the kernel is: rounded keys decide what
/// they prove, the kernel the rest.
class LengthOrder {
 public:
  explicit LengthOrder(const PlanarProblem& problem) : problem_(problem) {}

  Candidate candidate(Index a, Index b) const {
    const Point2 &p = problem_.points[a], &q = problem_.points[b];
    const double x = p[0] - q[0], y = p[1] - q[1];
    return {x * x + y * y, undirected(a, b)};
  }

  /// A strict order of all pairs of sites.
  bool operator()(const Candidate& left, const Candidate& right) const {
    if (certainly_shorter(left, right)) return true;
    if (certainly_shorter(right, left)) return false;
    const Sign sign = left.ends == right.ends ? Sign::zero : compare(left.ends, right.ends);
    return sign == Sign::zero ? left.ends < right.ends : sign == Sign::negative;
  }

  /// Sorts by keys, then exactly within the runs whose keys leave the order open. O(m log m), of which the
  /// kernel is asked about close keys only.
  void sort(std::vector<Candidate>& candidates) const {
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& left, const Candidate& right) {
      return left.key != right.key ? left.key < right.key : left.ends < right.ends;
    });
    for (auto run = candidates.begin(); run != candidates.end();) {
      auto end = run + 1;
      while (end != candidates.end() && !certainly_shorter(*(end - 1), *end)) ++end;
      // Not std::sort: it may leave its range when a kernel's wrong signs contradict one another.
      if (end - run > 1) std::stable_sort(run, end, *this);
      run = end;
    }
  }

 private:
  static bool certainly_shorter(const Candidate& left, const Candidate& right) {
    return left.key * (1 + 0x1p-49) < right.key && right.key >= 0x1p-960;
  }
  Sign compare(const Edge& left, const Edge& right) const {
    const auto& p = problem_.points;
    return problem_.kernel.compare_length(p[left[0]], p[left[1]], p[right[0]], p[right[1]]);
  }

  const PlanarProblem& problem_;
};

}  // namespace tribunal
