// How large triangles may be, and where.
#pragma once

#include "algorithms/refinement/formula.hpp"
#include "algorithms/refinement/steiner_mesh.hpp"

#include <optional>
#include <vector>

namespace tribunal::refinement {

/// The length that no edge of a triangle may exceed.
struct Size {
  enum class Kind : std::uint8_t {
    none,      ///< any
    uniform,   ///< the same everywhere
    formula,   ///< of x and y, at the triangle's centroid
    boundary,  ///< at a vertex of the input the mean length of the segments there; between them interpolated
  };
  Kind kind = Kind::none;
  double length = 0;                ///< uniform
  std::optional<Formula> of_place;  ///< formula

  /// "none", "boundary", a number or a formula of x and y. Throws Abandon (refused_input) for what is none of
  /// them and for a number that is not positive.
  static Size parse(std::string_view text);
};

/// A size over a mesh that grows.
class SizeField {
 public:
  SizeField(const Size& size, const SteinerMesh& mesh);

  /// The length at a triangle of the mesh; infinite where there is no bound. Throws Abandon
  /// (refused_input), naming the place, where a formula is not positive.
  double limit(const SteinerMesh& mesh, Index t) const;

  /// A new vertex takes its length from the vertices of the triangle, or of the edge, where it will lie.
  /// To be called before it is inserted, and then `add` once it is.
  double interpolate(const SteinerMesh& mesh, Index t, Point2 p) const;
  void add(Index vertex, double length);
  /// The mean of two vertices.
  double between(Index a, Index b) const;

 private:
  const Size& size_;
  std::vector<double> lengths_;  // of each vertex; Kind::boundary alone
};

}  // namespace tribunal::refinement
