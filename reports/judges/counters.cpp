// Judge "counters": do sums of counters stand in the stated relations?
//
// The rule's `hold` is a list of tables. Each names a `counter`, sums it over the rows that match its
// selectors (any of task, backend, dataset, bits, n, seed, and parameters of the experiment), divides by the
// sum of the counter `per` where it names one, and states what comes out: `equals`, `least` or `most`. With
// `each = true` that is stated of every row by itself. Counts are exact, so every relation either holds or
// does not: reproduced where all hold, refuted where one does not. `measured` is the first entry's. Where
// chance has a part in what is counted, `false_refutation` says how likely the rule refutes a true claim.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::reports {
namespace {

constexpr std::array<std::string_view, 6> words{"counter", "per", "each", "equals", "least", "most"};

/// A selector's value as it stands in the row; empty where the cell has no such field.
std::string field_of(const bench::Cell& cell, const std::string& name) {
  if (name == "task") return cell.task;
  if (name == "backend") return cell.backend;
  if (name == "dataset") return cell.dataset;
  if (name == "bits") return std::to_string(cell.bits);
  if (name == "n") return std::to_string(cell.n);
  if (name == "seed") return std::to_string(cell.seed);
  const auto found = cell.parameters.find(name);
  return found == cell.parameters.end() ? "" : found->second;
}

std::string selector_text(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : number_text(value.get<double>());
}

bool is_selector(const std::string& key) { return std::find(words.begin(), words.end(), key) == words.end(); }

bool matches(const bench::Row& row, const nlohmann::json& entry) {
  for (const auto& [key, value] : entry.items())
    if (is_selector(key) && field_of(row.cell, key) != selector_text(value)) return false;
  return true;
}

bool is_of_each(const nlohmann::json& entry) { return entry.value("each", false); }

/// "wrong / queries (backend double, bits 13)"
std::string describe(const nlohmann::json& entry) {
  std::string text = entry.at("counter").get<std::string>();
  if (entry.contains("per")) text += " / " + entry.at("per").get<std::string>();
  if (is_of_each(entry)) text += " of each run";
  std::string selectors;
  for (const auto& [key, value] : entry.items())
    if (is_selector(key)) selectors += (selectors.empty() ? "" : ", ") + key + " " + selector_text(value);
  return selectors.empty() ? text : text + " (" + selectors + ")";
}

/// What an entry speaks of lies between these: one value, or one of each row.
struct Measured {
  double least, most;
};

Measured measure(const nlohmann::json& entry, Rows rows) {
  const auto name = entry.at("counter").get<std::string>();
  std::vector<double> sums, pers;
  for (const bench::Row& row : rows) {
    if (!matches(row, entry)) continue;
    if (sums.empty() || is_of_each(entry)) sums.push_back(0), pers.push_back(0);
    sums.back() += counter(row, name);
    if (entry.contains("per")) pers.back() += counter(row, entry.at("per").get<std::string>());
  }
  if (sums.empty()) throw Incomplete("no rows of " + describe(entry));
  for (std::size_t i = 0; i < sums.size() && entry.contains("per"); ++i) {
    if (pers[i] == 0) throw Incomplete("nothing was counted for " + describe(entry));
    sums[i] /= pers[i];
  }
  const auto [least, most] = std::ranges::minmax_element(sums);
  return {*least, *most};
}

Judgement judge(const Rule& rule, Rows rows) {
  require_finished(rows);
  Judgement judgement;
  judgement.verdict = Verdict::reproduced;
  judgement.false_refutation = rule.parameters.value("false_refutation", 0.0);
  bool first = true;
  for (const nlohmann::json& entry : rule.parameters.at("hold")) {
    if (!entry.contains("equals") && !entry.contains("least") && !entry.contains("most"))
      throw Incomplete("nothing is stated of " + describe(entry));
    const Measured found = measure(entry, rows);
    std::string line = describe(entry) + ": " + number_text(found.least);
    if (number_text(found.least) != number_text(found.most)) line += " to " + number_text(found.most);
    const auto require = [&](const char* relation, auto holds) {
      if (!entry.contains(relation)) return;
      const double stated = entry.at(relation).get<double>();
      line += std::string(", stated ") + relation + " " + number_text(stated);
      if (first && !judgement.bound) judgement.bound = stated;
      if (holds(found.least, stated) && holds(found.most, stated)) return;
      line += ": does not hold";
      judgement.verdict = Verdict::refuted;
    };
    require("equals", [](double a, double b) { return a == b; });
    require("least", [](double a, double b) { return a >= b; });
    require("most", [](double a, double b) { return a <= b; });
    if (first) {
      judgement.quantity = describe(entry);
      judgement.measured = entry.contains("most") ? found.most : found.least;
    }
    first = false;
    judgement.lines.push_back(line);
  }
  if (first) throw Incomplete("the rule states nothing");
  return judgement;
}

constexpr std::array<Parameter, 2> parameters{
    {{"hold", ParameterKind::tables, true}, {"false_refutation", ParameterKind::number, false}}};

}  // namespace

constinit const Judge counters_judge{"counters", "sums of counters against stated relations", parameters,
                                     judge};

}  // namespace tribunal::reports
