// .node, the points of Triangle and TetGen: a header (points, dimension, attributes, markers), then number,
// x, y, attributes, marker on each line. The first attribute is the value.
#include "datasets/files/announced.hpp"
#include "datasets/files/format.hpp"
#include "datasets/files/numerals.hpp"

namespace tribunal::files {
namespace {

struct Header {
  Announced points;
  std::uint64_t attributes = 0, markers = 0;
};

Header read_header(Scanner& scanner) {
  if (!scanner.next_line()) scanner.refuse_file("no points");
  Header header{Announced(scanner, "points")};
  if (header.points.count() == 0) scanner.refuse("no points");
  if (scanner.at_end_of_line()) return header;
  if (scanner.count("the dimension") != 2) scanner.refuse("the dimension must be 2");
  if (!scanner.at_end_of_line()) header.attributes = scanner.count("the number of attributes");
  if (!scanner.at_end_of_line()) header.markers = scanner.count("the number of markers");
  if (header.markers > 1) scanner.refuse("the number of markers must be 0 or 1");
  scanner.expect_end_of_line();
  return header;
}

PointFile read_points(Scanner& scanner) {
  const Header header = read_header(scanner);
  PointFile file;
  file.points.reserve(header.points.plausible(scanner, 3));
  file.lines.reserve(file.points.capacity());
  std::uint64_t base = 0;
  for (std::uint64_t i = 0; i < header.points.count(); ++i) {
    header.points.next_line(scanner, i);
    take_number(scanner, i, base);
    const double x = scanner.number("x");
    const double y = scanner.number("y");
    for (std::uint64_t attribute = 0; attribute < header.attributes; ++attribute) {
      const double value = scanner.number("an attribute");
      if (attribute == 0) file.values.push_back(value);
    }
    if (header.markers == 1) (void)scanner.integer("the marker");
    scanner.expect_end_of_line();
    file.points.push_back({{x, y}});
    file.lines.push_back(scanner.line());
  }
  header.points.expect_end(scanner);
  return file;
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
