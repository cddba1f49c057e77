// Points around the sharp trailing edge of an aerofoil, clustered as for a boundary layer: see
// datasets/shapes/trailing_edge_layers.hpp. The last coefficient of the thickness is -.1036, which closes the
// edge.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/trailing_edge_layers.hpp"

namespace tribunal::generators {

constinit const Dataset trailing_edge{
    .about = {.name = "trailing-edge",
              .cites = "Barth, Figure 3.4.3; Jacobs, Ward, Pinkerton 1933",
              .summary = "layers around an aerofoil's trailing edge, the first 10^-(3 + seed) chords high",
              .fixed_size = 0,
              .integer = false},
    .generate = [](std::uint64_t n,
                   std::uint64_t seed) { return shapes::trailing_edge_layers(n, seed, false); },
    .graph = [](std::uint64_t n, std::uint64_t seed) { return shapes::trailing_edge_graph(n, seed, false); },
};

}  // namespace tribunal::generators
