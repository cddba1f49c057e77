// The borders of the counties of the United States, ring by ring and arc by arc as the source has them, so
// that a border is met once from each side and the ends of arcs once more: 83,767 points, 33,416 of them
// distinct, on a lattice of 17 bits. n below that gives the first n; the seed changes nothing. Where they
// come from: datasets/data/PROVENANCE.md.
#include "datasets/data/embedded.hpp"
#include "datasets/files/scanner.hpp"
#include "datasets/generators/generators.hpp"
#include "datasets/real.hpp"

#include <algorithm>

namespace tribunal {
namespace {
constexpr std::uint64_t size = 83767;

using Arc = std::vector<Point2>;

std::vector<Arc> read_arcs(Scanner& scanner) {
  scanner.next_line();
  scanner.field("arcs");
  std::vector<Arc> arcs(scanner.count("the number of arcs"));
  for (Arc& arc : arcs) {
    std::int64_t x = 0;
    std::int64_t y = 0;
    for (scanner.next_line(); !scanner.at_end_of_line();) {
      x += scanner.integer("a step in x");
      y += scanner.integer("a step in y");
      arc.push_back({{static_cast<double>(x), static_cast<double>(y)}});
    }
  }
  return arcs;
}

std::vector<Point2> generate(std::uint64_t n, std::uint64_t) {
  Scanner scanner("counties.txt", data::counties());
  const std::vector<Arc> arcs = read_arcs(scanner);
  std::vector<Point2> points;
  points.reserve(size);
  scanner.next_line();
  scanner.field("rings");
  for (auto rings = scanner.count("the number of rings"); rings > 0; --rings) {
    for (scanner.next_line(); !scanner.at_end_of_line();) {
      const std::int64_t number = scanner.integer("an arc");
      const Arc& arc = arcs.at(static_cast<std::size_t>(number >= 0 ? number : ~number));
      if (number >= 0)
        points.insert(points.end(), arc.begin(), arc.end());
      else
        points.insert(points.end(), arc.rbegin(), arc.rend());
    }
  }
  points.resize(std::min<std::uint64_t>(n, points.size()));
  return points;
}
}  // namespace

RealGraph county_arcs() {
  Scanner scanner("counties.txt", data::counties());
  RealGraph graph;
  for (const Arc& arc : read_arcs(scanner))
    for (std::size_t i = 0; i < arc.size(); ++i) {
      graph.points.push_back(arc[i]);
      const auto last = static_cast<std::uint32_t>(graph.points.size() - 1);
      if (i > 0 && !(arc[i - 1] == arc[i])) graph.segments.push_back({last - 1, last});
    }
  return graph;
}

constinit const Dataset generators::counties{
    .about = {.name = "counties",
              .cites = "U.S. Census Bureau 2017, through us-atlas 3.0.1",
              .summary =
                  "county borders on a 17-bit lattice: 33,416 distinct points, duplicates, collinear runs",
              .fixed_size = size,
              .integer = true},
    .generate = generate,
};

}  // namespace tribunal
