// An aerofoil of the NACA four-digit family with a sharp trailing edge, in a box around it.
#include "datasets/generators/generators.hpp"
#include "datasets/shapes/pslg_points.hpp"
#include "datasets/shapes/single_aerofoil.hpp"

namespace tribunal::generators {

constinit const Dataset aerofoil{
    .about = {.name = "aerofoil",
              .cites = "Jacobs, Ward, Pinkerton 1933",
              .summary = "NACA aerofoil in a box of 12 chords: curved walls, a sharp trailing edge",
              .fixed_size = 0,
              .integer = false},
    .generate =
        [](std::uint64_t n, std::uint64_t seed) {
          return shapes::first_points(shapes::single_aerofoil(n, seed, false), n);
        },
    .graph = [](std::uint64_t n, std::uint64_t seed) { return shapes::single_aerofoil(n, seed, false); },
};

}  // namespace tribunal::generators
