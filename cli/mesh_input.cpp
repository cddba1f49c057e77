#include "cli/mesh_input.hpp"

#include "cli/console.hpp"

namespace tribunal::cli {

MeshFile read_mesh_over(const std::string& name, const PointFile& points, const std::string& mesh) {
  if (name == "-" && mesh == "-") throw BadUsage("the points and the mesh both want standard input");
  MeshFile read = read_mesh(mesh, points.points.size());
  if (read.points.empty()) return read;  // .ele leaves them to a .node
  if (read.points.size() != points.points.size())
    throw BadInput(mesh + ": holds " + std::to_string(read.points.size()) + " vertices, but " + name +
                   " holds " + std::to_string(points.points.size()) + " points");
  for (std::size_t i = 0; i < read.points.size(); ++i)
    if (read.points[i] != points.points[i])
      throw BadInput(mesh + ": vertex " + std::to_string(i) + " is not where " + name + ":" +
                     std::to_string(points.lines[i]) + " has it");
  return read;
}

}  // namespace tribunal::cli
