#include "reports/figures/scale.hpp"

#include <cmath>

namespace tribunal::reports {
namespace {

/// The smallest of 1, 2, 5, 10, ... times a power of ten that is at least `step`.
double round_up(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= step * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

}  // namespace

Scale::Scale(double low, double high, bool log, double from, double to)
    : low_(low), high_(high), log_(log), from_(from), to_(to) {
  if (!(high_ > low_)) {
    low_ = log_ ? low / 2 : low - 1;
    high_ = log_ ? high * 2 : high + 1;
  }
  log_ ? log_ticks() : linear_ticks();
}

double Scale::at(double value) const {
  const double share =
      log_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
  return from_ + share * (to_ - from_);
}

void Scale::linear_ticks() {
  constexpr double about = 5;
  const double step = round_up((high_ - low_) / about);
  const double first = std::floor(low_ / step + 1e-9);
  const double last = std::ceil(high_ / step - 1e-9);
  low_ = first * step;
  high_ = last * step;
  const auto steps = static_cast<int>(last - first);
  for (int k = 0; k <= steps; ++k) ticks_.push_back((first + k) * step);
}

void Scale::log_ticks() {
  const bool wide = std::log10(high_ / low_) >= 3;
  const auto first = static_cast<int>(std::floor(std::log10(low_)));
  const auto last = static_cast<int>(std::ceil(std::log10(high_)));
  for (int exponent = first; exponent <= last; ++exponent)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = factor * std::pow(10.0, exponent);
      if (wide && factor != 1) continue;
      if (tick >= low_ * (1 - 1e-9) && tick <= high_ * (1 + 1e-9)) ticks_.push_back(tick);
    }
}

}  // namespace tribunal::reports
