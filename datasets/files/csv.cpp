// .csv: x,y on each line, perhaps a third column with a value, perhaps a line of names first.
#include "datasets/files/columns.hpp"
#include "datasets/files/format.hpp"

#include <algorithm>
#include <cctype>

namespace tribunal::files {
namespace {

/// Names begin with a letter, '_' or a quotation mark; "nan" and "inf" are bad numbers, not names.
bool is_name(std::string_view field) {
  if (field.empty()) return false;
  const auto first = static_cast<unsigned char>(field.front());
  if (std::isalpha(first) == 0 && first != '_' && first != '"') return false;
  std::string lower(field);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return !lower.starts_with("nan") && lower != "inf" && lower != "infinity";
}

/// Whether all fields of the current line are names; takes some or all of them.
bool is_header(Scanner& scanner) {
  bool names = true;
  while (names && !scanner.at_end_of_line()) names = is_name(scanner.field("name"));
  return names;
}

PointFile read_points(Scanner& scanner) {
  if (scanner.next_line() && !is_header(scanner)) scanner.unread_line();
  return read_columns(scanner);
}

std::string write_points(std::span<const Point2> points) {
  return "x,y\n" + write_columns(points, ",", "\n");
}
}  // namespace

constinit const Format csv{
    .about = {".csv", "points",
              "x,y per line, perhaps names in the first line; an optional third column is the value"},
    .separator = Scanner::Separator::comma,
    .read_points = read_points,
    .write_points = write_points,
};

}  // namespace tribunal::files
