// A field that a mesh shall resolve, and how well a triangle does.
#pragma once

#include "algorithms/constrained/graph_mesh.hpp"
#include "algorithms/refinement/formula.hpp"
#include "algorithms/refinement/measure.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal::refinement {

/// A number at every place of a domain.
class Field {
 public:
  virtual ~Field() = default;
  virtual double at(Point2 p) = 0;
};

/// Formulas that have names: an oblique shock and its reflection in the unit square, and a slip line across
/// it.
std::optional<std::string_view> named_formula(std::string_view name);

/// "shock", "slip-line" or a formula of x and y. Throws Abandon (refused_input) for what is none of them.
std::unique_ptr<Field> formula_field(std::string_view text);

/// Given at the points of a graph, linear on the triangles of its constrained Delaunay triangulation. Throws
/// what build_graph_mesh throws, and refused_input for a value that is not finite. `kernel` must stay.
/// O(walk) for each place.
std::unique_ptr<Field> linear_field(const Graph& graph, std::span<const Index> order, const Kernel2& kernel,
                                    std::span<const double> values);

/// The largest change of the field along an edge of a triangle, times the length of that edge: of the first
/// order across a jump, whatever the mesh, of the second elsewhere (after the density gradients of Barth,
/// section 3.5, "Mesh Adaptation"). A triangle fails where that exceeds the tolerance.
class SolutionMeasure : public TriangleMeasure {
 public:
  SolutionMeasure(Field& field, double tolerance) : field_(field), tolerance_(tolerance) {}

  bool fails(const SteinerMesh& mesh, Index t) override { return of(mesh, t) > tolerance_; }
  /// Throws Abandon (refused_input), naming the place, where the field is not finite.
  double of(const SteinerMesh& mesh, Index t);

 private:
  double value(const SteinerMesh& mesh, Index vertex);

  Field& field_;
  double tolerance_;
  std::vector<double> values_;  // of each vertex that was asked for; NaN: not yet
};

}  // namespace tribunal::refinement
