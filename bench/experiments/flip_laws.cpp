// Experiment `flip-laws`: Lawson's algorithm watched flip by flip.
//
// The backend under trial decides, GMP watches. Counters: `flips`, `tests`, `sweeps`; `falls`, flips that did
// not raise the smallest of the six angles (criterion delaunay) or lower the largest (minmax); `rises`, flips
// of the delaunay criterion that did not lower the lifted surface; `returns`, edges made that had been
// removed before; `nonconvex`, quadrilaterals tested that are not strictly convex, and `violations`, those of
// them that the circle test wanted flipped; `unfinished` (the budget ran out); and of what is left: `valid`
// (a triangulation), `delaunay` (valid as that, too) and `same` (the triangulation that insertion gives).
#include "algorithms/abandon.hpp"
#include "algorithms/flips/angles.hpp"
#include "algorithms/flips/delaunay_criterion.hpp"
#include "algorithms/flips/parameters.hpp"
#include "algorithms/list.hpp"
#include "algorithms/mesh/canonical.hpp"
#include "algorithms/triangulate.hpp"
#include "algorithms/verify/verify.hpp"
#include "bench/experiments/listed.hpp"
#include "bench/input.hpp"
#include "predicates/backends/list.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace tribunal::bench {
namespace {

constexpr Parameter criterion_parameter{
    .name = "criterion", .summary = "what a flip has to improve", .standard = "delaunay", .choices = [] {
      return std::vector<std::string_view>{"delaunay", "delaunay-ties", "minmax"};
    }};
constexpr std::array parameters{criterion_parameter, start_parameter, random_flips_parameter,
                                method_parameter,    scan_parameter,  flip_seed_parameter};

/// Flips at ties, too: what must not be done.
class TiesToo {
 public:
  static constexpr bool implies_convexity = true;
  static constexpr int reach = 1;
  explicit TiesToo(const Sites& sites) : sites_(sites) {}
  bool improves(const EdgeMesh& mesh, Index edge) const {
    const Quadrilateral q = quadrilateral(mesh, edge);
    return sites_.incircle(q.from, q.to, q.left, q.right) != Sign::negative && is_strictly_convex(sites_, q);
  }

 private:
  Sites sites_;
};

/// Passes a criterion's answers on and keeps account of them.
template <class Criterion>
class Watched {
 public:
  static constexpr bool implies_convexity = Criterion::implies_convexity;
  static constexpr int reach = Criterion::reach;
  static constexpr bool is_min_max = std::same_as<Criterion, MinMaxCriterion>;

  Watched(const Sites& asked, const Sites& exact) : criterion_(asked), exact_(exact) {}

  bool improves(const EdgeMesh& mesh, Index edge) {
    quadrilateral_ = quadrilateral(mesh, edge);
    const bool better = criterion_.improves(mesh, edge);
    if (!is_strictly_convex(exact_, quadrilateral_)) {
      ++nonconvex;
      violations += better;
    }
    return better;
  }
  void flipped(const EdgeMesh&, Index) {
    const auto& [a, b, left, right] = quadrilateral_;
    const Triangle before[] = {{a, b, left}, {b, a, right}}, after[] = {{right, left, a}, {left, right, b}};
    if constexpr (is_min_max) {
      falls += exact_.compare_angle(largest_corner(exact_, after), largest_corner(exact_, before)) !=
               Sign::negative;
    } else {
      falls += exact_.compare_angle(smallest_corner(exact_, after), smallest_corner(exact_, before)) !=
               Sign::positive;
      rises += exact_.incircle(a, b, left, right) != Sign::positive;
    }
    removed_.insert(std::minmax(a, b));
    returns += removed_.contains(std::minmax(left, right));
  }

  double nonconvex = 0, violations = 0, falls = 0, rises = 0, returns = 0;

