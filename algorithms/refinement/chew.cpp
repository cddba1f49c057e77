#include "algorithms/refinement/chew.hpp"

#include "algorithms/refinement/small_angles.hpp"

#include <algorithm>
#include <queue>
#include <set>
#include <vector>

namespace tribunal::refinement {
namespace {

/// A triangle that failed, by its place and its corners: it is gone when the place holds others.
struct Failed {
  double radius;
  Triangle corners;
  Index place;

  friend bool operator<(const Failed& a, const Failed& b) {
    return a.radius != b.radius ? a.radius < b.radius : a.corners < b.corners;
  }
};

class Chew {
 public:
  Chew(SteinerMesh& mesh, const ChewOptions& options, ChewCounts& counts)
      : mesh_(mesh),
        options_(options),
        counts_(counts),
        size_(options.size, mesh),
        small_(mesh, options.bound) {
    counts_.small_input_angles = small_.below_bound();
  }

  void run() {
    for (Index t = 0; t < mesh_.triangles().triangles(); ++t)
      if (mesh_.in_domain(t)) measure(t);
    while (!heap_.empty()) {
      const Failed worst = heap_.top();
      heap_.pop();
      if (mesh_.triangles().triangle(worst.place) != worst.corners) {
        ++counts_.stale;
        continue;
      }
      require_room();
      if (!improve(worst.place))
        ++counts_.unresolved;
      else if (mesh_.triangles().triangle(worst.place) == worst.corners)
        measure(worst.place);  // an edge was split that is too long for the triangle to have noticed
    }
    counts_.steps = mesh_.steps();
    for (Index t = 0; t < mesh_.triangles().triangles(); ++t)
      counts_.forced +=
          mesh_.in_domain(t) && is_sharper(mesh_.corners(t), options_.bound) && small_.forces(mesh_, t);
  }

 private:
  void require_room() const {
    if (mesh_.vertices() < options_.most_vertices) return;
    throw Abandon(Outcome::refused_input,
                  std::string(options_.measure == nullptr ? "size and angle" : "size, angle and field") +
                      " would take more than the " + std::to_string(options_.most_vertices) +
                      " vertices that are allowed");
  }

  void measure(Index t) {
    ++counts_.tests;
    const Corners corners = mesh_.corners(t);
    const auto edges = edge_lengths(corners);
    const bool large = *std::max_element(edges.begin(), edges.end()) > size_.limit(mesh_, t) ||
                       (options_.measure != nullptr && options_.measure->fails(mesh_, t));
    if (!large && !is_sharper(corners, options_.bound)) return;
    if (!large && small_.forces(mesh_, t)) return;
    heap_.push({circumradius(corners), mesh_.triangles().triangle(t), t});
  }

  /// One round of the algorithm's steps 3 to 6. False where the triangle has to stay.
  bool improve(Index t) {
    const Point2 centre = admitted(mesh_.corners(t));
    const Sighting seen = mesh_.look(t, centre);
    if (seen.kind == Sighting::Kind::at_vertex) return false;
    if (mesh_.mesh().held(seen.at) && seen.kind != Sighting::Kind::inside) return split(seen.at);
    const double length = size_.interpolate(mesh_, triangle_of(seen.at), centre);
    const Index vertex = mesh_.insert(centre, seen);
    size_.add(vertex, length);
    ++counts_.circumcentres;
    mesh_.for_star(vertex, [&](Index s) { measure(s); });
    return true;
  }

  bool split(HalfEdge h) {
    const Edge ends{mesh_.triangles().from(h), mesh_.triangles().to(h)};
    const double place = small_.place_to_split(mesh_, h);
    std::vector<Index> changed;
    auto vertex = mesh_.split(h, place);
    if (!vertex && cleared_.insert(ends).second) {  // once, lest they come back for ever
      clear_sides(ends, changed);
      vertex = mesh_.split(mesh_.mesh().edge(ends[0], ends[1]), place);
    }
    if (vertex) {
      ++counts_.splits;
      small_.note_split(mesh_, ends, *vertex);
      size_.add(*vertex, size_.between(ends[0], ends[1]));
      clear_around(*vertex, ends, changed);
      mesh_.for_star(*vertex, [&](Index t) { changed.push_back(t); });
    } else {
      ++counts_.refused_splits;
    }
    measure_all(changed);
    return vertex.has_value();
  }

