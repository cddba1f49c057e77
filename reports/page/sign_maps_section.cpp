#include "reports/figures/sign_map.hpp"
#include "reports/html.hpp"
#include "reports/page/sections.hpp"
#include "reports/text.hpp"

#include <array>
#include <map>

namespace tribunal::reports {
namespace {

constexpr std::array<const char*, pixel_kinds> names{"+",          "-",        "0 (the line)",
                                                     "false zero", "inverted", "false non-zero"};

std::string legend() {
  std::string html = "<ul class=\"legend\">";
  for (std::size_t i = 0; i < pixel_kinds; ++i) {
    const auto& [red, green, blue] = pixel_colours[i];
    html +=
        "<li><svg class=\"chip\" viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect width=\"1\" height=\"1\" "
        "fill=\"rgb(" +
        std::to_string(red) + "," + std::to_string(green) + "," + std::to_string(blue) + ")\"/></svg>" +
        names[i] + "</li>";
  }
  return html + "</ul>";
}

std::string text_of(const bench::Row& row, const char* name) {
  const auto found = row.texts.find(name);
  return found == row.texts.end() ? "" : found->second;
}

std::string count_text(const bench::Row& row, const char* name) {
  const auto found = row.counters.find(name);
  return found == row.counters.end() ? "?" : number_text(found->second);
}

std::string map_html(const bench::Row& row) {
  const auto map = sign_map(text_of(row, "signs"), text_of(row, "exact"));
  std::string html = "<figure class=\"map\">";
  const std::string wrong = count_text(row, "wrong");
  if (map)
    html += "<img alt=\"Signs of " + escape(row.cell.backend) + ", " + wrong +
            " of them wrong\" width=\"256\" height=\"256\" src=\"data:image/png;base64," + base64(png(*map)) +
            "\">";
  else
    html += "<p class=\"absent\">" +
            escape(row.outcome == "ok" ? "no map in this row" : row.outcome + ": " + row.reason) + "</p>";
  html += "<figcaption><strong>" + escape(row.cell.backend) + "</strong>";
  if (map)
    html += "<span>" +
            (wrong == "0" ? "every sign right"
                          : count_text(row, "false_zero") + " false zeros, " + count_text(row, "inverted") +
                                " inverted, " + count_text(row, "false_nonzero") + " false non-zeros") +
            "</span>";
  return html + "</figcaption></figure>\n";
}

}  // namespace

std::string sign_maps_section(const ReportInput& input) {
  std::map<std::string, std::string> maps;  // by figure
  for (const bench::Row& row : input.rows) {
    if (row.cell.task != "sign-map") continue;
    const auto figure = row.cell.parameters.find("figure");
    maps[figure == row.cell.parameters.end() ? "" : figure->second] += map_html(row);
  }
  std::string html =
      "<section aria-labelledby=\"maps\"><h2 id=\"maps\">Sign maps</h2><p>orient2d(p, q, r) for 256 x 256 "
      "neighbouring "
      "doubles p and two fixed far points, after Kettner, Mehlhorn, Pion, Schirra and Yap (2008). Pale is "
      "right; every "
      "strong colour is a wrong sign.</p>\n";
  if (maps.empty()) return html + "<p class=\"absent\">No sign map was run.</p></section>\n";
  html += legend();
  for (const auto& [figure, images] : maps)
    html += "<h3>Figure " + escape(figure) + "</h3><div class=\"maps\">" + images + "</div>\n";
  return html + "</section>\n";
}

}  // namespace tribunal::reports