 private:
  Criterion criterion_;
  Sites exact_;
  Quadrilateral quadrilateral_{};
  std::set<std::pair<Index, Index>> removed_;
};

bool is_valid(std::span<const Point2> points, std::span<const Triangle> triangles, verify::Kind kind) {
  return verify::verify_planar(points, {.triangles = triangles}, {.kind = kind, .max_faults = 1}).valid();
}

struct Trial {
  const std::vector<Point2>& points;
  const std::vector<Index>& vertices;
  const Kernel2 &asked, &exact;
};

template <class Criterion>
Finding watch(const Trial& trial, const FlipOptions& options) {
  const Sites asked{trial.points, trial.asked}, exact{trial.points, trial.exact};
  EdgeMesh mesh(start_triangulation(exact, trial.vertices, options.start));
  flip_at_random(exact, mesh, options.random_flips * trial.vertices.size(), options.seed);
  Watched<Criterion> watched(asked, exact);
  FlipEngine engine(asked, mesh, watched, most_flips(trial.vertices.size()));
  bool finished = true;
  try {
    if (options.method == Method::stack)
      engine.flip_from_stack();
    else
      engine.flip_in_sweeps(options.scan, options.seed);
  } catch (const Abandon& abandon) {
    if (abandon.outcome != Outcome::loop) throw;
    finished = false;
  }
  const std::vector<Triangle> triangles = mesh.triangles();
  const Triangulation inserted =
      triangulate(trial.points, trial.vertices, trial.exact, *find_planar_algorithm("bowyer"));
  const FlipCounts& counts = engine.counts();
  return {.counters = {{"flips", static_cast<double>(counts.flips)},
                       {"tests", static_cast<double>(counts.tests)},
                       {"sweeps", static_cast<double>(counts.sweeps)},
                       {"nonconvex", watched.nonconvex},
                       {"violations", watched.violations},
                       {"falls", watched.falls},
                       {"rises", watched.rises},
                       {"returns", watched.returns},
                       {"runs", 1},
                       {"unfinished", !finished},
                       {"valid", is_valid(trial.points, triangles, verify::Kind::triangulation)},
                       {"delaunay", is_valid(trial.points, triangles, verify::Kind::delaunay)},
                       {"same", canonical(triangles) == canonical(inserted.triangles)}}};
}

Finding run_flip_laws(const Cell& cell) {
  const std::vector<Point2> points = distinct_points(cell_points(cell));
  std::vector<Index> vertices(points.size());
  for (Index v = 0; v < vertices.size(); ++v) vertices[v] = v;
  const Kernel2Binding asked = cell_kernel(points, cell), exact = find_backend("gmp")->bind2(points);
  if (const auto* refusal = std::get_if<Refusal>(&asked)) return {Outcome::out_of_domain, describe(*refusal)};
  if (std::all_of(points.begin(), points.end(), [&](const Point2& p) {
        return std::get<0>(exact)->orient2d(points[0], points[points.size() > 1], p) == Sign::zero;
      }))
    return {Outcome::refused_input, "all sites are collinear"};
  const Trial trial{points, vertices, *std::get<0>(asked), *std::get<0>(exact)};
  const FlipOptions options = flip_options(cell.parameters);
  const std::string criterion = choice(cell.parameters, criterion_parameter);
  try {
    if (criterion == "minmax") return watch<MinMaxCriterion>(trial, options);
    if (criterion == "delaunay-ties") return watch<TiesToo>(trial, options);
    return watch<DelaunayCriterion>(trial, options);
  } catch (const Abandon& abandon) {
    return {abandon.outcome, abandon.what()};
  }
}

}  // namespace

constinit const Experiment flip_laws_experiment{
    .name = "flip-laws",
    .cites = "Lawson 1977; Barth, sections 3.3d and 3.4",
    .summary = "edge swapping watched flip by flip: angles, the lifted surface, edges that return",
    .reads = {.backend = true, .dataset = true, .bits = true, .seed = true},
    .parameters = parameters,
    .run = run_flip_laws,
};

}  // namespace tribunal::bench
