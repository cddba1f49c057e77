// About sqrt(n) distinct sites of a 2^16 lattice, each drawn about sqrt(n) times.
#include "datasets/generators/each.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/generators/square.hpp"
#include "datasets/random.hpp"

namespace tribunal::generators {
namespace {
std::vector<Point2> generate(std::uint64_t n, std::uint64_t seed) {
  Random random(seed);
  const auto sites = each(n < 4 ? 1 : square_side(n), [&](std::uint64_t) {
    const auto x = static_cast<double>(random.below(1 << 16));
    const auto y = static_cast<double>(random.below(1 << 16));
    return Point2{{x, y}};
  });
  return each(n, [&](std::uint64_t) { return sites[random.below(sites.size())]; });
}
}  // namespace

constinit const Dataset duplicates{
    .about = {.name = "duplicates",
              .cites = "this project",
              .summary = "about sqrt n distinct sites, each about sqrt n times: what merging must get right",
              .fixed_size = 0,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal::generators
