#include "reports/page/page.hpp"

#include "reports/embedded.hpp"
#include "reports/html.hpp"
#include "reports/page/sections.hpp"

#include <array>
#include <cassert>

namespace tribunal::reports {
namespace {

std::string_view resource(std::string_view name) {
  for (const EmbeddedFile& file : embedded_page())
    if (file.name == name) return file.text;
  assert(false);
  return {};
}

/// Nothing may be fetched, and no inline script may reach out: what the page needs is in it.
constexpr std::string_view policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri "
    "'none'; "
    "form-action 'none'";

std::string head() {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"";
  html += policy;
  html +=
      "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>Tribunal: report</title>\n<style>\n";
  html += resource("style.css");
  return html + "</style>\n</head>\n";
}

/// The three facts a reader asks for first; the manifest's other ones are under "Provenance".
std::string subtitle(const ReportInput& input) {
  std::string text = std::to_string(input.rows.size()) + " result rows";
  constexpr std::array<std::array<const char*, 2>, 3> facts{
      {{"build", "commit"}, {"build", "compiler"}, {"machine", "cpu"}}};
  for (const auto& [group, key] : facts) {
    const auto pointer = nlohmann::json::json_pointer(std::string("/") + group + "/" + key);
    if (!input.manifest.contains(pointer) || !input.manifest.at(pointer).is_string()) continue;
    const auto value = input.manifest.at(pointer).get<std::string>();
    text += " \xC2\xB7 ";  // a middle dot
    text += std::string(key) == "commit" ? "commit " + value.substr(0, 12) : value;
  }
  return text;
}

constexpr std::array<std::array<const char*, 2>, 9> contents{{{"verdicts", "Verdicts"},
                                                              {"claims", "Claims"},
                                                              {"outcomes", "Outcomes"},
                                                              {"tau", "Triangles"},
                                                              {"scaling", "Scaling"},
                                                              {"maps", "Sign maps"},
                                                              {"timings", "Timings"},
                                                              {"failures", "Failures"},
                                                              {"provenance", "Provenance"}}};

std::string header(const ReportInput& input) {
  std::string html =
      "<a class=\"skip\" href=\"#verdicts\">Skip to the verdicts</a>\n<header><h1>Tribunal</h1><p "
      "class=\"subtitle\">Geometric predicates and triangulation algorithms on trial</p><p class=\"meta\">" +
      escape(subtitle(input)) + "</p></header>\n<nav aria-label=\"Sections\"><ul>";
  for (const auto& [id, title] : contents)
    html += std::string("<li><a href=\"#") + id + "\">" + title + "</a></li>";
  return html + "</ul></nav>\n";
}

/// Libraries first: the page's own script uses them where they are and is content where they are not.
std::string scripts() {
  std::string html;
  for (const EmbeddedFile& library : embedded_charting()) {
    html += "<script>";
    html += library.text;
    html += "</script>\n";
  }
  html += "<script>\n";
  html += resource("script.js");
  return html + "</script>\n";
}

}  // namespace

std::string page(const ReportInput& input) {
  return head() + "<body>\n" + header(input) + "<main>\n" + verdict_strip(input) + claims_section(input) +
         outcomes_section(input) + tau_section(input) + scaling_section(input) + sign_maps_section(input) +
         predicate_timings_section(input) + failures_section(input) + provenance_section(input) +
         "</main>\n" + scripts() + "</body>\n</html>\n";
}

}  // namespace tribunal::reports
