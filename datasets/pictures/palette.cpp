#include "datasets/pictures/palette.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tribunal::pictures {
namespace {

/// From linear light in [0, 1] to a byte of sRGB (IEC 61966-2-1).
std::uint8_t encode(double light) {
  light = std::clamp(light, 0.0, 1.0);
  const double value = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * value));
}

double cube(double x) { return x * x * x; }

/// From the perceptual space Oklab (Ottosson 2020).
Colour from_oklab(double lightness, double a, double b) {
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Colour shade(double where) {
  // These ends keep the whole way inside what sRGB can show.
  const double lightness = std::lerp(0.96, 0.42, where), chroma = std::lerp(0.08, 0.15, where);
  const double hue = std::lerp(100.0, -30.0, where) * std::numbers::pi / 180;
  return from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
}

}  // namespace tribunal::pictures
