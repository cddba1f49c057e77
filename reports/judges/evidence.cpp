#include "reports/judges/evidence.hpp"

#include "reports/text.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::reports {

double counter(const bench::Row& row, std::string_view name) {
  const auto found = row.counters.find(std::string(name));
  if (found == row.counters.end())
    throw Incomplete("no counter \"" + std::string(name) + "\" in a row of " + describe(row));
  return found->second;
}

void require_finished(Rows rows) {
  const auto failed = [](const bench::Row& row) { return row.outcome != "ok"; };
  const auto count = std::count_if(rows.begin(), rows.end(), failed);
  if (count == 0) return;
  const auto first = std::find_if(rows.begin(), rows.end(), failed);
  throw Incomplete(std::to_string(count) + " of " + std::to_string(rows.size()) +
                   " runs did not end ok, the first " + first->outcome + " (" + describe(*first) +
                   "): no verdict from the others alone");
}

std::string describe(const bench::Row& row) {
  const bench::Cell& cell = row.cell;
  const auto algorithm = cell.parameters.find("algorithm");
  std::string text = algorithm == cell.parameters.end() ? cell.task : algorithm->second;
  if (algorithm == cell.parameters.end())
    for (const auto& [name, value] : cell.parameters) text.append(" ").append(name).append("=").append(value);
  text += ", " + cell.backend;
  if (!cell.dataset.empty()) text += ", " + cell.dataset + ", " + cell.order + " order";
  if (cell.n > 0) text += ", N = " + std::to_string(cell.n);
  return text;
}

std::map<std::uint64_t, std::vector<bench::Row>> by_size(Rows rows) {
  std::map<std::uint64_t, std::vector<bench::Row>> groups;
  for (const bench::Row& row : rows) groups[row.cell.n].push_back(row);
  return groups;
}

std::vector<Sample> samples(Rows rows, std::string_view name) {
  std::vector<Sample> result;
  std::map<std::string, std::vector<double>> runs;
  std::map<std::string, std::size_t> place;
  for (const bench::Row& row : rows) {
    const auto n = static_cast<double>(row.cell.n);
    if (row.cell.task == "tau-over-orders") {
      const double orders = counter(row, "orders");
      const double sd = counter(row, "tau_sd");
      result.push_back(
          {describe(row) + ", seed " + std::to_string(row.cell.seed),
           n,
           {static_cast<std::size_t>(orders), counter(row, "tau_mean"), sd, sd / std::sqrt(orders)}});
      continue;
    }
    const std::string label = describe(row);
    if (place.try_emplace(label, result.size()).second) result.push_back({label, n, {}});
    runs[label].push_back(counter(row, name));
  }
  for (const auto& [label, values] : runs) result[place[label]].summary = bench::summarise(values);
  return result;
}

double number(const Rule& rule, std::string_view name, double otherwise) {
  return rule.parameters.contains(name) ? rule.parameters.at(std::string(name)).get<double>() : otherwise;
}

std::string text(const Rule& rule, std::string_view name, std::string_view otherwise) {
  return rule.parameters.contains(name) ? rule.parameters.at(std::string(name)).get<std::string>()
                                        : std::string(otherwise);
}

std::vector<std::string> texts(const Rule& rule, std::string_view name) {
  if (!rule.parameters.contains(name)) return {};
  return rule.parameters.at(std::string(name)).get<std::vector<std::string>>();
}

}  // namespace tribunal::reports
