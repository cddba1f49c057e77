// .ele, the triangles of Triangle: a header (triangles, nodes per triangle, attributes), then number, three
// vertices and attributes on each line. Vertices count from where the triangles count from.
#include "datasets/files/announced.hpp"
#include "datasets/files/format.hpp"
#include "datasets/files/numerals.hpp"

namespace tribunal::files {
namespace {

MeshFile read_mesh(Scanner& scanner, std::uint64_t sites) {
  if (!scanner.next_line()) scanner.refuse_file("no header");
  const Announced triangles(scanner, "triangles");
  if (!scanner.at_end_of_line() && scanner.count("the number of nodes per triangle") != 3)
    scanner.refuse("triangles must have 3 nodes");
  const std::uint64_t attributes = scanner.at_end_of_line() ? 0 : scanner.count("the number of attributes");
  scanner.expect_end_of_line();

  MeshFile mesh;
  mesh.triangles.reserve(triangles.plausible(scanner, 4));
  std::uint64_t base = 0;
  for (std::uint64_t i = 0; i < triangles.count(); ++i) {
    triangles.next_line(scanner, i);
    take_number(scanner, i, base);
    auto& triangle = mesh.triangles.emplace_back();
    for (auto& vertex : triangle) vertex = take_vertex(scanner, base, sites);
    for (std::uint64_t attribute = 0; attribute < attributes; ++attribute)
      (void)scanner.number("an attribute");
    scanner.expect_end_of_line();
  }
  triangles.expect_end(scanner);
  return mesh;
}

std::string write_mesh(std::span<const Point2>, std::span<const Triangle> triangles) {
  std::string text;
  append_number(text, triangles.size());
  text += " 3 0\n";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    append_number(text, i);
    for (const std::uint32_t vertex : triangles[i]) {
      text += ' ';
      append_number(text, vertex);
    }
    text += '\n';
  }
  return text;
}
}  // namespace

constinit const Format ele{
    .about = {".ele", "mesh", "triangles of Triangle, numbered from 0 or 1, with their .node beside"},
    .read_mesh = read_mesh,
    .write_mesh = write_mesh,
    .points_beside = &node,
};

}  // namespace tribunal::files
