#include "algorithms/data_dependent/searches.hpp"

#include "algorithms/data_dependent/roughness_criterion.hpp"
#include "datasets/random.hpp"

#include <cmath>
#include <optional>
#include <queue>
#include <vector>

namespace tribunal {
namespace {

FlipCounts descend(const RoughMesh& rough, std::uint64_t most_flips, std::vector<Index> edges) {
  RoughnessCriterion criterion(rough.roughness);
  FlipEngine engine(rough.sites, rough.mesh, criterion, most_flips);
  engine.flip_from_stack(std::move(edges));
  return engine.counts();
}

std::vector<Index> all_edges(const EdgeMesh& mesh) {
  std::vector<Index> edges(mesh.edges());
  for (Index edge = 0; edge < mesh.edges(); ++edge) edges[edge] = mesh.edges() - 1 - edge;
  return edges;
}

void add(FlipCounts& sum, const FlipCounts& counts) {
  sum.flips += counts.flips;
  sum.tests += counts.tests;
  sum.convexity_tests += counts.convexity_tests;
}

/// Edges by what they gain, each entry good until something near the edge flips.
class GainQueue {
 public:
  GainQueue(const RoughMesh& rough, FlipCounts& counts)
      : rough_(rough), counts_(counts), age_(rough.mesh.edges(), 0) {
    for (Index edge = 0; edge < rough.mesh.edges(); ++edge) renew(edge);
  }

  void renew(Index edge) {
    ++age_[edge];
    ++counts_.convexity_tests;
    if (!rough_.is_flippable(edge)) return;
    ++counts_.tests;
    const Roughness::Change change = rough_.roughness.change_by_flip(rough_.mesh, edge);
    if (change.is_better()) entries_.push({change.gain(), edge, age_[edge]});
  }

  /// The edge with the largest gain, of equal ones that with the smallest name; nothing where none gains.
  std::optional<Index> best() {
    while (!entries_.empty()) {
      const Entry top = entries_.top();
      entries_.pop();
      if (top.age == age_[top.edge]) return top.edge;
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    double gain;
    Index edge;
    std::uint64_t age;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.gain != b.gain ? a.gain < b.gain : a.edge > b.edge;
    }
  };

  const RoughMesh& rough_;
  FlipCounts& counts_;
  std::vector<std::uint64_t> age_;
  std::priority_queue<Entry> entries_;
};

/// Flips the edge and then the one near it with which that gains most, where the two gain together, and
/// returns the edges near both; else leaves the mesh as it was and returns nothing.
std::vector<Index> flip_pair(const RoughMesh& rough, Index edge, FlipCounts& counts) {
  ++counts.convexity_tests;
  if (!rough.is_flippable(edge)) return {};
  const Roughness::Change first = rough.roughness.change_by_flip(rough.mesh, edge);
  rough.mesh.flip(edge);
  std::optional<Index> partner;
  double best = 0;
  visit_suspects<RoughnessCriterion::reach>(rough.mesh, edge, [&](Index near) {
    if (!rough.is_flippable(near)) return;
    ++counts.tests;
    const Roughness::Change second = rough.roughness.change_by_flip(rough.mesh, near);
    const Roughness::Change both{first.before + second.before, first.after + second.after};
    if (!both.is_better() || !(both.gain() > best)) return;
    best = both.gain();
    partner = near;
  });
  if (!partner) {
    rough.mesh.flip(edge);
    return {};
  }
  rough.mesh.flip(*partner);
  counts.flips += 2;
  std::vector<Index> changed;
  for (const Index flipped : {edge, *partner})
    visit_suspects<RoughnessCriterion::reach>(rough.mesh, flipped,
                                              [&](Index near) { changed.push_back(near); });
  return changed;
}

}  // namespace

FlipCounts flip_best_first(const RoughMesh& rough, std::uint64_t most_flips) {
  FlipCounts counts;
  GainQueue queue(rough, counts);
  Budget budget(most_flips, "flipping");
  while (const auto edge = queue.best()) {
    budget.spend();
    rough.mesh.flip(*edge);
    ++counts.flips;
    queue.renew(*edge);
    visit_suspects<RoughnessCriterion::reach>(rough.mesh, *edge, [&](Index near) { queue.renew(near); });
  }
  return counts;
}

FlipCounts flip_looking_ahead(const RoughMesh& rough, std::uint64_t most_flips) {
  FlipCounts counts = descend(rough, most_flips, all_edges(rough.mesh));
  Budget budget(most_flips, "flipping");
  for (bool found = true; found;) {
    found = false;
    for (Index edge = 0; edge < rough.mesh.edges(); ++edge) {
      std::vector<Index> changed = flip_pair(rough, edge, counts);
      if (changed.empty()) continue;
      budget.spend();
      found = true;
      add(counts, descend(rough, most_flips, std::move(changed)));
    }
  }
  return counts;
}

FlipCounts anneal(const RoughMesh& rough, std::uint64_t most_flips, const Cooling& cooling) {
  FlipCounts counts;
  Random random(cooling.seed);
  double sum = 0, flippable = 0;
  for (Index edge = 0; edge < rough.mesh.edges(); ++edge)
    if (rough.is_flippable(edge)) {
      const double change = std::fabs(rough.roughness.change_by_flip(rough.mesh, edge).gain());
      if (!std::isfinite(change)) continue;
      sum += change;
      ++flippable;
    }
  double temperature = flippable > 0 ? 2 * sum / flippable : 0;
  for (int k = 0; k < cooling.temperatures && temperature > 0; ++k, temperature *= cooling.factor)
    for (std::uint64_t tries = cooling.tries_per_edge * rough.mesh.edges(); tries > 0; --tries) {
      const auto edge = static_cast<Index>(random.below(rough.mesh.edges()));
      const double draw = random.unit();
      ++counts.convexity_tests;
      if (!rough.is_flippable(edge)) continue;
      ++counts.tests;
      const double loss = -rough.roughness.change_by_flip(rough.mesh, edge).gain();
      if (!std::isfinite(loss) || !(loss < 0 || draw < std::exp(-loss / temperature))) continue;
      rough.mesh.flip(edge);
      ++counts.flips;
    }
  add(counts, descend(rough, most_flips, all_edges(rough.mesh)));
  return counts;
}

}  // namespace tribunal
