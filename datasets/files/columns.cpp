#include "datasets/files/columns.hpp"

#include "datasets/files/numerals.hpp"

namespace tribunal::files {

PointFile read_columns(Scanner& scanner) {
  PointFile file;
  std::uint64_t first_line = 0;
  bool with_values = false;
  while (scanner.next_line()) {
    const double x = scanner.number("x");
    const double y = scanner.number("y");
    const bool has_value = !scanner.at_end_of_line();
    if (file.points.empty()) {
      first_line = scanner.line();
      with_values = has_value;
    }
    if (has_value != with_values) {
      const std::string reason = has_value ? "3 columns, but 2 in line " : "2 columns, but 3 in line ";
      scanner.refuse_at(scanner.place(), reason + std::to_string(first_line));
    }
    if (has_value) file.values.push_back(scanner.number("the third column"));
    scanner.expect_end_of_line();
    file.points.push_back({{x, y}});
    file.lines.push_back(scanner.line());
  }
  if (file.points.empty()) scanner.refuse_file("no points");
  return file;
}

std::string write_columns(std::span<const Point2> points, std::string_view separator,
                          std::string_view ending) {
  std::string text;
  for (const Point2& point : points) {
    append_number(text, point[0]);
    text += separator;
    append_number(text, point[1]);
    text += ending;
  }
  return text;
}

}  // namespace tribunal::files
