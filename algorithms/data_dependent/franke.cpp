#include "algorithms/data_dependent/franke.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal {
namespace {

double square(double x) { return x * x; }
double squared_radius(const Point2& p) { return square(p[0] - 0.5) + square(p[1] - 0.5); }

double humps(const Point2& p) {
  const double x = 9 * p[0], y = 9 * p[1];
  return 0.75 * std::exp(-(square(x - 2) + square(y - 2)) / 4) +
         0.75 * std::exp(-square(x + 1) / 49 - (y + 1) / 10) +
         0.5 * std::exp(-(square(x - 7) + square(y - 3)) / 4) -
         0.2 * std::exp(-square(x - 4) - square(y - 7));
}
double cliff(const Point2& p) { return (std::tanh(9 * p[1] - 9 * p[0]) + 1) / 9; }
double saddle(const Point2& p) { return (1.25 + std::cos(5.4 * p[1])) / (6 + 6 * square(3 * p[0] - 1)); }
double gentle_hill(const Point2& p) { return std::exp(-81.0 / 16 * squared_radius(p)) / 3; }
double steep_hill(const Point2& p) { return std::exp(-81.0 / 4 * squared_radius(p)) / 3; }
double sphere(const Point2& p) { return std::sqrt(std::max(0.0, 64 - 81 * squared_radius(p))) / 9 - 0.5; }

}  // namespace

const std::array<FrankeFunction, 6>& franke_functions() {
  static constexpr std::array<FrankeFunction, 6> all{{{"F1", humps},
                                                      {"F2", cliff},
                                                      {"F3", saddle},
                                                      {"F4", gentle_hill},
                                                      {"F5", steep_hill},
                                                      {"F6", sphere}}};
  return all;
}

std::vector<double> sample(const FrankeFunction& function, std::span<const Point2> points) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const Point2& p : points) values.push_back(function.value(p));
  return values;
}

}  // namespace tribunal
