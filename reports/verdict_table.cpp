#include "reports/text.hpp"
#include "reports/trial.hpp"

#include <algorithm>
#include <array>

namespace tribunal::reports {
namespace {

using Line = std::array<std::string, 6>;

std::string value_text(const std::optional<double>& value) { return value ? number_text(*value) : "-"; }

std::string interval_text(const Judgement& judgement) {
  if (!judgement.interval) return "";
  return concat("[", number_text(judgement.interval->low), ", ", number_text(judgement.interval->high), "]");
}

Line line(const Tried& trial) {
  const Judgement& judgement = trial.judgement;
  std::string verdict(to_string(judgement.verdict));
  if (!trial.as_expected()) verdict += " (!)";
  return {trial.claim.id,
          verdict,
          value_text(judgement.measured),
          interval_text(judgement),
          value_text(judgement.bound),
          trial.claim.title};
}

std::string summary(std::span<const Tried> trials) {
  std::array<std::size_t, 4> counts{};
  std::size_t surprises = 0;
  for (const Tried& trial : trials) {
    ++counts[static_cast<std::size_t>(trial.judgement.verdict)];
    surprises += trial.as_expected() ? 0 : 1;
  }
  std::string text = std::to_string(trials.size()) + (trials.size() == 1 ? " claim:" : " claims:");
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) text += concat(" ", std::to_string(counts[i]), " ", verdict_names[i], ",");
  const std::size_t untried = counts[static_cast<std::size_t>(Verdict::untried)];
  text.back() = untried > 0 && untried == trials.size() ? '.' : ';';
  if (text.back() == '.') return text + "\n";
  text += surprises == 0 ? concat(" all ", untried == 0 ? "" : "that were tried ", "as expected.")
                         : concat(" ", std::to_string(surprises), " not as expected, marked (!).");
  return concat(text,
                " Expected false refutations: ", number_text(family(trials).expected_false_refutations, 2),
                ".\n");
}

}  // namespace

std::string verdict_table(std::span<const Tried> trials) {
  std::vector<Line> lines{{"claim", "verdict", "measured", "interval", "bound", "about"}};
  std::string untried;
  for (const Tried& trial : trials)
    if (trial.judgement.verdict != Verdict::untried)
      lines.push_back(line(trial));
    else
      untried += concat(untried.empty() ? "untried: " : ", ", trial.claim.id);
  if (lines.size() == 1) return summary(trials);
  std::array<std::size_t, 6> widths{};
  for (const Line& cells : lines)
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  std::string table;
  for (const Line& cells : lines) {
    std::string row;
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
      const std::string space(widths[i] - cells[i].size() + 2, ' ');
      const bool number = i == 2 || i == 4;
      row += number ? space.substr(2) + cells[i] + "  " : cells[i] + space;
    }
    row += cells.back();
    table += row + "\n";
  }
  if (!untried.empty()) table += concat("\n", untried, "\n");
  return table + "\n" + summary(trials);
}

std::string evidence(std::span<const Tried> trials) {
  std::string text;
  for (const Tried& trial : trials) {
    text += concat("\n", trial.claim.id, ": ", trial.claim.statement, "\n  expected ",
                   to_string(trial.claim.expected), "; ", trial.claim.source, "\n");
    for (const std::string& line : trial.judgement.lines) text += concat("  ", line, "\n");
  }
  return text;
}

}  // namespace tribunal::reports
