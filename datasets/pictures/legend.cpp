#include "datasets/pictures/legend.hpp"

#include "datasets/pictures/numerals.hpp"
#include "datasets/pictures/palette.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tribunal::pictures {
namespace {

/// With as many digits as tell numbers of this `step` apart, 9 at most; 0 where it is nothing beside the
/// step.
std::string rounded(double number, double step) {
  if (std::fabs(number) < step / 100) return "0";
  const int precision = std::clamp(static_cast<int>(std::log10(std::fabs(number) / step)) + 2, 3, 9);
  char digits[32];
  return {digits,
          std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, precision).ptr};
}

/// At equal steps from `first` to `last`.
Scale scale_between(double first, double last, std::size_t bands) {
  Scale scale;
  const auto parts = static_cast<double>(bands);
  for (std::size_t k = 0; k <= bands; ++k)
    scale.borders.push_back(rounded(std::lerp(first, last, static_cast<double>(k) / parts),
                                    std::fabs(last / parts - first / parts)));
  return scale;
}

}  // namespace

Scale scale_of(const AngleScale& angles) { return scale_between(angles.best, angles.worst, angles.bands); }

Scale scale_of(const Bands& bands) { return scale_between(bands.least(), bands.greatest(), bands.count()); }

std::vector<Areas> shades(std::size_t bands) {
  std::vector<Areas> areas;
  for (std::size_t k = 0; k < bands; ++k)
    areas.push_back({shade(bands > 1 ? static_cast<double>(k) / static_cast<double>(bands - 1) : 0.0), {}});
  return areas;
}

void add_legend(Drawing& drawing, const Scale& scale) {
  constexpr double margin = 10, gap = 15, bar = 24, numeral_height = 12, room_for_number = 140, least = 200;
  const std::size_t bands = scale.borders.size() - 1;
  drawing.height = std::max(drawing.height, least);
  const double left = drawing.width + gap, bottom = drawing.height - margin;
  const double step = (bottom - margin) / static_cast<double>(bands);
  drawing.width = left + bar + room_for_number;
  for (std::size_t k = 0; k < bands; ++k) {
    const double low = bottom - static_cast<double>(k) * step;
    drawing.areas[k].polygons.push_back(
        {{left, low}, {left + bar, low}, {left + bar, low - step}, {left, low - step}});
  }
  Lines numbers{{40, 40, 40}, 1.4, {}};
  const auto every = static_cast<std::size_t>(std::ceil(2 * numeral_height / step));
  for (std::size_t k = 0; k <= bands; k += every) {
    // Those at the ends stand inside the bar's height.
    const double middle = std::clamp(bottom - static_cast<double>(k) * step, margin + numeral_height / 2,
                                     bottom - numeral_height / 2);
    const auto strokes =
        numeral(scale.borders[k], {left + bar + 8, middle + numeral_height / 2}, numeral_height);
    numbers.strokes.insert(numbers.strokes.end(), strokes.begin(), strokes.end());
  }
  drawing.lines.push_back(std::move(numbers));
}

}  // namespace tribunal::pictures
