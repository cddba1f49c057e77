#include "reports/html.hpp"
#include "reports/page/chart.hpp"
#include "reports/page/sections.hpp"
#include "reports/text.hpp"

#include <array>
#include <cmath>

namespace tribunal::reports {
namespace {

/// A verdict is a word and a glyph before it is a colour.
constexpr std::array<const char*, 4> glyphs{"&#10003;", "&#10007;", "?", "&#8211;"};

std::string badge(Verdict verdict) {
  const std::string name(to_string(verdict));
  return "<span class=\"badge " + name + "\"><span class=\"glyph\" aria-hidden=\"true\">" +
         glyphs[static_cast<std::size_t>(verdict)] + "</span>" + name + "</span>";
}

bool is_tried(const Tried& trial) { return trial.judgement.verdict != Verdict::untried; }

std::string expectation(const Tried& trial) {
  if (trial.as_expected()) return "as expected";
  return "expected: " + std::string(to_string(trial.claim.expected));
}

std::string interval_text(const Judgement& judgement) {
  if (!judgement.interval) return "";
  return concat("[", number_text(judgement.interval->low), ", ", number_text(judgement.interval->high), "]");
}

std::string tile(const Tried& trial) {
  const Judgement& judgement = trial.judgement;
  return "<li class=\"tile " + std::string(to_string(judgement.verdict)) +
         (trial.as_expected() ? "" : " surprise") + "\"><a href=\"#claim-" + html_id(trial.claim.id) +
         "\"><span class=\"tile-id\">" + escape(trial.claim.id) + "</span><span class=\"tile-title\">" +
         escape(trial.claim.title) + "</span>" + badge(judgement.verdict) + "<span class=\"tile-note\">" +
         expectation(trial) + "</span></a></li>\n";
}

std::string value_cell(const std::optional<double>& value) {
  if (!value) return "<td class=\"number\">&#8211;</td>";
  return "<td class=\"number\">" + number_text(*value) + "</td>";
}

std::string evidence(const Tried& trial, double adjusted) {
  const Judgement& judgement = trial.judgement;
  std::string html = "<ul class=\"reasons\">";
  for (const std::string& line : judgement.lines) html += "<li>" + escape(line) + "</li>";
  if (judgement.p_value)
    html += "<li>Against the claim: p = " + number_text(*judgement.p_value, 3) +
            (std::isnan(adjusted) ? "" : ", after Holm's adjustment " + number_text(adjusted, 3)) + ".</li>";
  html += "</ul>";
  // What grew how is shown at full width under "Scaling", once.
  if (trial.claim.rule.judge != "growth-model")
    for (const Figure& figure : judgement.figures) html += chart(figure);
  return html;
}

std::string row(const Tried& trial, double adjusted) {
  const Claim& claim = trial.claim;
  const Judgement& judgement = trial.judgement;
  std::string html =
      "<tbody id=\"claim-" + html_id(claim.id) + "\"" + (trial.as_expected() ? "" : " class=\"surprise\"") +
      "><tr><th scope=\"row\">" + escape(claim.id) + "</th><td class=\"statement\"><strong>" +
      escape(claim.title) + "</strong> " + escape(claim.statement) + "<cite>" + escape(claim.source) +
      "</cite></td><td>" + badge(judgement.verdict) + "<span class=\"note\">" + expectation(trial) +
      "</span></td>" + value_cell(judgement.measured) + "<td class=\"number\">" + interval_text(judgement) +
      "</td>" + value_cell(judgement.bound) + "</tr>";
  html += "<tr class=\"more\"><td></td><td colspan=\"5\"><details><summary>";
  html += judgement.quantity.empty() ? "Evidence" : "Evidence: " + escape(judgement.quantity);
  html += "</summary>" + evidence(trial, adjusted) + "</details><p class=\"repeat\">Repeat: <code>" +
          escape(trial.command) + "</code></p></td></tr></tbody>\n";
  return html;
}

/// Claims that these rows say nothing about, by name only.
std::string untried_line(const ReportInput& input) {
  std::string names;
  for (const Tried& trial : input.trials)
    if (!is_tried(trial)) names += (names.empty() ? "" : ", ") + escape(trial.claim.id);
  if (names.empty()) return "";
  return "<p class=\"absent\">Not tried, since these rows lack some of their cells: " + names + ".</p>\n";
}

}  // namespace

std::string verdict_strip(const ReportInput& input) {
  std::array<std::size_t, 4> counts{};
  std::size_t surprises = 0;
  for (const Tried& trial : input.trials) {
    ++counts[static_cast<std::size_t>(trial.judgement.verdict)];
    surprises += trial.as_expected() ? 0 : 1;
  }
  std::string html =
      "<section aria-labelledby=\"verdicts\"><h2 id=\"verdicts\">Verdicts</h2><p class=\"lead\">";
  html += std::to_string(input.trials.size()) + (input.trials.size() == 1 ? " claim" : " claims");
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) html += ", " + std::to_string(counts[i]) + " " + std::string(verdict_names[i]);
  const std::size_t untried = counts[static_cast<std::size_t>(Verdict::untried)];
  if (surprises > 0)
    html += "; <strong class=\"alarm\">" + std::to_string(surprises) +
            " against the registered expectation</strong>";
  else if (untried == 0)
    html += "; <strong>all as registered beforehand</strong>";
  else if (untried < input.trials.size())
    html += "; <strong>all that were tried as registered beforehand</strong>";
  html += ".";
  html += " A claim registered as a misprint is expected to be refuted.</p>\n<ul class=\"strip\">";
  for (const Tried& trial : input.trials)
    if (is_tried(trial)) html += tile(trial);
  return html + "</ul></section>\n";
}

std::string claims_section(const ReportInput& input) {
  const Family all = family(input.trials);
  std::string rows;
  for (std::size_t i = 0; i < input.trials.size(); ++i)
    if (is_tried(input.trials[i])) rows += row(input.trials[i], all.adjusted[i]);
  std::string html = "<section aria-labelledby=\"claims\"><h2 id=\"claims\">Claims</h2>";
  if (!rows.empty())
    html +=
        "<p>Each claim was fixed with its cells, seeds and rule before it was tried. Were all of them "
        "true, " +
        number_text(all.expected_false_refutations, 2) +
        " would be refuted by chance.</p>\n<div class=\"scroll\"><table class=\"claims\"><thead><tr>"
        "<th scope=\"col\">id</th><th scope=\"col\">statement</th><th scope=\"col\">verdict</th>"
        "<th scope=\"col\" class=\"number\">measured</th><th scope=\"col\" class=\"number\">interval</th>"
        "<th scope=\"col\" class=\"number\">bound</th></tr></thead>\n" +
        rows + "</table></div>";
  return html + untried_line(input) + "</section>\n";
}

}  // namespace tribunal::reports
