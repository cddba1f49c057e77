#include "bench/fuzz/picture.hpp"

#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/ulps.hpp"
#include "datasets/files/numerals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tribunal::bench::fuzz {
namespace {

constexpr double panel = 330, margin = 25, top = 60;
constexpr int reach = 16, side = 2 * reach + 1;

/// name="value", rounded to hundredths of a pixel.
std::string attribute(const char* name, double value) {
  std::string text = std::string(" ") + name + "=\"";
  files::append_number(text, std::round(value * 100) / 100);
  return text + "\"";
}

std::string text_at(double x, double y, const std::string& text) {
  return "<text" + attribute("x", x) + attribute("y", y) + ">" + text + "</text>\n";
}

struct Location {
  double x, y;
};

/// The circle through three points, where doubles find one that fits a picture; a drawing, no predicate.
struct Circle {
  double x, y, radius;
};
std::optional<Circle> circle_through(Location a, Location b, Location c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double area = 2 * (bx * cy - by * cx);
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double ux = (cy * b2 - by * c2) / area, uy = (bx * c2 - cx * b2) / area;
  const double radius = std::sqrt(ux * ux + uy * uy);
  if (!(radius < 100 * panel)) return std::nullopt;
  return Circle{a.x + ux, a.y + uy, radius};
}

/// Each axis mapped on its own where their extents differ by more than a hundredfold: a line stays a line,
/// but a circle would not, and is left out.
class Frame {
 public:
  explicit Frame(const Case& asked) {
    for (int axis = 0; axis < 2; ++axis) {
      double low = asked.point(0)[axis], high = low;
      for (int i = 1; i < asked.points(); ++i) {
        low = std::min(low, asked.point(i)[axis]);
        high = std::max(high, asked.point(i)[axis]);
      }
      // Halves: the extent itself may overflow.
      middle_[axis] = low / 2 + high / 2;
      extent_[axis] = high / 2 - low / 2;
    }
    const double widest = std::max({extent_[0], extent_[1], 0x1p-1022});
    for (double& extent : extent_) {
      const bool own_scale = extent > 0 && extent < widest / 100;
      uniform_ = uniform_ && !own_scale;
      if (!own_scale) extent = widest;
    }
  }
  bool uniform() const { return uniform_; }
  Location place(std::span<const double> p) const {
    const double half = panel / 2 - margin;
    return {panel / 2 + half * ((p[0] - middle_[0]) / extent_[0]),
            top + panel / 2 - half * ((p[1] - middle_[1]) / extent_[1])};
  }

 private:
  std::array<double, 2> middle_{}, extent_{};
  bool uniform_ = true;
};

std::string points_panel(const Case& asked) {
  const Frame frame(asked);
  std::array<Location, 4> at{};
  for (int i = 0; i < asked.points(); ++i) at[i] = frame.place(asked.point(i));
  std::string svg;
  const auto circle =
      asked.points() == 4 && frame.uniform() ? circle_through(at[0], at[1], at[2]) : std::nullopt;
  if (circle) {
    svg += "<circle class=\"through\"" + attribute("cx", circle->x) + attribute("cy", circle->y) +
           attribute("r", circle->radius) + "/>\n";
  } else if (asked.points() == 3) {
    svg += "<line class=\"through\"" + attribute("x1", at[0].x) + attribute("y1", at[0].y) +
           attribute("x2", at[1].x) + attribute("y2", at[1].y) + "/>\n";
  }
  for (int i = 0; i < asked.points(); ++i) {
    svg += "<circle" + attribute("cx", at[i].x) + attribute("cy", at[i].y) + " r=\"4\"/>\n";
    // Equal points share a place: their letters stand in a row.
    svg += text_at(at[i].x + 6 + 9 * i, at[i].y - 6, std::string(1, "abcd"[i]));
  }
  if (!frame.uniform()) svg += text_at(margin, top + panel + 15, "axes scaled differently");
  return svg;
}

/// As in the sign maps of the report: right answers pale, wrong ones strong.
const char* colour_of(const Decision& got, Sign exact) {
  if (exact == Sign::zero && got.stage == Stage::symbolic) return "#5a5a60";
  if (got.sign == exact) {
    if (exact == Sign::zero) return "#5a5a60";
    return exact == Sign::positive ? "#cfe2f3" : "#fce5cd";
  }
  if (exact == Sign::zero) return "#009988";
  return got.sign == Sign::zero ? "#cc3311" : "#000000";
}

std::string map_panel(const Case& asked, const Subject& subject, double left) {
  const double pixel = (panel - 2 * margin) / side;
  std::string svg;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      Case moved = asked;
      const auto last = moved.point(moved.points() - 1);
      last[0] = moved_by_ulps(last[0], x);
      last[1] = moved_by_ulps(last[1], y);
      const auto got = decide_alone(subject, moved);
      if (!got) continue;
      svg += "<rect" + attribute("x", left + margin + (x + reach) * pixel) +
             attribute("y", top + margin + (reach - y) * pixel) + attribute("width", pixel) +
             attribute("height", pixel) + " fill=\"" + colour_of(*got, exact_sign(moved)) + "\"/>\n";
    }
  svg += text_at(left + margin, top + panel + 15, "the last point moved by -16..16 ulps in x and y");
  svg +=
      text_at(left + margin, top + panel + 30, "red: falsely zero, black: inverted, green: falsely nonzero");
  return svg;
}

}  // namespace

std::string picture_of(const Counterexample& counterexample, const Subject& subject) {
  const Case& asked = counterexample.asked;
  const double left = asked.dimension() == 2 ? panel : 0;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", left + 2 * panel) +
                    attribute("height", top + panel + 2 * margin) +
                    ">\n<style>text{font:11px "
                    "monospace}rect{shape-rendering:crispEdges}.through{fill:none;stroke:#888}</style>\n";
  svg += text_at(margin, 20,
                 counterexample.backend + ": " + std::string(to_string(asked.predicate)) + " is " +
                     to_char(counterexample.got) + ", exactly " + to_char(counterexample.exact));
  svg += text_at(margin, 38, "tribunal sign " + query_text(asked));
  if (asked.dimension() == 2) svg += points_panel(asked);
  return svg + map_panel(asked, subject, left) + "</svg>\n";
}

}  // namespace tribunal::bench::fuzz
