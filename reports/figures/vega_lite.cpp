#include "reports/figures/vega_lite.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace tribunal::reports {
namespace {

using nlohmann::json;

const char* kind(Mark mark) { return mark == Mark::points ? "points" : "line"; }

json values(const Figure& figure) {
  json data = json::array();
  for (const Series& series : figure.series)
    for (const Datum& d : series.data) {
      if (!std::isfinite(d.x) || !std::isfinite(d.y)) continue;
      if ((figure.x.log && d.x <= 0) || (figure.y.log && d.y <= 0)) continue;
      data.push_back({{"series", series.name}, {"kind", kind(series.mark)}, {"x", d.x}, {"y", d.y}});
      const bool interval = std::isfinite(d.low) && std::isfinite(d.high) && d.low < d.high;
      if (interval) data.back().update({{"low", d.low}, {"high", d.high}});
    }
  return data;
}

json axis(const Axis& axis, const char* field) {
  json encoding = {
      {"field", field}, {"type", "quantitative"}, {"title", axis.title}, {"scale", {{"zero", false}}}};
  if (axis.log) encoding["scale"] = {{"type", "log"}, {"nice", false}, {"padding", 14}};
  return encoding;
}

json names(const Figure& figure) {
  json domain = json::array();
  for (const Series& series : figure.series) domain.push_back(series.name);
  return domain;
}

/// Solid for points and fits, one dash pattern after the other for rivals and bounds: as in the static chart.
json dashes(const Figure& figure) {
  const json patterns = {{6, 4}, {2, 3}, {9, 3, 2, 3}, {12, 4}};
  json range = json::array();
  for (std::size_t i = 0; i < figure.series.size(); ++i)
    range.push_back(figure.series[i].mark == Mark::dashed ? patterns[i % patterns.size()] : json{1, 0});
  return range;
}

bool any(const Figure& figure, bool lines) {
  for (const Series& series : figure.series)
    if ((series.mark != Mark::points) == lines && !series.data.empty()) return true;
  return false;
}

/// Colour, shape and dashes of a series. No legend: the page has one of its own, which serves the static
/// chart too.
json channel(const Figure& figure, json range = nullptr) {
  json scale = {{"domain", names(figure)}};
  if (!range.is_null()) scale["range"] = std::move(range);
  return {{"field", "series"}, {"type", "nominal"}, {"legend", nullptr}, {"scale", std::move(scale)}};
}

/// Points or lines; what the reader did not pick in the legend (parameter `picked`) fades.
json layer(const Figure& figure, const char* wanted, json mark) {
  const json faded = {{"condition", {{"test", "picked === '' || picked === datum.series"}, {"value", 1}}},
                      {"value", 0.12}};
  json layer = {{"mark", std::move(mark)},
                {"encoding",
                 {{"x", axis(figure.x, "x")},
                  {"y", axis(figure.y, "y")},
                  {"color", channel(figure)},
                  {"opacity", faded}}}};
  layer["transform"] = json::array();
  layer["transform"].push_back({{"filter", std::string("datum.kind === '") + wanted + "'"}});
  return layer;
}

json whiskers(const Figure& figure) {
  json result = layer(figure, "points", {{"type", "rule"}, {"clip", true}});
  result["transform"].push_back({{"filter", "isValid(datum.low)"}});
  result["encoding"]["y"]["field"] = "low";
  result["encoding"]["y2"] = {{"field", "high"}};
  return result;
}

json tooltip(const Figure& figure) {
  const auto number = [](const char* field, const std::string& title) -> json {
    return {{"field", field}, {"type", "quantitative"}, {"title", title}, {"format", ",.6~g"}};
  };
  json fields = json::array();
  fields.push_back({{"field", "series"}, {"type", "nominal"}, {"title", "series"}});
  fields.push_back(number("x", figure.x.title));
  fields.push_back(number("y", figure.y.title));
  return fields;
}

}  // namespace

json vega_lite(const Figure& figure) {
  json spec = {
      {"width", "container"}, {"height", 270}, {"autosize", {{"type", "fit"}, {"contains", "padding"}}}};
  spec["data"]["values"] = values(figure);
  spec["params"] = json::array();
  spec["params"].push_back({{"name", "picked"}, {"value", ""}});
  spec["layer"] = json::array();
  // A layer without data would have no extent to scale to.
  if (any(figure, true)) {
    json lines = layer(figure, "line", {{"type", "line"}, {"clip", true}, {"strokeWidth", 2}});
    lines["encoding"]["strokeDash"] = channel(figure, dashes(figure));
    lines["encoding"]["tooltip"] = tooltip(figure);
    spec["layer"].push_back(std::move(lines));
  }
  if (any(figure, false)) {
    for (const json& value : spec["data"]["values"])
      if (value.contains("low")) {
        spec["layer"].push_back(whiskers(figure));
        break;
      }
    json points = layer(figure, "points", {{"type", "point"}, {"filled", true}, {"size", 55}});
    points["encoding"]["shape"] =
        channel(figure, json::array({"circle", "square", "triangle-up", "diamond"}));
    points["encoding"]["tooltip"] = tooltip(figure);
    spec["layer"].push_back(std::move(points));
  }
  return spec;
}

}  // namespace tribunal::reports
