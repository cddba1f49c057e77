// Experiment `circumcentres`: a domain refined at circumcentres, and what is promised of it.
//
// The domain is the dataset's graph of about n points. Refined with the backend under trial by the
// experiment's parameters, those of `refine --algorithm chew`.
//
// Counters: `sets`, `vertices`, `triangles`; `faults` (the exact checker's, of the mesh over its
// subsegments); `broken` (segments whose subsegments are no path between their ends); `sharp` (triangles with
// an angle below the bound) and `forced` (those that it left for small input angles), `blunt` (triangles with
// an angle above 180 degrees minus twice the bound, in domains without small input angles), `oversize` (edges
// above a uniform size); `flatter` (triangles whose circumradius is less than twice the inradius); of the
// first 200 triangles of the sites' Delaunay triangulation `nearer` (whose circumcentre, as a rational point,
// has a site closer than its corners); of the first 200 of its constrained one, and those of their
// circumcentres that are seen from within the triangle, `nearer_seen` and `nearer_hidden` (closer sites that
// no segment hides from the circumcentre, and those that one does); and the refinement's own counts.
#include "algorithms/list.hpp"
#include "algorithms/refinement/chew_parameters.hpp"
#include "algorithms/triangulate.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "datasets/dataset.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace tribunal::bench {
namespace {
using namespace refinement;  // NOLINT: this file is about nothing else

std::uint64_t count_faults(const DatasetGraph& domain, const Refined& mesh) {
  std::vector<Edge> segments;
  for (const Subsegment& part : mesh.subsegments) segments.push_back(part.ends);
  return verify::verify_constrained(mesh.points, {mesh.triangles},
                                    {segments, domain.holes, verify::Domain::carved})
      .found;
}

/// Segments of which other vertices than their two ends end an odd number of subsegments, or none.
std::uint64_t count_broken(const DatasetGraph& domain, const Refined& mesh) {
  std::vector<std::map<Index, int>> ends(domain.segments.size());
  for (const Subsegment& part : mesh.subsegments)
    if (part.segment != no_segment)
      for (const Index v : part.ends) ++ends[part.segment][v];
  std::uint64_t broken = 0;
  for (std::size_t s = 0; s < ends.size(); ++s) {
    std::vector<Point2> loose, wanted;
    for (const auto& [v, count] : ends[s])
      if (count != 2) loose.push_back(mesh.points[v]);
    for (const Index v : domain.segments[s]) wanted.push_back(domain.points[v]);
    std::sort(loose.begin(), loose.end());
    std::sort(wanted.begin(), wanted.end());
    broken += loose != wanted;
  }
  return broken;
}

struct Shapes {
  double sharp = 0, blunt = 0, oversize = 0, flatter = 0;
};
Shapes count_shapes(const Refined& mesh, const ChewOptions& options) {
  const double bound = std::asin(std::sqrt(options.bound.sine_squared)) * 180 / 3.141592653589793;
  Shapes shapes;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Corners t{mesh.points[i], mesh.points[j], mesh.points[k]};
    const auto [a, b, c] = edge_lengths(t);
    shapes.sharp += is_sharper(t, options.bound);
    shapes.blunt += extreme_angles(t)[1] > 180 - 2 * bound + 1e-9;
    shapes.oversize += options.size.kind == Size::Kind::uniform && std::max({a, b, c}) > options.size.length;
    // 2 r = (b + c - a)(c + a - b)(a + b - c) / (4 area) and R = abc / (4 area).
    shapes.flatter += (b + c - a) * (c + a - b) * (a + b - c) > a * b * c * (1 + 1e-9);
  }
  return shapes;
}

struct Place {
  mpq_class x, y;
};
Place place_of(Point2 p) { return {p[0], p[1]}; }