  /// Deletes a circumcentre that rounding put so close to an edge that no place to split it is left. After
  /// the split it would go anyway.
  void clear_sides(Edge ends, std::vector<Index>& changed) {
    for (const auto& [from, to] : {ends, Edge{ends[1], ends[0]}}) {
      const HalfEdge side = mesh_.mesh().edge(from, to);
      if (!mesh_.in_domain(triangle_of(side))) continue;
      const Index corner = mesh_.triangles().corner(side);
      if (mesh_.role(corner) == Role::free) remove(corner, changed);
    }
  }

  /// Deletes circumcentres that are closer to the new vertex of a split edge than the nearer of its ends.
  void clear_around(Index vertex, Edge ends, std::vector<Index>& changed) {
    const Point2 p = mesh_.point(vertex);
    const bool first = mesh_.mesh().kernel().compare_length(p, mesh_.point(ends[0]), p,
                                                            mesh_.point(ends[1])) != Sign::positive;
    for (const Index v : deletable_around(vertex, ends[first ? 0 : 1])) remove(v, changed);
  }

  /// What lies closer to `centre` than `end`, can be deleted, and is seen from it past other such vertices.
  std::vector<Index> deletable_around(Index centre, Index end) {
    std::vector<Index> found;
    seen_.resize(mesh_.mesh().vertices(), 0);
    const auto look_around = [&](Index from) {
      mesh_.for_star(from, [&](Index t) {
        for (const Index v : mesh_.triangles().triangle(t)) {
          if (mesh_.role(v) != Role::free || seen_[v] != 0) continue;
          if (mesh_.mesh().kernel().compare_length(mesh_.point(centre), mesh_.point(v), mesh_.point(centre),
                                                   mesh_.point(end)) != Sign::negative)
            continue;
          seen_[v] = 1;
          found.push_back(v);
        }
      });
    };
    look_around(centre);
    for (std::size_t i = 0; i < found.size(); ++i) look_around(found[i]);
    for (const Index v : found) seen_[v] = 0;
    return found;
  }

  void remove(Index vertex, std::vector<Index>& changed) {
    const std::vector<Index> filled = mesh_.remove(vertex);
    changed.insert(changed.end(), filled.begin(), filled.end());
    ++counts_.deleted;
  }

  void measure_all(std::vector<Index>& changed) {
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const Index t : changed)
      if (mesh_.in_domain(t)) measure(t);
  }

  /// The circumcentre; where the kernel does not admit one far away, the last point on the way to it that it
  /// does. The domain ends before that, so that a held edge is met all the same.
  Point2 admitted(const Corners& corners) const {
    const Point2 centre = circumcentre(corners);
    const Kernel2& kernel = mesh_.mesh().kernel();
    if (kernel.admits(centre)) return centre;
    const auto [a, b, c] = corners;
    const Point2 inside{{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3}};
    Point2 best = inside;
    double low = 0, high = 1;
    for (int halvings = 0; halvings < 100; ++halvings) {
      const double s = low + (high - low) / 2;
      const Point2 p{{inside[0] + s * (centre[0] - inside[0]), inside[1] + s * (centre[1] - inside[1])}};
      const bool good = kernel.admits(p);
      (good ? low : high) = s;
      if (good) best = p;
    }
    return best;
  }

  SteinerMesh& mesh_;
  const ChewOptions& options_;
  ChewCounts& counts_;
  SizeField size_;
  SmallAngles small_;
  std::priority_queue<Failed> heap_;
  std::set<Edge> cleared_;  // held edges whose sides were cleared
  std::vector<char> seen_;  // of each vertex, while deletable_around runs
};

}  // namespace

ChewCounts refine_mesh(SteinerMesh& mesh, const ChewOptions& options) {
  ChewCounts counts;
  Chew(mesh, options, counts).run();
  return counts;
}

Refinement refine_by_circumcentres(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                                   const ChewOptions& options) {
  Refinement result;
  constrained::report_refusals(result.report, [&] {
    SteinerMesh mesh(graph, order, kernel);
    result.counts = refine_mesh(mesh, options);
    result.mesh = mesh.result();
  });
  return result;
}

}  // namespace tribunal::refinement
