#include "datasets/files/node_list.hpp"

namespace tribunal::files {
namespace {

struct Header {
  Announced points;
  std::uint64_t attributes = 0, markers = 0;
};

Header read_header(Scanner& scanner, bool may_be_empty) {
  Header header{Announced(scanner, "points")};
  if (header.points.count() == 0 && !may_be_empty) scanner.refuse("no points");
  if (scanner.at_end_of_line()) return header;
  if (scanner.count("the dimension") != 2) scanner.refuse("the dimension must be 2");
  if (!scanner.at_end_of_line()) header.attributes = scanner.count("the number of attributes");
  if (!scanner.at_end_of_line()) header.markers = scanner.count("the number of markers");
  if (header.markers > 1) scanner.refuse("the number of markers must be 0 or 1");
  scanner.expect_end_of_line();
  return header;
}

}  // namespace

NodeList read_node_list(Scanner& scanner, bool may_be_empty) {
  const Header header = read_header(scanner, may_be_empty);
  NodeList list{header.points, {}};
  PointFile& file = list.file;
  file.points.reserve(header.points.plausible(scanner, 3));
  file.lines.reserve(file.points.capacity());
  for (std::uint64_t i = 0; i < header.points.count(); ++i) {
    header.points.next_line(scanner, i);
    take_number(scanner, i, list.base);
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
  return list;
}

}  // namespace tribunal::files
