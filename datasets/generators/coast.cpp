// The coast of the Gulf of Mexico and Florida, 98-80.5 W, 24.3-31 N: 850 distinct points and the 847 segments
// between them, on the lattice of the county borders, moved to the origin: 13 bits. n below 850 gives the
// first n; the seed changes nothing. Where they come from: datasets/data/PROVENANCE.md.
#include "datasets/data/embedded.hpp"
#include "datasets/files/scanner.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/real.hpp"

#include <algorithm>

namespace tribunal {
namespace {
constexpr std::uint64_t size = 850;

/// The pairs of numbers below the line "`title` count".
std::vector<std::array<std::uint32_t, 2>> read_pairs(std::string_view title) {
  Scanner scanner("coast.txt", data::coast());
  while (scanner.next_line() && scanner.field("title") != title) continue;
  std::vector<std::array<std::uint32_t, 2>> pairs(scanner.count("count"));
  for (auto& pair : pairs) {
    scanner.next_line();
    for (auto& number : pair) number = static_cast<std::uint32_t>(scanner.count("number"));
  }
  return pairs;
}

std::vector<Point2> generate(std::uint64_t n, std::uint64_t) {
  std::vector<Point2> points;
  points.reserve(size);
  for (const auto [x, y] : read_pairs("points"))
    points.push_back({{static_cast<double>(x), static_cast<double>(y)}});
  points.resize(std::min<std::uint64_t>(n, points.size()));
  return points;
}

DatasetGraph graph(std::uint64_t n, std::uint64_t seed) {
  DatasetGraph graph{generate(n, seed), read_pairs("segments"), {}};
  std::erase_if(graph.segments, [n](const auto& segment) { return segment[1] >= n; });
  return graph;
}
}  // namespace

std::vector<std::array<std::uint32_t, 2>> coast_segments() { return read_pairs("segments"); }

constinit const Dataset generators::coast{
    .about = {.name = "coast",
              .cites = "U.S. Census Bureau 2017, through us-atlas 3.0.1",
              .summary = "coast of the Gulf of Mexico and Florida, 13 bits: real shape, with 847 segments",
              .fixed_size = size,
              .integer = true},
    .generate = generate,
    .graph = graph,
};

}  // namespace tribunal
