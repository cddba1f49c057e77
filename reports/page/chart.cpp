#include "reports/page/chart.hpp"

#include "reports/figures/svg.hpp"
#include "reports/figures/vega_lite.hpp"
#include "reports/html.hpp"

#include <nlohmann/json.hpp>

namespace tribunal::reports {

std::string chart(const Figure& figure) {
  std::string html = "<figure class=\"chart\"><figcaption>" + escape(figure.title) +
                     "</figcaption><div class=\"static\">" + svg(figure) + "</div><ul class=\"legend\">";
  for (std::size_t i = 0; i < figure.series.size(); ++i)
    html += "<li data-series=\"" + escape(figure.series[i].name) + "\">" +
            svg_swatch(figure.series[i].mark, i) + escape(figure.series[i].name) + "</li>";
  html += "</ul><script type=\"application/json\">" + script_json(vega_lite(figure)) + "</script></figure>\n";
  return html;
}

}  // namespace tribunal::reports
