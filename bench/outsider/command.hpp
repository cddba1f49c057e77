// A program that reads points from one file and writes a mesh to another.
#pragma once

#include "bench/outsider/triangulator.hpp"

#include <filesystem>
#include <string>

namespace tribunal::bench {

/// A command line of a POSIX shell in which {points} and {mesh} stand for files: {points.node} and {mesh.ele}
/// for files of such a format, .xy and .off where none is named. A program that exits with a status other
/// than 0 refuses the points; one that is killed by a signal has crashed.
class CommandTriangulator final : public Triangulator {
 public:
  /// `folder` is where the files go; it must exist, and is emptied before each triangulation. Throws BadInput
  /// when the command names no {points} or no {mesh}, or a format that cannot be written or read.
  CommandTriangulator(std::string command, std::filesystem::path folder);

  /// Writes the points, runs the command in this process's group, reads the mesh. Its time is the wall clock
  /// of the command, start of the program included.
  OutsiderMesh triangulate(std::span<const Point2> points) const override;

  int spare_runs() const override { return 300; }
  std::string options() const override;

 private:
  OutsiderMesh read(std::span<const Point2> points, double seconds) const;
  std::string without_folder(std::string text) const;

  std::string command_;
  std::filesystem::path folder_, points_, mesh_;
  std::string filled_;  ///< the command with the files' names in it
};

}  // namespace tribunal::bench
