// Experiment `scopes`: the expected tau of a point set, exactly, from the scopes of its circles.
//
// T_j is the number of triples whose open circumdisk (scope) holds j of the N sites. A triple becomes a
// triangle, at the moment its last corner is inserted, if its corners come before the sites in its scope, so
// that over uniformly random orders
//     E[tau] = sum_{j=0}^{N-3} P(j) T_j,   P(j) = 3! j! / (j+3)! = 6 / ((j+1)(j+2)(j+3)).
// By brute force over triples, N^4 / 24 circle tests: at most 60 distinct sites, else `refused_input`.
//
// Counters: `T.0` ..., `tau_expected`, `tau_bound` = 6N - 15 H_N + 21/2 (Barth, eq. 3.3.0), `sites`, `hull`;
// `collinear` triples and `cocircular` quadruples seen (a quadruple counts once for each of its triples).
// Where both are zero:
// - `residual_reflection`: max_j |T_j + T_{N-3-j} - 2(j+1)(N-2-j)| is 0;
// - `residual_sets`: max_j |T_j - (j+1)(2N-j-2) + sum_{i=1}^{j+1} S_i| is 0, S_i the directed pairs with
//   i-1 sites on their right;
// - `residual_ends`: |T_0 - (2N-2-h)| + |T_{N-3} - (h-2)| is 0;
// - `violations_upper`: the j <= N/3 - 1 with T_j > (j+1)(2N - 5j/2 - 5) are none.
#include "bench/experiments/listed.hpp"
#include "bench/experiments/tau_bound.hpp"
#include "bench/input.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tribunal::bench {
namespace {

constexpr std::size_t most_sites = 60;

/// The sites with their kernel: what is counted below depends on signs alone.
struct Sites {
  std::span<const Point2> points;
  const Kernel2& kernel;
  std::size_t size() const { return points.size(); }
};

struct Scopes {
  std::vector<double> t;  ///< T_j
  double collinear = 0, cocircular = 0;
};

Scopes count_scopes(const Sites& sites) {
  const std::size_t n = sites.size();
  const auto& p = sites.points;
  Scopes scopes{std::vector<double>(n - 2, 0.0)};
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c) {
        const Sign turn = sites.kernel.orient2d(p[a], p[b], p[c]);
        if (turn == Sign::zero) {
          ++scopes.collinear;
          continue;
        }
        std::size_t inside = 0;
        for (std::size_t d = 0; d < n; ++d) {
          if (d == a || d == b || d == c) continue;
          const Sign side = turn * sites.kernel.incircle(p[a], p[b], p[c], p[d]);
          inside += side == Sign::positive;
          scopes.cocircular += side == Sign::zero;
        }
        ++scopes.t[inside];
      }
  return scopes;
}

/// S[r]: directed pairs with just r sites on their right; S[0] counts the hull's edges.
std::vector<double> count_sets(const Sites& sites) {
  const std::size_t n = sites.size();
  const auto& p = sites.points;
  std::vector<double> sets(n, 0.0);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      if (a == b) continue;
      std::size_t right = 0;
      for (std::size_t c = 0; c < n; ++c)
        right += c != a && c != b && sites.kernel.orient2d(p[a], p[b], p[c]) == Sign::negative;
      ++sets[right];
    }
  return sets;
}

void check_identities(const std::vector<double>& t, const std::vector<double>& sets,
                      std::map<std::string, double>& counters) {
  const auto n = static_cast<double>(sets.size());
  const double hull = sets[0];
  double reflection = 0, by_sets = 0, violations = 0, sum_of_sets = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const auto j = static_cast<double>(i);
    sum_of_sets += sets[i];
    reflection = std::max(reflection, std::abs(t[i] + t[t.size() - 1 - i] - 2 * (j + 1) * (n - 2 - j)));
    by_sets = std::max(by_sets, std::abs(t[i] - (j + 1) * (2 * n - j - 2) + sum_of_sets));
    if (3 * (j + 1) <= n) violations += t[i] > (j + 1) * (2 * n - 2.5 * j - 5);
  }
  counters["hull"] = hull;
  counters["residual_reflection"] = reflection;
  counters["residual_sets"] = by_sets;
  counters["residual_ends"] = std::abs(t.front() - (2 * n - 2 - hull)) + std::abs(t.back() - (hull - 2));
  counters["violations_upper"] = violations;
}

double expected_tau(const std::vector<double>& t) {
  double sum = 0;
  for (std::size_t i = t.size(); i-- > 0;) {
    const auto j = static_cast<double>(i);
    sum += 6 * t[i] / ((j + 1) * (j + 2) * (j + 3));
  }
  return sum;
}

Finding run_scopes(const Cell& cell) {
  const std::vector<Point2> points = distinct_points(cell_points(cell));
  if (points.size() < 3 || points.size() > most_sites)
    return {Outcome::refused_input, "scopes are counted of 3 to " + std::to_string(most_sites) +
                                        " distinct sites, not " + std::to_string(points.size())};
  const Kernel2Binding binding = cell_kernel(points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Sites sites{points, *std::get<0>(binding)};

  Finding finding;
  const Scopes scopes = count_scopes(sites);
  for (std::size_t j = 0; j < scopes.t.size(); ++j) finding.counters["T." + std::to_string(j)] = scopes.t[j];
  finding.counters["sites"] = static_cast<double>(sites.size());
  finding.counters["collinear"] = scopes.collinear;
  finding.counters["cocircular"] = scopes.cocircular;
  finding.counters["tau_expected"] = expected_tau(scopes.t);
  finding.counters["tau_bound"] = tau_bound(sites.size());
  check_identities(scopes.t, count_sets(sites), finding.counters);
  return finding;
}

}  // namespace

constinit const Experiment scopes_experiment{
    .name = "scopes",
    .cites = "Guibas, Knuth, Sharir 1992",
    .summary =
        "expected tau over all insertion orders, exactly, from the number of sites in every circumcircle",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = {},
    .run = run_scopes,
};

}  // namespace tribunal::bench
