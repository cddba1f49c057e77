#include "reports/embedded.hpp"
#include "reports/html.hpp"
#include "reports/page/sections.hpp"

namespace tribunal::reports {
namespace {

std::string value_html(const nlohmann::json& value) {
  if (value.is_string()) return escape(value.get<std::string>());
  return escape(value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

std::string licences() {
  std::string html;
  for (const EmbeddedFile& licence : embedded_licences())
    html += "<details><summary>Licence of a charting library in this page</summary><pre>" +
            escape(licence.text) + "</pre></details>\n";
  return html;
}

}  // namespace

std::string provenance_section(const ReportInput& input) {
  std::string html =
      "<section aria-labelledby=\"provenance\"><h2 id=\"provenance\">Provenance</h2><p>Counters and verdicts "
      "repeat "
      "exactly on any machine; times hold for this one.</p>\n<div class=\"scroll\"><table "
      "class=\"manifest\"><tbody>\n";
  html += "<tr><th scope=\"row\">result rows</th><td>" + std::to_string(input.rows.size()) + "</td></tr>\n";
  if (input.manifest.is_object())
    for (const auto& [key, value] : input.manifest.items()) {
      if (!value.is_object()) {
        html += "<tr><th scope=\"row\">" + escape(key) + "</th><td>" + value_html(value) + "</td></tr>\n";
        continue;
      }
      for (const auto& [inner, detail] : value.items())
        html += "<tr><th scope=\"row\">" + escape(key + " / " + inner) + "</th><td>" + value_html(detail) +
                "</td></tr>\n";
    }
  return html + "</tbody></table></div>" + licences() + "</section>\n";
}

}  // namespace tribunal::reports
