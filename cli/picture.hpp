// The picture that verbs with a mesh draw of it.
#pragma once

#include "algorithms/parameter.hpp"
#include "algorithms/triangulation.hpp"
#include "datasets/files/files.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tribunal::cli {

struct PictureOptions {
  std::string file;              ///< .svg or .png; empty: none
  std::string colour = "plain";  ///< plain, angle, smallest-angle or field
  std::string field;             ///< column or F1 to F6; empty: what the algorithm reads, else column
  std::uint32_t contours = 0;
  std::string window;   ///< "x0,y0,x1,y1"; empty: everything
  std::string against;  ///< mesh file; edges that it lacks stand out; empty: none
};

/// Throws BadUsage or BadInput for what can be seen to be wrong before any file is read.
void check_picture(const PictureOptions& options);

/// A picture that waits for its mesh: what else it needs is read and checked before anything is computed.
class Picture {
 public:
  /// Of a mesh over these points of a file. `settings` are the algorithm's, for the field that it reads.
  /// Throws BadInput naming the file and the column where it has none to show, the point where a function has
  /// no finite value, and what is wrong with the mesh to compare with.
  Picture(const PictureOptions& options, const std::string& file, const PointFile& points,
          const Settings& settings);

  /// Draws, where the user wants a picture. `marked` edges stand out, and those that the other mesh lacks.
  void draw(std::span<const Point2> points, std::span<const Triangle> triangles,
            std::span<const Edge> marked = {}) const;

 private:
  const PictureOptions& options_;
  std::vector<double> field_;
  std::vector<Edge> others_;  ///< edges of the mesh to compare with, sorted
};

}  // namespace tribunal::cli
