// .node, the points of Triangle and TetGen: a header (points, dimension, attributes, markers), then number,
// x, y, attributes, marker on each line. The first attribute is the value.
#include "datasets/files/format.hpp"
#include "datasets/files/node_list.hpp"
#include "datasets/files/numerals.hpp"

namespace tribunal::files {
namespace {

PointFile read_points(Scanner& scanner) {
  if (!scanner.next_line()) scanner.refuse_file("no points");
  NodeList list = read_node_list(scanner);
  list.announced.expect_end(scanner);
  return std::move(list.file);
}

std::string write_points(std::span<const Point2> points) {
  std::string text;
  append_number(text, points.size());
  text += " 2 0 0\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    append_number(text, i);
    text += ' ';
    append_number(text, points[i][0]);
    text += ' ';
    append_number(text, points[i][1]);
    text += '\n';
  }
  return text;
}
}  // namespace

constinit const Format node{
    .about = {".node", "points",
              "points of Triangle, numbered from 0 or 1; the first attribute is the value"},
    .read_points = read_points,
    .write_points = write_points,
};

}  // namespace tribunal::files
