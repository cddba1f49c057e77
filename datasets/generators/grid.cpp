// The integer grid k x k, row by row; the seed changes nothing.
#include "datasets/generators/generators.hpp"
#include "datasets/generators/square.hpp"

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t) {
  return square(n, [](double column, double row) { return Point2{{column, row}}; });
}
}  // namespace

constinit const Dataset grid{
    .about = {.name = "grid",
              .cites = "common practice",
              .summary =
                  "first n points of the smallest k x k integer grid: cocircular fours, collinear rows",
              .fixed_size = 0,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal::generators
