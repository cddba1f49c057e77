// One point per line: the part that .xy, .xyz and .csv share.
#pragma once

#include "datasets/files/files.hpp"
#include "datasets/files/scanner.hpp"

namespace tribunal::files {

/// Reads x, y and perhaps a value from each line, all with a value or none, to the end of the text.
PointFile read_columns(Scanner& scanner);

/// Writes each point on a line, x and y with `separator` between and `ending` after them.
std::string write_columns(std::span<const Point2> points, std::string_view separator,
                          std::string_view ending);

}  // namespace tribunal::files
