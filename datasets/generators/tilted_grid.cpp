// The integer grid under (i, j) -> (3i - 4j, 4i + 3j), a rotation and a scaling by 5: all cocircularities
// stay exact, but no edge is parallel to an axis any more.
#include "datasets/generators/generators.hpp"
#include "datasets/generators/square.hpp"

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t) {
  return square(n, [](double i, double j) { return Point2{{3 * i - 4 * j, 4 * i + 3 * j}}; });
}
}  // namespace

constinit const Dataset tilted_grid{
    .about = {.name = "tilted-grid",
              .cites = "Shewchuk 1997 (tilted grids)",
              .summary = "integer grid turned by (3, 4)/5: exactly cocircular fours, no axis to lean on",
              .fixed_size = 0,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal::generators
