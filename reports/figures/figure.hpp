// A chart as data: drawn once as static SVG and once as an interactive Vega-Lite specification.
#pragma once

#include <string>
#include <vector>

namespace tribunal::reports {

struct Axis {
  std::string title;
  bool log = false;  ///< all values on this axis are then positive
};

/// One point with the interval it may lie in; low = high = y where there is none.
struct Datum {
  double x = 0;
  double y = 0;
  double low = 0;
  double high = 0;
};

enum class Mark { points, line, dashed };

/// Data that belong together and share a name in the legend.
struct Series {
  std::string name;
  Mark mark = Mark::points;
  std::vector<Datum> data;
};

struct Figure {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
};

/// A datum without an interval.
inline Datum datum(double x, double y) { return {x, y, y, y}; }

}  // namespace tribunal::reports
