#include "algorithms/refinement/solution.hpp"

#include "algorithms/location/stochastic_walk.hpp"
#include "algorithms/refinement/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace tribunal::refinement {
namespace {
constexpr std::array<std::string_view, 2> place{"x", "y"};

struct NamedFormula {
  std::string_view name, text;
};
constexpr std::array<NamedFormula, 2> named{{{"shock", "tanh(60*(y - 1 + 1.2*x)) + tanh(60*(1.2*x - 1 - y))"},
                                             {"slip-line", "tanh(60*(y - 0.5 - 0.1*sin(6*x)))"}}};

class FormulaField : public Field {
 public:
  explicit FormulaField(std::string_view text) : formula_(text, place) {}
  double at(Point2 p) override { return formula_(p.coordinate); }

 private:
  Formula formula_;
};

constrained::GraphMesh background(const Graph& graph, std::span<const Index> order, const Kernel2& kernel) {
  const auto sites = constrained::distinct_sites(graph, order, kernel);
  if (sites.collinear) throw Abandon(Outcome::refused_input, "all points lie on one line");
  return build_graph_mesh(graph, sites, kernel, Recovery::cavity);
}

/// Where walks start: at the end of the last one to the same cell of a grid of about as many cells as
/// vertices, so that it does not matter in which order places are asked for.
class Starts {
 public:
  explicit Starts(const constrained::GraphMesh& mesh)
      : side_(1 + static_cast<std::size_t>(std::sqrt(static_cast<double>(mesh.point.size())))),
        triangle_(side_ * side_, 0),
        low_(mesh.mesh.point(0)),
        high_(low_) {
    for (Index v = 1; v < mesh.point.size(); ++v)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low_[axis] = std::min(low_[axis], mesh.mesh.point(v)[axis]);
        high_[axis] = std::max(high_[axis], mesh.mesh.point(v)[axis]);
      }
  }
  Index& at(Point2 p) { return triangle_[cell(p, 0) * side_ + cell(p, 1)]; }

 private:
  std::size_t cell(Point2 p, std::size_t axis) const {
    const double share = (p[axis] - low_[axis]) / (high_[axis] - low_[axis]) * static_cast<double>(side_);
    return share > 0 ? std::min(static_cast<std::size_t>(std::min(share, 0x1p32)), side_ - 1) : 0;
  }

  std::size_t side_;
  std::vector<Index> triangle_;
  Point2 low_, high_;
};

class LinearField : public Field {
 public:
  LinearField(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
              std::span<const double> values)
      : mesh_(background(graph, order, kernel)), places_(mesh_.point.size() + 1), starts_(mesh_) {
    for (Index v = 0; v < mesh_.point.size(); ++v) {
      places_[v] = mesh_.mesh.point(v);
      values_.push_back(values[mesh_.point[v]]);
      if (!std::isfinite(values_.back()))
        throw Abandon(Outcome::refused_input,
                      "the value of point " + std::to_string(mesh_.point[v]) + " is not finite");
    }
  }

  double at(Point2 p) override {
    const PlanarMesh& t = mesh_.mesh.triangles();
    places_.back() = p;
    std::uint64_t steps = 0;
    Index& start = starts_.at(p);
    walk_.start_at(start);
    const Index found = walk_.locate(static_cast<Index>(places_.size() - 1), steps);
    start = found;
    if (t.is_ghost(found)) throw Abandon(Outcome::inconsistent_predicate, "a vertex lies outside the hull");
    return interpolate(t.triangle(found), p);
  }

 private:
  /// Linearly over the triangle that holds p, of any size.
  double interpolate(const Triangle& v, Point2 p) const {
    const Corners corners{places_[v[0]], places_[v[1]], places_[v[2]]};
    const int excess = excess_exponent(corners);
    const Corners at = scaled(corners, -excess);
    p = scaled(p, -excess);
    std::array<double, 3> areas{};  // of the triangle with p in the place of a corner
    double whole = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 a = at[(i + 1) % 3], b = at[(i + 2) % 3];
      areas[i] = std::max((a[0] - p[0]) * (b[1] - p[1]) - (a[1] - p[1]) * (b[0] - p[0]), 0.0);
      whole += areas[i];
    }
    if (!(whole > 0)) return values_[v[0]];
    double value = 0;
    for (std::size_t i = 0; i < 3; ++i) value += areas[i] / whole * values_[v[i]];
    return value;
  }

  constrained::GraphMesh mesh_;
  std::vector<Point2> places_;  // of the vertices, and of where a value is wanted
  std::vector<double> values_;
  Starts starts_;
  PlanarProblem problem_{places_, {}, mesh_.mesh.kernel()};
  StochasticWalk walk_{problem_, mesh_.mesh.triangles()};
};

}  // namespace

std::optional<std::string_view> named_formula(std::string_view name) {
  for (const auto& [known, text] : named)
    if (known == name) return text;
  return std::nullopt;
}

std::unique_ptr<Field> formula_field(std::string_view text) {
  return std::make_unique<FormulaField>(named_formula(text).value_or(text));
}

std::unique_ptr<Field> linear_field(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                                    std::span<const double> values) {
  return std::make_unique<LinearField>(graph, order, kernel, values);
}

double SolutionMeasure::value(const SteinerMesh& mesh, Index vertex) {
  if (vertex >= values_.size())
    values_.resize(vertex + std::size_t{1}, std::numeric_limits<double>::quiet_NaN());
  if (std::isnan(values_[vertex])) values_[vertex] = field_.at(mesh.point(vertex));
  if (!std::isfinite(values_[vertex]))
    throw Abandon(Outcome::refused_input, "the field is not finite at " + text_of(mesh.point(vertex)));
  return values_[vertex];
}

double SolutionMeasure::of(const SteinerMesh& mesh, Index t) {
  const Triangle v = mesh.triangles().triangle(t);
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index a = v[i], b = v[(i + 1) % 3];
    largest =
        std::max(largest, std::abs(value(mesh, a) - value(mesh, b)) * distance(mesh.point(a), mesh.point(b)));
  }
  return largest;
}

}  // namespace tribunal::refinement
