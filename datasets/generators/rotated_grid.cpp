// The integer grid turned by the angle of tangent sqrt(2) and rounded: nearly cocircular fours and nearly
// collinear rows, off by an ulp or not at all. Square roots and quotients are correctly rounded everywhere,
// sines are not.
#include "datasets/generators/generators.hpp"
#include "datasets/generators/square.hpp"

#include <cmath>

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t) {
  const double cosine = std::sqrt(1.0 / 3);
  const double sine = std::sqrt(2.0 / 3);
  return square(n, [=](double i, double j) {
    return Point2{{cosine * i - sine * j, sine * i + cosine * j}};
  });
}
}  // namespace

constinit const Dataset rotated_grid{
    .about = {.name = "rotated-grid",
              .cites = "this project",
              .summary =
                  "grid turned by arctan sqrt 2, then rounded to doubles: ties broken by rounding alone",
              .fixed_size = 0,
              .integer = false},
    .generate = generate,
};

}  // namespace tribunal::generators
