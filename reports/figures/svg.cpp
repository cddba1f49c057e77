#include "reports/figures/svg.hpp"

#include "reports/figures/scale.hpp"
#include "reports/html.hpp"
#include "reports/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribunal::reports {
namespace {

constexpr double width = 640, height = 320;
constexpr double left = 68, right = 16, top = 12, bottom = 46;

std::string coordinate(double value) { return fixed_text(value, 1); }

bool shown(const Datum& d, const Figure& figure) {
  return std::isfinite(d.x) && std::isfinite(d.y) && (!figure.x.log || d.x > 0) && (!figure.y.log || d.y > 0);
}

std::string curve(Mark mark, std::size_t index, const std::string& path) {
  const std::string dash = mark == Mark::dashed ? concat(" dash-", std::to_string(index % 4)) : "";
  return concat("<path class=\"curve", dash, "\" d=\"", path, "\"/>");
}

struct Range {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

class Drawing {
 public:
  explicit Drawing(const Figure& figure) : figure_(figure), x_(x_scale()), y_(y_scale()) {}

  std::string draw() {
    text_ = "<svg viewBox=\"0 0 640 320\" role=\"img\" aria-label=\"" + escape(figure_.title) + "\">";
    draw_axes();
    for (std::size_t i = 0; i < figure_.series.size(); ++i) draw_series(figure_.series[i], i);
    return text_ + "</svg>";
  }

 private:
  Scale x_scale() const {
    Range range;
    for (const Series& series : figure_.series)
      for (const Datum& d : series.data)
        if (shown(d, figure_)) range.add(d.x);
    if (range.low > range.high) range = {1, 10};
    return {range.low, range.high, figure_.x.log, left + 8, width - right - 8};
  }

  /// Points and solid lines set the range; a rival's dashed curve may leave it, but by no more than as much
  /// again.
  Scale y_scale() const {
    Range range;
    for (const Series& series : figure_.series)
      for (const Datum& d : series.data) {
        if (!shown(d, figure_) || series.mark == Mark::dashed) continue;
        range.add(d.y);
        if (std::isfinite(d.low) && (!figure_.y.log || d.low > 0)) range.add(d.low);
        if (std::isfinite(d.high)) range.add(d.high);
      }
    if (range.low > range.high) range = {1, 10};
    const Range core = range;
    const double slack =
        core.high > core.low ? core.high - core.low : std::max(1e-12, std::abs(core.high) / 10);
    for (const Series& series : figure_.series)
      for (const Datum& d : series.data)
        if (shown(d, figure_))
          range.add(std::clamp(d.y, figure_.y.log ? core.low / 3 : core.low - slack, core.high + slack));
    return {range.low, range.high, figure_.y.log, height - bottom, top};
  }

  void draw_axes() {
    for (const double tick : y_.ticks()) {
      const std::string y = coordinate(y_.at(tick));
      text_ += "<line class=\"grid\" x1=\"" + coordinate(left) + "\" x2=\"" + coordinate(width - right) +
               "\" y1=\"" + y + "\" y2=\"" + y + "\"/><text class=\"tick\" text-anchor=\"end\" x=\"" +
               coordinate(left - 8) + "\" y=\"" + coordinate(y_.at(tick) + 4) + "\">" + number_text(tick) +
               "</text>";
    }
    for (const double tick : x_.ticks())
      text_ += "<text class=\"tick\" text-anchor=\"middle\" x=\"" + coordinate(x_.at(tick)) + "\" y=\"" +
               coordinate(height - bottom + 18) + "\">" + number_text(tick) + "</text>";
    text_ += "<line class=\"axis\" x1=\"" + coordinate(left) + "\" x2=\"" + coordinate(width - right) +
             "\" y1=\"" + coordinate(height - bottom) + "\" y2=\"" + coordinate(height - bottom) + "\"/>";
    text_ += "<text class=\"axis-title\" text-anchor=\"middle\" x=\"" +
             coordinate((left + width - right) / 2) + "\" y=\"" + coordinate(height - 8) + "\">" +
             escape(figure_.x.title) + "</text>";
    const std::string middle = coordinate((top + height - bottom) / 2);
    text_ += "<text class=\"axis-title\" text-anchor=\"middle\" transform=\"rotate(-90 14 " + middle +
             ")\" x=\"14\" y=\"" + middle + "\">" + escape(figure_.y.title) + "</text>";
  }

  bool inside(const Datum& d) const {
    const double y = y_.at(d.y);
    return shown(d, figure_) && y >= top - 1 && y <= height - bottom + 1;
  }

  void draw_series(const Series& series, std::size_t index) {
    text_ += "<g class=\"series-" + std::to_string(index % 8) + "\">";
    if (series.mark == Mark::points) {
      for (const Datum& d : series.data)
        if (inside(d)) draw_point(d, index);
    } else {
      draw_line(series, index);
    }
    text_ += "</g>";
  }

  void draw_line(const Series& series, std::size_t index) {
    std::string path;
    for (const Datum& d : series.data)
      if (inside(d))
        path += concat(path.empty() ? "M" : "L", coordinate(x_.at(d.x)), " ", coordinate(y_.at(d.y)));
    if (path.empty()) return;
    text_ += curve(series.mark, index, path);
  }

  void draw_point(const Datum& d, std::size_t index) {
    const std::string x = coordinate(x_.at(d.x));
    if (d.low < d.high && (!figure_.y.log || d.low > 0))
      text_ += "<line class=\"whisker\" x1=\"" + x + "\" x2=\"" + x + "\" y1=\"" + coordinate(y_.at(d.low)) +
               "\" y2=\"" + coordinate(y_.at(d.high)) + "\"/>";
    text_ += marker(x_.at(d.x), y_.at(d.y), index);
  }

 public:
  /// Circle, square, triangle, diamond: told apart without colour.
  static std::string marker(double x, double y, std::size_t index) {
    constexpr std::array<const char*, 4> shapes{"M-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z",
                                                "M-3.6-3.6h7.2v7.2h-7.2z", "M0-4.6L4.4 3.4H-4.4z",
                                                "M0-5L5 0L0 5L-5 0z"};
    return "<path class=\"marker\" transform=\"translate(" + coordinate(x) + " " + coordinate(y) +
           ")\" d=\"" + shapes[index % shapes.size()] + "\"/>";
  }

 private:
  const Figure& figure_;
  Scale x_;
  Scale y_;
  std::string text_;
};

}  // namespace

std::string svg(const Figure& figure) { return Drawing(figure).draw(); }

std::string svg_swatch(Mark mark, std::size_t index) {
  std::string text = "<svg class=\"swatch\" viewBox=\"0 0 28 12\" aria-hidden=\"true\"><g class=\"series-" +
                     std::to_string(index % 8) + "\">";
  if (mark == Mark::points)
    text += Drawing::marker(14, 6, index);
  else
    text += curve(mark, index, "M1 6H27");
  return text + "</g></svg>";
}

}  // namespace tribunal::reports
