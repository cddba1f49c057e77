#include "cli/statistics.hpp"

#include "algorithms/refinement/shape.hpp"
#include "datasets/files/text.hpp"
#include "reports/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tribunal::cli {

std::string plain_text(const nlohmann::json& value) {
  if (value.is_number_float()) return reports::number_text(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

TableRows rows_of(const nlohmann::json& object, std::span<const char* const> keys) {
  TableRows rows;
  for (const char* key : keys) rows.push_back({key, plain_text(object.at(key))});
  return rows;
}

nlohmann::json angles_json(std::span<const Point2> points, std::span<const Triangle> triangles) {
  if (triangles.empty()) return {{"largest", nullptr}, {"smallest", nullptr}};
  double smallest = 180, largest = 0;
  for (const auto& [a, b, c] : triangles) {
    const auto [least, most] = refinement::extreme_angles({points[a], points[b], points[c]});
    smallest = std::min(smallest, least);
    largest = std::max(largest, most);
  }
  return {{"largest", largest}, {"smallest", smallest}};
}

TableRows angle_rows(const nlohmann::json& angles) {
  return {{"smallest angle", plain_text(angles.at("smallest"))},
          {"largest angle", plain_text(angles.at("largest"))}};
}

void tell(const nlohmann::json& statistics, const TableRows& rows, const std::string& mesh,
          const std::string& file, Console& console) {
  if (!file.empty()) write_text(file, statistics.dump(2) + "\n");
  if (console.json) return print_json(console, statistics);
  const bool piped = mesh == "-" || file == "-";
  Console table{.out = piped ? console.log : console.out, .log = console.log};
  print_table(table, rows);
}

}  // namespace tribunal::cli
