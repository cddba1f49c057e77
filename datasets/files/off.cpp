// .off: the word OFF, the numbers of vertices, faces and edges, then x y z on the line of each vertex and
// "3 a b c" on the line of each face, vertices counted from 0; colours may follow. Written with z = 0.
#include "datasets/files/announced.hpp"
#include "datasets/files/format.hpp"
#include "datasets/files/numerals.hpp"

namespace tribunal::files {
namespace {

struct Header {
  Announced vertices, faces;
};

/// "OFF", then the counts in the same line or the next one.
Header read_header(Scanner& scanner) {
  if (!scanner.next_line()) scanner.refuse_file("no points");
  if (const auto word = scanner.field("OFF"); word != "OFF")
    scanner.refuse("OFF expected, found " + in_quotes(word));
  if (scanner.at_end_of_line() && !scanner.next_line())
    scanner.refuse_at(scanner.place(), "the number of vertices is missing");
  const Announced vertices(scanner, "vertices");
  const Announced faces(scanner, "faces");
  if (!scanner.at_end_of_line()) (void)scanner.count("the number of edges");
  scanner.expect_end_of_line();
  return {vertices, faces};
}

PointFile read_vertices(Scanner& scanner, const Announced& vertices) {
  PointFile file;
  file.points.reserve(vertices.plausible(scanner, 3));
  for (std::uint64_t i = 0; i < vertices.count(); ++i) {
    vertices.next_line(scanner, i);
    const double x = scanner.number("x");
    const double y = scanner.number("y");
    file.values.push_back(scanner.number("z"));
    scanner.expect_end_of_line();
    file.points.push_back({{x, y}});
    file.lines.push_back(scanner.line());
  }
  return file;
}

PointFile read_points(Scanner& scanner) {
  const Header header = read_header(scanner);
  if (header.vertices.count() == 0) scanner.refuse_file("no points");
  return read_vertices(scanner, header.vertices);
}

MeshFile read_mesh(Scanner& scanner, std::uint64_t) {
  const Header header = read_header(scanner);
  MeshFile mesh{.points = read_vertices(scanner, header.vertices).points, .triangles = {}};
  mesh.triangles.reserve(header.faces.plausible(scanner, 4));
  for (std::uint64_t i = 0; i < header.faces.count(); ++i) {
    header.faces.next_line(scanner, i);
    if (const auto corners = scanner.count("the number of corners"); corners != 3)
      scanner.refuse("a face with " + std::to_string(corners) + " corners, only triangles are read");
    auto& triangle = mesh.triangles.emplace_back();
    for (auto& vertex : triangle) vertex = take_vertex(scanner, 0, mesh.points.size());
  }
  header.faces.expect_end(scanner);
  return mesh;
}

std::string write_mesh(std::span<const Point2> points, std::span<const Triangle> triangles) {
  std::string text = "OFF\n";
  append_number(text, points.size());
  text += ' ';
  append_number(text, triangles.size());
  text += " 0\n";
  for (const Point2& point : points) {
    append_number(text, point[0]);
    text += ' ';
    append_number(text, point[1]);
    text += " 0\n";
  }
  for (const Triangle& triangle : triangles) {
    text += '3';
    for (const std::uint32_t vertex : triangle) {
      text += ' ';
      append_number(text, vertex);
    }
    text += '\n';
  }
  return text;
}

std::string write_points(std::span<const Point2> points) { return write_mesh(points, {}); }
}  // namespace

constinit const Format off{
    .about = {".off", "points, mesh", "Geomview's Object File Format, triangles only; z is the value"},
    .read_points = read_points,
    .read_mesh = read_mesh,
    .write_points = write_points,
    .write_mesh = write_mesh,
};

}  // namespace tribunal::files
