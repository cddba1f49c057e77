// .csv: x,y on each line, perhaps a third column with a value, perhaps a line of names first; fields may be
// quoted.
#include "datasets/files/columns.hpp"
#include "datasets/files/format.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

namespace tribunal::files {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// Names begin with a letter or '_'; "nan" and "inf" are bad numbers, not names.
bool is_name(std::string_view field) {
  if (field.empty()) return false;
  const auto first = static_cast<unsigned char>(field.front());
  if (std::isalpha(first) == 0 && first != '_') return false;
  const std::string lower = lower_case(field);
  return !lower.starts_with("nan") && lower != "inf" && lower != "infinity";
}

/// A line of names, and where each stands.
struct Header {
  std::vector<std::string> names;
  std::vector<Scanner::Place> places;
};

/// The current line, if all its fields are names; takes some or all of them.
std::optional<Header> header(Scanner& scanner) {
  Header header;
  while (!scanner.at_end_of_line()) {
    header.places.push_back(scanner.place());
    const std::string_view field = scanner.field("name");
    if (!is_name(field)) return std::nullopt;
    header.names.push_back(lower_case(field));
  }
  return header;
}

/// Refuses names that say that x and y are not the first two columns.
void require_order(const Scanner& scanner, const Header& header) {
  for (const std::size_t column : {0, 1}) {
    const char* name = column == 0 ? "x" : "y";
    const auto found = std::ranges::find(header.names, name);
    const auto at = static_cast<std::size_t>(found - header.names.begin());
    if (found != header.names.end() && at != column)
      scanner.refuse_at(header.places[at], std::string(name) + " is column " + std::to_string(at + 1) +
                                               ", but is read from column " + std::to_string(column + 1));
  }
}

PointFile read_points(Scanner& scanner) {
  std::optional<Header> names;
  if (scanner.next_line() && !(names = header(scanner))) scanner.unread_line();
  if (!names) return read_columns(scanner);
  require_order(scanner, *names);
  PointFile file = read_columns(scanner);
  const std::size_t columns = file.values.empty() ? 2 : 3;
  if (names->names.size() != columns)
    scanner.refuse_at(names->places[0], std::to_string(names->names.size()) + " names for " +
                                            std::to_string(columns) + " columns");
  return file;
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