mpq_class squared_distance(const Place& a, const Place& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

int turn(const Place& a, const Place& b, const Place& c) {
  return sgn(mpq_class((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

/// Whether no segment crosses the way from one place to another; one that touches it hides nothing.
bool sees(const Place& from, const Place& to, const DatasetGraph& domain) {
  return std::none_of(domain.segments.begin(), domain.segments.end(), [&](const Edge& segment) {
    const Place a = place_of(domain.points[segment[0]]), b = place_of(domain.points[segment[1]]);
    return turn(from, to, a) * turn(from, to, b) < 0 && turn(a, b, from) * turn(a, b, to) < 0;
  });
}

Place exact_circumcentre(const Place& a, const Place& b, const Place& c) {
  const mpq_class bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const mpq_class twice = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  return {a.x + (cy * b2 - by * c2) / twice, a.y + (bx * c2 - cx * b2) / twice};
}

constexpr std::size_t most_looked_at = 200;  // triangles

/// Triangles of the Delaunay triangulation whose circumcentres have a site closer than their corners.
double count_nearer(const DatasetGraph& domain, std::span<const Index> order, const Kernel2& kernel) {
  const Triangulation t = triangulate(domain.points, order, kernel, *find_planar_algorithm("green-sibson"));
  double nearer = 0;
  for (std::size_t i = 0; i < std::min(most_looked_at, t.triangles.size()); ++i) {
    const auto& [a, b, c] = t.triangles[i];
    const Place corner = place_of(domain.points[a]);
    const Place centre = exact_circumcentre(corner, place_of(domain.points[b]), place_of(domain.points[c]));
    const mpq_class radius = squared_distance(centre, corner);
    nearer += std::any_of(domain.points.begin(), domain.points.end(),
                          [&](const Point2& p) { return squared_distance(centre, place_of(p)) < radius; });
  }
  return nearer;
}

struct Nearer {
  double seen = 0, hidden = 0;
};
/// Sites closer to circumcentres of constrained Delaunay triangles than their corners, of those circumcentres
/// that are seen from the middle of the triangle.
Nearer count_nearer_past_segments(const DatasetGraph& domain, const Graph& graph,
                                  std::span<const Index> order, const Kernel2& kernel) {
  const auto t = triangulate_graph(graph, order, kernel, Recovery::cavity).mesh;
  Nearer nearer;
  for (std::size_t i = 0; i < std::min(most_looked_at, t.triangles.size()); ++i) {
    const auto& [i0, i1, i2] = t.triangles[i];
    const Place a = place_of(domain.points[i0]), b = place_of(domain.points[i1]),
                c = place_of(domain.points[i2]);
    const Place centre = exact_circumcentre(a, b, c), middle{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    if (!sees(middle, centre, domain)) continue;
    const mpq_class radius = squared_distance(centre, a);
    for (const Point2& p : domain.points) {
      if (squared_distance(centre, place_of(p)) >= radius) continue;
      ++(sees(centre, place_of(p), domain) ? nearer.seen : nearer.hidden);
    }
  }
  return nearer;
}

Finding run_circumcentres(const Cell& cell) {
  const Dataset* dataset = find_dataset(cell.dataset);
  if (dataset->graph == nullptr) return {Outcome::refused_input, "the dataset is no domain"};
  const DatasetGraph domain = dataset->graph(cell.n, cell.seed);
  const Kernel2Binding binding = cell_kernel(domain.points, cell);
  if (const auto* refusal = std::get_if<Refusal>(&binding))
    return {Outcome::out_of_domain, describe(*refusal)};
  const Kernel2& kernel = *std::get<0>(binding);
  const auto order = insertion_order(domain.points, Order::hilbert, 1);
  const ChewOptions options = chew_options(cell.parameters);
  const Graph graph{domain.points, domain.segments, domain.holes, Domain::carved};
  const Refinement done = refine_by_circumcentres(graph, order, kernel, options);
  if (done.report.mesh.outcome != Outcome::ok) return {done.report.mesh.outcome, done.report.mesh.reason};
  const Shapes shapes = count_shapes(done.mesh, options);
  const Nearer past_segments = count_nearer_past_segments(domain, graph, order, kernel);
  const ChewCounts& counts = done.counts;
  const auto number = [](auto count) { return static_cast<double>(count); };
  return {.counters = {{"sets", 1},
                       {"vertices", number(done.mesh.points.size())},
                       {"triangles", number(done.mesh.triangles.size())},
                       {"faults", number(count_faults(domain, done.mesh))},
                       {"broken", number(count_broken(domain, done.mesh))},
                       {"sharp", shapes.sharp},
                       {"blunt", counts.small_input_angles == 0 ? shapes.blunt : 0},
                       {"oversize", shapes.oversize},
                       {"flatter", shapes.flatter},
                       {"nearer", count_nearer(domain, order, kernel)},
                       {"nearer_seen", past_segments.seen},
                       {"nearer_hidden", past_segments.hidden},
                       {"forced", number(counts.forced)},
                       {"circumcentres", number(counts.circumcentres)},
                       {"deleted", number(counts.deleted)},
                       {"splits", number(counts.splits)},
                       {"refused_splits", number(counts.refused_splits)},
                       {"steps", number(counts.steps)},
                       {"measured", number(counts.tests)},
                       {"stale", number(counts.stale)},
                       {"small_input_angles", number(counts.small_input_angles)},
                       {"unresolved", number(counts.unresolved)}}};
}

}  // namespace

constinit const Experiment circumcentres_experiment{
    .name = "circumcentres",
    .cites = "Chew 1989, 1993; Barth, section 3.5",
    .summary = "a domain refined at circumcentres: angles, sizes, segments, walks",
    .reads = {.backend = true, .dataset = true, .seed = true},
    .parameters = chew_parameters,
    .run = run_circumcentres,
};

}  // namespace tribunal::bench
