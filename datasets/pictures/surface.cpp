#include "datasets/pictures/surface.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::pictures {

Bands::Bands(std::span<const double> values, std::size_t bands)
    : bands_(bands), heights_(values.size(), 0.0) {
  if (values.empty()) return;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  least_ = *least;
  greatest_ = *greatest;
  if (!(least_ < greatest_)) return;
  // A power of two first, so that no difference overflows.
  const int exponent = -std::ilogb(std::max(std::fabs(least_), std::fabs(greatest_))) - 1;
  const double low = std::ldexp(least_, exponent), range = std::ldexp(greatest_, exponent) - low;
  for (std::size_t i = 0; i < values.size(); ++i)
    heights_[i] = (std::ldexp(values[i], exponent) - low) / range;
}

std::size_t Bands::band(double height) const {
  auto k = std::min(bands_ - 1, static_cast<std::size_t>(height * static_cast<double>(bands_)));
  if (k + 1 < bands_ && height >= level(k + 1)) ++k;
  if (k > 0 && height < level(k)) --k;
  return k;
}

std::vector<Stroke> Bands::contours(const std::array<Corner, 3>& triangle) const {
  std::vector<Stroke> strokes;
  const auto [lowest, highest] = std::minmax({triangle[0].value, triangle[1].value, triangle[2].value});
  for (std::size_t k = band(lowest) + 1; k <= band(highest); ++k) {
    Stroke stroke;
    std::size_t ends = 0;
    for (std::size_t i = 0; i < 3 && ends < 2; ++i) {
      const Corner &a = triangle[i], &b = triangle[(i + 1) % 3];
      const double at_a = a.value - level(k), at_b = b.value - level(k);
      if ((at_a >= 0) == (at_b >= 0)) continue;
      stroke[ends++] = (at_a >= 0 ? crossing(a, at_a, b, at_b) : crossing(b, at_b, a, at_a)).at;
    }
    if (ends == 2) strokes.push_back(stroke);
  }
  return strokes;
}

}  // namespace tribunal::pictures
