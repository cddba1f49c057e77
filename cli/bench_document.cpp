#include "cli/bench_document.hpp"

#include "bench/manifest.hpp"
#include "bench/statistics.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <ostream>
#include <string>

namespace tribunal::cli {
namespace {
using bench::MeasuredGoal;
using bench::MicroCell;
using bench::MicroOutcome;
using nlohmann::json;

json stage_shares(const MicroCell& cell) {
  json shares = json::object();
  for (std::size_t s = 0; s < cell.stages.size(); ++s)
    if (cell.stages[s] != 0)
      shares[std::string(stage_names[s])] =
          static_cast<double>(cell.stages[s]) / static_cast<double>(cell.queries);
  return shares;
}

json cell_document(const MicroCell& cell) {
  json document{{"subject", cell.subject},
                {"predicate", to_string(cell.predicate)},
                {"family", cell.family},
                {"outcome", to_string(cell.outcome)}};
  if (cell.outcome == MicroOutcome::out_of_domain || cell.outcome == MicroOutcome::at_fault) {
    document["reason"] = cell.reason;
    return document;
  }
  document["wrong"] = cell.wrong;
  document["wrong_rate"] = cell.wrong_rate();
  document["stages"] = stage_shares(cell);
  if (cell.outcome == MicroOutcome::timed) {
    const bench::Interval interval = bench::bootstrap_median(cell.nanoseconds, 1);
    document["nanoseconds"] = bench::median(cell.nanoseconds);
    document["interval"] = {interval.low, interval.high};
  }
  return document;
}

json goal_document(const MeasuredGoal& measured) {
  const bench::Goal& goal = measured.goal;
  json document{{"subject", goal.subject}, {"rival", goal.rival},
                {"family", goal.family},   {"predicate", to_string(goal.predicate)},
                {"goal", goal.at_most},    {"ratio", nullptr}};
  if (!measured.ratio) {
    document["verdict"] = "not_measured";
    document["reason"] = measured.reason;
  } else {
    document["ratio"] = *measured.ratio;
    document["interval"] = {measured.interval.low, measured.interval.high};
    document["verdict"] = measured.met() ? "met" : "missed";
  }
  return document;
}

/// So many significant digits, trailing zeros left out: "0.22", "3.1e-05".
std::string digits(double value, int significant) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", significant, value);
  return text.data();
}

std::string cell_text(const MicroCell& cell) {
  switch (cell.outcome) {
    case MicroOutcome::timed:
      return three_digits(bench::median(cell.nanoseconds));
    case MicroOutcome::wrong_signs:
      return "!" + digits(cell.wrong_rate(), 2);
    case MicroOutcome::out_of_domain:
      return "refused";
    case MicroOutcome::at_fault:
      return "at fault";
  }
  return {};
}

/// "filter 81 %, double-double 19 %"; empty where one stage decides everything.
std::string stages_text(const MicroCell& cell) {
  std::string text;
  for (std::size_t s = 0; s < cell.stages.size(); ++s) {
    if (cell.stages[s] == cell.queries) return {};
    if (cell.stages[s] == 0) continue;
    const double share = 100 * static_cast<double>(cell.stages[s]) / static_cast<double>(cell.queries);
    text.append(text.empty() ? "" : ", ").append(stage_names[s]).append(" " + digits(share, 3) + " %");
  }
  return text;
}

std::string ratio_name(const bench::Goal& goal) {
  return std::string(goal.subject) + " / " + std::string(goal.rival) + ", " + std::string(goal.family) +
         ", " + std::string(to_string(goal.predicate));
}

/// One row per subject, one column per family; cells come family by family, subject by subject.
void print_times(Console& console, std::span<const MicroCell> cells, std::size_t subjects) {
  std::vector<std::vector<std::string>> table(1 + subjects);
  table[0].push_back(std::string(to_string(cells[0].predicate)) + ", ns");
  for (std::size_t i = 0; i < subjects; ++i) table[1 + i].push_back(cells[i].subject);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % subjects == 0) table[0].push_back(std::string(cells[i].family));
    table[1 + i % subjects].push_back(cell_text(cells[i]));
  }
  print_table(console, table);
  console.out << '\n';
}

void print_stages(Console& console, std::span<const MicroCell> cells) {
  std::vector<std::vector<std::string>> table{{"deciding stages", "predicate", "family", "share"}};
  for (const MicroCell& cell : cells)
    if (const std::string text = stages_text(cell); !text.empty())
      table.push_back({cell.subject, std::string(to_string(cell.predicate)), std::string(cell.family), text});
  if (table.size() == 1) return;
  print_table(console, table);
  console.out << '\n';
}

void print_goals(Console& console, std::span<const MeasuredGoal> goals) {
  if (goals.empty()) return;
  std::vector<std::vector<std::string>> table{{"ratio", "measured", "95 %", "goal", "verdict"}};
  for (const MeasuredGoal& measured : goals) {
    auto& row = table.emplace_back();
    row.push_back(ratio_name(measured.goal));
    if (measured.ratio)
      row.insert(row.end(), {three_digits(*measured.ratio), span_text(measured.interval)});
    else
      row.insert(row.end(), {"-", "-"});
    row.push_back("<= " + digits(measured.goal.at_most, 2));
    row.push_back(measured.ratio ? (measured.met() ? "met" : "missed") : measured.reason);
  }
  print_table(console, table);
}

void print_faults(Console& console, std::span<const MicroCell> cells) {
  std::map<std::string, std::string> first;
  for (const MicroCell& cell : cells)
    if (cell.outcome == MicroOutcome::at_fault) first.emplace(cell.subject, cell.reason);
  for (const auto& [subject, fault] : first)
    console.out << '\n' << subject << " is at fault and has no speed: " << fault << '\n';
}

}  // namespace

std::string three_digits(double value) {
  std::array<char, 32> text{};
  const int decimals = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string span_text(const bench::Interval& interval) {
  if (interval.low == interval.high) return "-";
  return three_digits(interval.low) + " to " + three_digits(interval.high);
}

json bench_document(const bench::PredicateBenchOptions& plan, std::span<const MicroCell> cells,
                    std::span<const MeasuredGoal> goals) {
  const json manifest = bench::make_manifest({});
  json document{{"build", manifest.at("build")},
                {"machine", manifest.at("machine")},
                {"queries", plan.queries},
                {"repetitions", plan.stopwatch.rounds},
                {"seed", plan.seed},
                {"cells", json::array()},
                {"ratios", json::array()}};
  for (const MicroCell& cell : cells) document["cells"].push_back(cell_document(cell));
  for (const MeasuredGoal& measured : goals) document["ratios"].push_back(goal_document(measured));
  return document;
}

void print_bench(Console& console, const bench::PredicateBenchOptions& plan, std::span<const MicroCell> cells,
                 std::span<const MeasuredGoal> goals) {
  const std::size_t block = plan.subjects.size() * plan.families.size();
  for (std::size_t first = 0; first < cells.size(); first += block)  // the last is shorter after an interrupt
    print_times(console, cells.subspan(first, std::min(block, cells.size() - first)), plan.subjects.size());
  print_stages(console, cells);
  print_goals(console, goals);
  print_faults(console, cells);
  console.out << "\nns per query: median of " << plan.stopwatch.rounds << " rounds over " << plan.queries
              << " queries. !rate: wrong signs, hence no speed. refused: outside the domain.\n";
}

}  // namespace tribunal::cli
