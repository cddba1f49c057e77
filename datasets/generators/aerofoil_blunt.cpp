// An aerofoil of the NACA four-digit family with the blunt trailing edge of the published formula, in a box
// around it.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/pslg_points.hpp"
#include "datasets/shapes/single_aerofoil.hpp"

namespace tribunal::generators {

constinit const Dataset aerofoil_blunt{
    .about = {.name = "aerofoil-blunt",
              .cites = "Jacobs, Ward, Pinkerton 1933",
              .summary = "NACA aerofoil in a box of 12 chords, its trailing edge blunt as published",
              .fixed_size = 0,
              .integer = false},
    .generate =
        [](std::uint64_t n, std::uint64_t seed) {
          return shapes::first_points(shapes::single_aerofoil(n, seed, true), n);
        },
    .graph = [](std::uint64_t n, std::uint64_t seed) { return shapes::single_aerofoil(n, seed, true); },
};

}  // namespace tribunal::generators
