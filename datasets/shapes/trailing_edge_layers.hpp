// Layers of points around an aerofoil's trailing edge: what `trailing-edge` and `trailing-edge-blunt` share.
#pragma once

#include "datasets/dataset.hpp"

#include <cstdint>
#include <vector>

namespace tribunal::shapes {

/// Twelve layers along the normals of both sides of the NACA 0012, from the wall on, each spacing half as
/// large again as the one below, and the same on both sides of the wake line, or behind a blunt base.
/// Stations crowd towards the edge, at x = 1. The first spacing is 10^-(3 + s) chords for the seeds s = 1,
/// ..., 6; further seeds begin anew. The first n points, station by station.
std::vector<Point2> trailing_edge_layers(std::uint64_t n, std::uint64_t seed, bool blunt);

/// Those of them that make whole stations, the outline of the aerofoil through them and on to its leading
/// edge, and a box of three chords around.
DatasetGraph trailing_edge_graph(std::uint64_t n, std::uint64_t seed, bool blunt);

}  // namespace tribunal::shapes
