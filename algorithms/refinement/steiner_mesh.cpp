#include "algorithms/refinement/steiner_mesh.hpp"

#include "algorithms/constrained/rational_point.hpp"
#include "algorithms/constrained/removal.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace tribunal::refinement {
namespace {
using constrained::GraphMesh;

/// The double point nearest to a + t (b - a).
Point2 nearest_on(Point2 a, Point2 b, double t) {
  const RationalPoint p = rational(a), q = rational(b);
  const mpq_class s(t);
  return nearest({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
}

/// The place itself, then its neighbours, then theirs.
constexpr auto steps_around = [] {
  std::array<std::array<int, 2>, 25> steps{};
  std::size_t next = 0;
  for (int ring = 0; ring <= 2; ++ring)
    for (int x = -ring; x <= ring; ++x)
      for (int y = -ring; y <= ring; ++y)
        if (std::max(x < 0 ? -x : x, y < 0 ? -y : y) == ring) steps[next++] = {x, y};
  return steps;
}();

/// The double so many doubles further up.
double stepped(double x, int steps) {
  const double towards =
      steps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (int i = steps < 0 ? -steps : steps; i > 0; --i) x = std::nextafter(x, towards);
  return x;
}

}  // namespace

SteinerMesh::SteinerMesh(const Graph& graph, std::span<const Index> order, const Kernel2& kernel)
    : SteinerMesh(graph, build_domain_mesh(graph, order, kernel)) {}

SteinerMesh::SteinerMesh(const Graph& graph, GraphMesh built)
    : mesh_(std::move(built.mesh)),
      input_(graph.points.begin(), graph.points.end()),
      input_vertex_(std::move(built.vertex)),
      runs_(std::move(built.recovered.runs)),
      piece_ends_(built.recovered.pieces.size()),
      roles_(mesh_.vertices(), Role::input),
      parameters_(mesh_.vertices(), 0) {
  const PlanarMesh& t = triangles();
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h)
    if (mesh_.held(h)) piece_ends_[mesh_.piece(h)] = undirected(t.from(h), t.to(h));
}

void SteinerMesh::require_admitted(Point2 p) const {
  if (!mesh_.kernel().admits(p))
    throw Abandon(Outcome::out_of_domain, "a Steiner point is outside the backend's domain");
}

Sighting SteinerMesh::look(Index t, Point2 p) {
  assert(in_domain(t));
  require_admitted(p);
  return refinement::look(mesh_, t, p, steps_);
}

Index SteinerMesh::insert(Point2 p, const Sighting& where) {
  assert(where.kind == Sighting::Kind::inside ||
         (where.kind == Sighting::Kind::on_edge && !mesh_.held(where.at)));
  roles_.push_back(Role::free);
  parameters_.push_back(0);
  return where.kind == Sighting::Kind::inside ? mesh_.insert_into(triangle_of(where.at), p)
                                              : mesh_.insert_on(where.at, p);
}

double SteinerMesh::parameter(Index piece, Index vertex) const {
  if (roles_[vertex] == Role::on_segment) return parameters_[vertex];
  return vertex == piece_ends_[piece][0] ? 0 : 1;
}

std::array<double, 2> SteinerMesh::stretch(HalfEdge h) const {
  assert(mesh_.held(h));
  const Index piece = mesh_.piece(h);
  return {parameter(piece, triangles().from(h)), parameter(piece, triangles().to(h))};
}

std::optional<Index> SteinerMesh::split(HalfEdge h) {
  const auto [from, to] = stretch(h);
  return split(h, from + (to - from) / 2);
}

std::optional<Index> SteinerMesh::split(HalfEdge h, double t) {
  const auto [from, to] = stretch(h);
  if (!(std::min(from, to) < t && t < std::max(from, to))) return std::nullopt;
  const Edge ends = piece_ends(h);
  std::optional<Point2> p = place_near(h, nearest_on(point(ends[0]), point(ends[1]), t));
  if (!p) {
    const Point2 a = point(triangles().from(h)), b = point(triangles().to(h));
    p = place_near(h, nearest_on(a, b, (t - from) / (to - from)));
  }
  if (!p) return std::nullopt;
  roles_.push_back(Role::on_segment);
  parameters_.push_back(t);
  return mesh_.insert_on(h, *p);
}

/// The first point in rings around `place` that may split the held edge h.
std::optional<Point2> SteinerMesh::place_near(HalfEdge h, Point2 place) const {
  for (const auto& [right, up] : steps_around) {
    const Point2 p{{stepped(place[0], right), stepped(place[1], up)}};
    require_admitted(p);
    if (admits_split(h, p)) return p;
  }
  return std::nullopt;
}

/// Inside the circles of the triangles beside the edge a rounded point conflicts with both, as one on the
/// edge does, so that swaps make the mesh constrained Delaunay again. The boundary bends inwards only: so the
/// domain never grows, and parts of it never come to overlap, whatever lies outside.
bool SteinerMesh::admits_split(HalfEdge h, Point2 p) const {
  const PlanarMesh& t = triangles();
  const Kernel2& kernel = mesh_.kernel();
  for (const HalfEdge side : {h, t.twin(h)}) {
    const Point2 a = point(t.from(side)), b = point(t.to(side));
    if (!in_domain(triangle_of(side))) {
      if (kernel.orient2d(a, b, p) == Sign::positive) return false;
      continue;
    }
    const Point2 c = point(t.corner(side));
    if (kernel.orient2d(a, p, c) != Sign::positive || kernel.orient2d(p, b, c) != Sign::positive ||
        kernel.incircle(a, b, c, p) != Sign::positive)
      return false;
  }
  return true;
}

std::vector<Index> SteinerMesh::remove(Index vertex) {
  assert(role(vertex) == Role::free);
  roles_[vertex] = Role::removed;
  ++removed_;
  return constrained::remove(mesh_, vertex);
}

Refined SteinerMesh::result() const {
  Refined result{input_, {}, {}};
  std::vector<Index> number(roles_.size(), 0);
  for (std::size_t p = input_.size(); p-- > 0;) number[input_vertex_[p]] = static_cast<Index>(p);
  for (Index v = 0; v < roles_.size(); ++v) {
    if (roles_[v] != Role::on_segment && roles_[v] != Role::free) continue;
    number[v] = static_cast<Index>(result.points.size());
    result.points.push_back(point(v));
  }
  const PlanarMesh& t = triangles();
  for (Index i = 0; i < t.triangles(); ++i) {
    const Triangle v = t.triangle(i);
    if (in_domain(i)) result.triangles.push_back({number[v[0]], number[v[1]], number[v[2]]});
  }
  result.subsegments = find_subsegments(mesh_, runs_, [&](Index v) { return number[v]; });
  return result;
}

}  // namespace tribunal::refinement
