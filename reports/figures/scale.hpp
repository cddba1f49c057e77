// From data to positions along an axis, and where its ticks are.
#pragma once

#include <vector>

namespace tribunal::reports {

/// An affine map of [low, high], or of its logarithms, to [from, to].
class Scale {
 public:
  /// The range is widened to round numbers (linear) or left as it is (logarithmic, both ends positive); an
  /// empty range gets some width.
  Scale(double low, double high, bool log, double from, double to);

  [[nodiscard]] double at(double value) const;

  /// Round numbers within the range: 1, 2 or 5 times a power of ten, powers of ten only where a logarithmic
  /// range spans three or more of them.
  [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }

 private:
  void linear_ticks();
  void log_ticks();

  double low_, high_;
  bool log_;
  double from_, to_;
  std::vector<double> ticks_;
};

}  // namespace tribunal::reports
