#include "algorithms/stretching/stretched.hpp"

#include "algorithms/refinement/domain_mesh.hpp"
#include "algorithms/refinement/sight.hpp"
#include "algorithms/stretching/guides.hpp"
#include "algorithms/stretching/min_max_insertion.hpp"
#include "algorithms/stretching/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tribunal::stretching {
namespace {
using constrained::GraphMesh;
using refinement::Sighting;

/// Squares of lengths are compared, and their products.
void require_usual_size(const Graph& graph) {
  double extent = 0;
  for (const Point2& p : graph.points)
    for (std::size_t axis = 0; axis < 2; ++axis)
      extent = std::max(extent, std::fabs(p[axis] - graph.points[0][axis]));
  if (!(0x1p-200 < extent && extent < 0x1p200))
    throw Abandon(Outcome::refused_input,
                  "the domain is smaller than 2^-200 or larger than 2^200: scale it by a power of two");
}

constrained::GraphMesh build(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                             const Options& options) {
  if (const std::string reason = options.spacing.refuse(); !reason.empty())
    throw Abandon(Outcome::refused_input, reason);
  require_usual_size(graph);
  return refinement::build_domain_mesh(graph, order, kernel);
}

/// A place for a new vertex that passes, and where it is seen.
struct Candidate {
  Step step;
  Point2 place;
  Sighting seen;
};

class Run {
 public:
  Run(const Graph& graph, GraphMesh built, const Options& options)
      : options_(options),
        graph_(graph),
        built_(std::move(built)),
        mesh_(built_.mesh),
        insertion_(mesh_),
        guides_(mesh_, options.spacing, options.walls),
        low_(corner<0>(graph.points)),
        high_(corner<1>(graph.points)),
        tree_(low_, high_),
        stamps_(mesh_.triangles().triangles(), 0) {
    for (Index v = 0; v < mesh_.vertices(); ++v) tree_.insert(mesh_.point(v));
    for (Index t = 0; t < mesh_.triangles().triangles(); ++t) consider(t);
  }

  Stretched run() {
    while (!failing_.empty()) {
      const Failing worst = failing_.front();
      std::pop_heap(failing_.begin(), failing_.end());
      failing_.pop_back();
      if (is_current(worst)) refine(worst.triangle);
    }
    insertion_.swap_anew();
    return result();
  }

 private:
  struct Failing {
    double measure;
    Index triangle;
    std::uint32_t stamp;
    friend bool operator<(const Failing& a, const Failing& b) {
      return std::pair(a.measure, b.triangle) < std::pair(b.measure, a.triangle);
    }
  };

  /// The least or largest coordinates.
  template <int which>
  static Point2 corner(std::span<const Point2> points) {
    Point2 found = points[0];
    for (const Point2& p : points)
      for (std::size_t axis = 0; axis < 2; ++axis)
        found[axis] = which == 0 ? std::min(found[axis], p[axis]) : std::max(found[axis], p[axis]);
    return found;
  }

  bool in_box(Point2 p) const {
    return low_[0] <= p[0] && p[0] <= high_[0] && low_[1] <= p[1] && p[1] <= high_[1];
  }

  /// Puts a triangle that fails into the heap.
  void consider(Index t) {
    if (!mesh_.inside(t)) return;
    const double measure = guides_.measure(mesh_, t);
    if (measure <= 1) return;
    // Layers of equal height change the triangles around them again and again.
    if (failing_.size() > 2 * stamps_.size()) {
      std::erase_if(failing_, [this](const Failing& f) { return !is_current(f); });
      std::make_heap(failing_.begin(), failing_.end());
    }
    failing_.push_back({measure, t, stamps_[t]});
    std::push_heap(failing_.begin(), failing_.end());
  }

  bool is_current(const Failing& f) const { return stamps_[f.triangle] == f.stamp; }

  void refine(Index t) {
    const std::optional<Candidate> best = best_place(t);
    if (!best) return;
    if (mesh_.vertices() >= options_.most_vertices)
      throw Abandon(Outcome::refused_input, "the spacing would take more than the " +
                                                std::to_string(options_.most_vertices) +
                                                " vertices that are allowed");
    ++counts_.inserted;
    guides_.close(best->step);
    insertion_.insert(best->place, best->seen);
    guides_.add(best->place);
    tree_.insert(best->place);
    stamps_.resize(mesh_.triangles().triangles(), 0);
    for (const Index changed : insertion_.changed()) ++stamps_[changed];
    for (const Index changed : insertion_.changed()) consider(changed);
    if (!std::binary_search(insertion_.changed().begin(), insertion_.changed().end(), t)) consider(t);
  }

