// Points around the blunt trailing edge of an aerofoil, as published: see
// datasets/shapes/trailing_edge_layers.hpp.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/trailing_edge_layers.hpp"

namespace tribunal::generators {

constinit const Dataset trailing_edge_blunt{
    .about = {.name = "trailing-edge-blunt",
              .cites = "Barth, Figure 3.4.3; Jacobs, Ward, Pinkerton 1933",
              .summary = "the same layers around a blunt trailing edge, 0.25 % of the chord high",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n,
                   std::uint64_t seed) { return shapes::trailing_edge_layers(n, seed, true); },
    .graph = [](std::uint64_t n, std::uint64_t seed) { return shapes::trailing_edge_graph(n, seed, true); },
};

}  // namespace tribunal::generators
