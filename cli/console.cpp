#include "cli/console.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace tribunal::cli {

void print_json(Console& console, const nlohmann::json& document) {
  // Paths need not be UTF-8, JSON must be: what is not gets the replacement character.
  console.out << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void print_table(Console& console, const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths.resize(std::max(widths.size(), i + 1));
      widths[i] = std::max(widths[i], row[i].size());
    }
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      console.out << row[i];
      if (i + 1 < row.size()) console.out << std::string(widths[i] - row[i].size() + 2, ' ');
    }
    console.out << '\n';
  }
}

}  // namespace tribunal::cli
