#include "algorithms/greedy/from_pool.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/greedy/domain.hpp"
#include "algorithms/greedy/length_order.hpp"

#include <algorithm>
#include <string>

namespace tribunal {
namespace {

std::vector<Candidate> ordered_pool(const PlanarProblem& problem) {
  const LengthOrder order(problem);
  std::vector<Candidate> pool;
  const std::size_t n = problem.sites.size();
  pool.reserve(n * (n - 1) / 2);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      pool.push_back(order.candidate(problem.sites[i], problem.sites[j]));
  order.sort(pool);
  return pool;
}

bool passes_through_a_site(const PlanarProblem& problem, const Edge& edge) {
  const Point2 &a = problem.points[edge[0]], &b = problem.points[edge[1]];
  return std::any_of(problem.sites.begin(), problem.sites.end(), [&](Index site) {
    const Point2& c = problem.points[site];
    return strictly_between(a, c, b) && problem.kernel.orient2d(a, b, c) == Sign::zero;
  });
}

void insert_given(const PlanarProblem& problem, std::span<const Edge> given, AcceptedEdges& accepted,
                  std::vector<Edge>& edges) {
  for (const Edge& edge : given) {
    const Edge ends = undirected(edge[0], edge[1]);
    // An edge may be given more than once: as a constraint on the boundary, or in both directions.
    if (std::find(edges.begin(), edges.end(), ends) != edges.end()) continue;
    if (accepted.conflicts(ends) || passes_through_a_site(problem, ends))
      throw Abandon(Outcome::refused_input, "the given edge " + std::to_string(edge[0]) + "-" +
                                                std::to_string(edge[1]) +
                                                " meets a site or another given edge");
    accepted.insert(ends);
    edges.push_back(ends);
  }
}

/// Length of one of the two chains of the hull between its first and last site in lexicographic order, its
/// last site not counted.
template <class Iterator>
std::size_t chain_length(const PlanarProblem& problem, Iterator first, Iterator last) {
  const auto& p = problem.points;
  std::vector<Index> chain;
  for (; first != last; ++first) {
    while (chain.size() >= 2 &&
           problem.kernel.orient2d(p[chain.end()[-2]], p[chain.back()], p[*first]) == Sign::negative)
      chain.pop_back();
    chain.push_back(*first);
  }
  return chain.size() - 1;
}

}  // namespace

void require_pool(const PlanarProblem& problem) {
  if (problem.sites.size() > most_pooled_sites)
    throw Abandon(Outcome::refused_input, "all pairs of more than " + std::to_string(most_pooled_sites) +
                                              " sites are too many to store");
}

std::size_t hull_size(const PlanarProblem& problem) {
  std::vector<Index> sites(problem.sites.begin(), problem.sites.end());
  std::sort(sites.begin(), sites.end(),
            [&](Index a, Index b) { return problem.points[a] < problem.points[b]; });
  return chain_length(problem, sites.begin(), sites.end()) +
         chain_length(problem, sites.rbegin(), sites.rend());
}

GreedyEdges triangulate_from_pool(const GreedyProblem& problem, AcceptedEdges& accepted) {
  require_pool(problem.planar);
  const std::size_t n = problem.planar.sites.size();
  const bool convex = problem.boundary.empty();
  const std::size_t enough = convex ? 3 * n - 3 - hull_size(problem.planar) : 0;
  const Domain domain(problem);
  GreedyEdges result;
  insert_given(problem.planar, problem.boundary, accepted, result.edges);
  insert_given(problem.planar, problem.constraints, accepted, result.edges);
  std::vector<Edge> given = result.edges;
  std::sort(given.begin(), given.end());
  for (const Candidate& candidate : ordered_pool(problem.planar)) {
    if (convex && result.edges.size() == enough) break;
    if (std::binary_search(given.begin(), given.end(), candidate.ends)) continue;
    ++result.candidates;
    if (!domain.admits(candidate.ends) || accepted.conflicts(candidate.ends)) continue;
    accepted.insert(candidate.ends);
    result.edges.push_back(candidate.ends);
  }
  if (convex && result.edges.size() != enough)
    throw Abandon(Outcome::inconsistent_predicate,
                  "the candidates ran out before Euler's formula was satisfied");
  return result;
}

}  // namespace tribunal
