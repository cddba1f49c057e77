#include "cli/statistics.hpp"

#include "datasets/files/text.hpp"
#include "reports/text.hpp"

#include <nlohmann/json.hpp>

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

void tell(const nlohmann::json& statistics, const TableRows& rows, const std::string& mesh,
          const std::string& file, Console& console) {
  if (!file.empty()) write_text(file, statistics.dump(2) + "\n");
  if (console.json) return print_json(console, statistics);
  const bool piped = mesh == "-" || file == "-";
  Console table{.out = piped ? console.log : console.out, .log = console.log};
  print_table(table, rows);
}

}  // namespace tribunal::cli