  /// Of the places that pass the one whose star has the smallest largest angle; the first of equal ones.
  std::optional<Candidate> best_place(Index t) {
    std::optional<Candidate> best;
    Angle<2> best_angle{};
    for (const Index v : mesh_.triangles().triangle(t))
      for (Step step = guides_.first_step(v); step != guides_.first_step(v + 1); ++step) {
        const std::optional<Candidate> candidate = try_step(v, step);
        if (!candidate) continue;
        ++counts_.trials;
        const Angle<2> angle = insertion_.largest_around(candidate->place, candidate->seen);
        if (best && mesh_.kernel().compare_angle(angle, best_angle) != Sign::negative) continue;
        best = candidate;
        best_angle = angle;
      }
    return best;
  }

  std::optional<Candidate> try_step(Index v, Step step) {
    if (!guides_.is_open(step)) return std::nullopt;
    const Point2 from = mesh_.point(v), place = guides_.place(from, v, step);
    const auto rule_out = [&](std::uint64_t& count) {
      ++count;
      guides_.close(step);
      return std::nullopt;
    };
    if (tree_.any_within(place, guides_.spacing(v), from)) return rule_out(counts_.near);
    if (!guides_.has_room(place, v, step)) return rule_out(counts_.crowded);
    const std::optional<Sighting> seen = look_from(v, place);
    if (!seen) return rule_out(counts_.hidden);
    return Candidate{step, place, *seen};
  }

  /// Where in the domain p is, if it can be seen from the vertex.
  std::optional<Sighting> look_from(Index v, Point2 p) {
    if (p == mesh_.point(v) || !in_box(p)) return std::nullopt;
    if (!mesh_.kernel().admits(p))
      throw Abandon(Outcome::out_of_domain, "a Steiner point is outside the backend's domain");
    const PlanarMesh& t = mesh_.triangles();
    const auto side = [&](Index w) { return mesh_.kernel().orient2d(mesh_.point(v), mesh_.point(w), p); };
    const HalfEdge first = mesh_.link(v);
    HalfEdge h = first;
    do {
      if (mesh_.inside(triangle_of(h)) && side(t.from(h)) != Sign::negative &&
          side(t.to(h)) == Sign::negative) {
        const Sighting seen = refinement::look(mesh_, triangle_of(h), p, counts_.steps);
        if (seen.kind == Sighting::Kind::inside) return seen;
        if (seen.kind == Sighting::Kind::on_edge && !mesh_.held(seen.at)) return seen;
        return std::nullopt;
      }
      h = mesh_.next_link(h);
    } while (h != first);
    return std::nullopt;
  }

  Stretched result() {
    Stretched out{{}, {}, counts_};
    out.counts.swaps = insertion_.swaps();
    const auto given = static_cast<Index>(graph_.points.size());
    const auto sites = static_cast<Index>(built_.point.size());
    out.mesh.points.assign(graph_.points.begin(), graph_.points.end());
    for (const Index v : built_.vertex) out.distances.push_back(guides_.distance(v));
    for (Index v = sites; v < mesh_.vertices(); ++v) {
      out.mesh.points.push_back(mesh_.point(v));
      out.distances.push_back(guides_.distance(v));
    }
    const auto name = [&](Index v) { return v < sites ? built_.point[v] : given + (v - sites); };
    const PlanarMesh& t = mesh_.triangles();
    for (Index i = 0; i < t.triangles(); ++i) {
      if (!mesh_.inside(i)) continue;
      const auto [a, b, c] = t.triangle(i);
      out.mesh.triangles.push_back({name(a), name(b), name(c)});
      out.counts.worst_measure = std::max(out.counts.worst_measure, guides_.measure(mesh_, i));
    }
    out.mesh.subsegments = refinement::find_subsegments(mesh_, built_.recovered.runs, name);
    return out;
  }

  const Options& options_;
  const Graph& graph_;
  GraphMesh built_;
  constrained::Mesh& mesh_;
  MinMaxInsertion insertion_;
  Guides guides_;
  Point2 low_, high_;  // of the box around the graph
  PointTree tree_;
  std::vector<std::uint32_t> stamps_;  // of each triangle: how often it was changed
  std::vector<Failing> failing_;       // a heap, with entries whose triangles have changed since
  Counts counts_;
};

}  // namespace

Stretched refine_stretched(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                           const Options& options) {
  return Run(graph, build(graph, order, kernel, options), options).run();
}

}  // namespace tribunal::stretching
