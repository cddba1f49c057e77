#include "reports/html.hpp"
#include "reports/page/chart.hpp"
#include "reports/page/sections.hpp"

namespace tribunal::reports {

std::string scaling_section(const ReportInput& input) {
  std::string html =
      "<section aria-labelledby=\"scaling\"><h2 id=\"scaling\">Scaling</h2><p>Counts against rival laws of "
      "growth, fitted "
      "with relative residuals and compared by AICc: a difference of 6 is odds of 20 to 1. Times are shown "
      "and never "
      "judged.</p>\n";
  bool any = false;
  for (const Tried& trial : input.trials) {
    if (trial.claim.rule.judge != "growth-model" || trial.judgement.figures.empty()) continue;
    any = true;
    html += "<h3>" + escape(trial.claim.title) + " <a class=\"more-link\" href=\"#claim-" +
            html_id(trial.claim.id) + "\">" + escape(trial.claim.id) + ", " +
            std::string(to_string(trial.judgement.verdict)) + "</a></h3><div class=\"pair\">";
    for (const Figure& figure : trial.judgement.figures) html += chart(figure);
    html += "</div>\n";
  }
  if (!any) html += "<p class=\"absent\">No claim about growth was tried.</p>";
  return html + "</section>\n";
}

}  // namespace tribunal::reports
