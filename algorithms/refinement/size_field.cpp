#include "algorithms/refinement/size_field.hpp"

#include "algorithms/parameter.hpp"
#include "algorithms/refinement/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tribunal::refinement {
namespace {
constexpr std::array<std::string_view, 2> place{"x", "y"};

/// The mean length of the held edges at each vertex; at one without any, of all held edges.
std::vector<double> boundary_lengths(const SteinerMesh& mesh) {
  const PlanarMesh& t = mesh.triangles();
  std::vector<double> sum(mesh.mesh().vertices(), 0), edges(sum.size(), 0);
  double all = 0, count = 0;
  for (HalfEdge h = 0; h < 3 * t.triangles(); ++h) {
    if (!mesh.mesh().held(h)) continue;
    const double length = distance(mesh.point(t.from(h)), mesh.point(t.to(h)));
    sum[t.from(h)] += length;
    edges[t.from(h)] += 1;
    all += length;
    count += 1;
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] = edges[v] > 0 ? sum[v] / edges[v] : all / count;
  return sum;
}

}  // namespace

Size Size::parse(std::string_view text) {
  if (text == "none") return {};
  if (text == "boundary") return {Kind::boundary, 0, {}};
  const Formula formula(text, place);
  if (!formula.is_constant()) return {Kind::formula, 0, formula};
  const double value = formula({});
  if (!(value > 0) || !std::isfinite(value))
    throw Abandon(Outcome::refused_input, "a size is positive, and " + std::string(text) + " is not");
  return {Kind::uniform, value, {}};
}

SizeField::SizeField(const Size& size, const SteinerMesh& mesh) : size_(size) {
  if (size.kind == Size::Kind::boundary) lengths_ = boundary_lengths(mesh);
}

double SizeField::limit(const SteinerMesh& mesh, Index t) const {
  double length = size_.length;
  if (size_.kind == Size::Kind::none) return std::numeric_limits<double>::infinity();
  if (size_.kind == Size::Kind::formula) {
    const auto [a, b, c] = mesh.corners(t);
    const std::array at{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
    length = (*size_.of_place)(at);
    if (!(length > 0)) throw Abandon(Outcome::refused_input, "the size is not positive at " + text_of({at}));
  } else if (size_.kind == Size::Kind::boundary) {
    const Triangle v = mesh.triangles().triangle(t);
    length = (lengths_[v[0]] + lengths_[v[1]] + lengths_[v[2]]) / 3;
  }
  return length;
}

double SizeField::interpolate(const SteinerMesh& mesh, Index t, Point2 p) const {
  if (size_.kind != Size::Kind::boundary) return 0;
  const Corners corners = mesh.corners(t);
  const int excess = excess_exponent(corners);
  const auto [a, b, c] = scaled(corners, -excess);
  p = scaled(p, -excess);
  const auto area = [](Point2 i, Point2 j, Point2 k) {
    return std::fabs((j[0] - i[0]) * (k[1] - i[1]) - (j[1] - i[1]) * (k[0] - i[0]));
  };
  const double u = area(p, b, c), v = area(p, c, a), w = area(p, a, b), sum = u + v + w;
  const Triangle at = mesh.triangles().triangle(t);
  if (!(sum > 0)) return lengths_[at[0]];
  return (u * lengths_[at[0]] + v * lengths_[at[1]] + w * lengths_[at[2]]) / sum;
}

double SizeField::between(Index a, Index b) const {
  return size_.kind == Size::Kind::boundary ? (lengths_[a] + lengths_[b]) / 2 : 0;
}

void SizeField::add(Index vertex, double length) {
  if (size_.kind != Size::Kind::boundary) return;
  lengths_.resize(std::max<std::size_t>(lengths_.size(), vertex + std::size_t{1}), length);
  lengths_[vertex] = length;
}

}  // namespace tribunal::refinement
