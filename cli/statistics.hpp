// What a verb that makes a mesh says of it at the end.
#pragma once

#include "algorithms/algorithm.hpp"
#include "cli/console.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace tribunal::cli {

using TableRows = std::vector<std::vector<std::string>>;

/// A value as it stands in a table: strings without their quotes, numbers to six digits.
std::string plain_text(const nlohmann::json& value);

/// Rows "key value" of those keys of an object, in that order.
TableRows rows_of(const nlohmann::json& object, std::span<const char* const> keys);

/// The extreme angles of triangles in degrees, rounded; null where there is no triangle.
nlohmann::json angles_json(std::span<const Point2> points, std::span<const Triangle> triangles);

/// Rows of what `angles_json` gives.
TableRows angle_rows(const nlohmann::json& angles);

/// The statistics go to `file`, if it is named, and to standard output: as the document of a --json run, else
/// `rows` as a table, which gives way to standard error where mesh or statistics go to standard output.
void tell(const nlohmann::json& statistics, const TableRows& rows, const std::string& mesh,
          const std::string& file, Console& console);

}  // namespace tribunal::cli
