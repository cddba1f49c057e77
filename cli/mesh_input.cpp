#include "cli/mesh_input.hpp"

namespace tribunal::cli {
namespace {

void compare_vertices(const MeshInput& input, const std::string& points, const std::string& mesh) {
  const auto &given = input.points.points, &carried = input.mesh.points;
  if (carried.empty()) return;
  if (carried.size() != given.size())
    throw BadInput(mesh + ": holds " + std::to_string(carried.size()) + " vertices, but " + points +
                   " holds " + std::to_string(given.size()) + " points");
  for (std::size_t i = 0; i < given.size(); ++i)
    if (carried[i] != given[i])
      throw BadInput(mesh + ": vertex " + std::to_string(i) + " is not where " + points + ":" +
                     std::to_string(input.points.lines[i]) + " has it");
}

}  // namespace

MeshInput read_mesh_over(const std::string& points, const std::string& mesh) {
  MeshInput input;
  input.points = read_points(points);
  input.mesh = read_mesh(mesh, input.points.points.size());
  compare_vertices(input, points, mesh);
  return input;
}

}  // namespace tribunal::cli
