#include "cli/graph_input.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/constrained/crossings.hpp"
#include "algorithms/constrained/parameters.hpp"
#include "cli/console.hpp"
#include "datasets/files/numerals.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace tribunal::cli {
namespace {
constexpr std::array<std::string_view, 3> domain_names{"hull", "carved", "even-odd"};

void split(GraphInput& input) {
  SplitGraph pieces = split_crossings(input.graph());
  std::vector<std::uint64_t> lines;
  std::vector<std::uint32_t> rings;
  for (const Index segment : pieces.origin) {
    lines.push_back(input.file.segment_lines[segment]);
    if (!input.file.segment_rings.empty()) rings.push_back(input.file.segment_rings[segment]);
  }
  input.file.sites.points = std::move(pieces.points);
  input.file.segments = std::move(pieces.segments);
  input.file.segment_lines = std::move(lines);
  input.file.segment_rings = std::move(rings);
  input.origin = std::move(pieces.origin);
  input.rounded = pieces.rounded;
  input.snapped = pieces.snapped;
}

std::string ends_of(const GraphInput& input, Index segment) {
  const auto [a, b] = input.file.segments[segment];
  return files::point_text(input.file.sites.points[a]) + " to " +
         files::point_text(input.file.sites.points[b]);
}
}  // namespace

std::string GraphInput::place(Index segment) const {
  return path + ":" + std::to_string(file.segment_lines[segment]);
}

std::string_view to_string(Domain domain) { return domain_names[static_cast<std::size_t>(domain)]; }

Domain domain_named(const std::string& name, const PslgFile& file) {
  const std::string& meant = file.segments.empty() ? "hull" : file.domain;
  const auto found = std::ranges::find(domain_names, name == "auto" ? meant : name);
  if (found != domain_names.end()) return static_cast<Domain>(found - domain_names.begin());
  throw BadUsage("there is no domain '" + name + "'; there are hull, carved, even-odd, auto");
}

GraphInput graph_input(std::string path, PslgFile file, const Settings& settings) {
  const Domain domain = constrained::domain(settings).value_or(domain_named("auto", file));
  GraphInput input{std::move(path), std::move(file), {}, domain};
  input.origin.resize(input.file.segments.size());
  std::iota(input.origin.begin(), input.origin.end(), Index{0});
  if (!constrained::splits_crossings(settings)) return input;
  try {
    split(input);
  } catch (const UnsettledCrossing& crossing) {
    const auto [first, second] = crossing.segments;
    throw BadInput(input.place(second) + ": where this segment and that of line " +
                   std::to_string(input.file.segment_lines[first]) + " cross, " + crossing.what());
  } catch (const Abandon& abandon) {
    throw BadInput(input.path + ": " + abandon.what());
  }
  return input;
}

std::string describe(const GraphInput& input, const ConstrainedTriangulation& refused) {
  if (refused.crossing) {
    const auto [first, second] = *refused.crossing;
    return input.place(second) + ": this segment, " + ends_of(input, second) + ", crosses that of line " +
           std::to_string(input.file.segment_lines[first]) + ", " + ends_of(input, first) +
           " (tribunal triangulate --algorithm constrained --set crossings=split splits both)";
  }
  if (refused.hole)
    return input.path + ":" + std::to_string(input.file.hole_lines[*refused.hole]) + ": " +
           refused.mesh.reason;
  if (refused.open_end && *refused.open_end < input.file.sites.lines.size())
    return input.path + ":" + std::to_string(input.file.sites.lines[*refused.open_end]) +
           (input.domain == Domain::even_odd
                ? ": an open loop ends at this point, and the domain is to be bounded by closed ones (a "
                  "carved "
                  "one may have segments that end inside)"
                : ": a loop is open at this point, and no other encloses anything");
  return input.path + ": " + refused.mesh.reason;
}

nlohmann::json segments_json(const GraphInput& input, const ConstrainedTriangulation& found) {
  return {{"segments", input.origin.empty() ? 0 : input.origin.back() + 1},
          {"pieces", found.constraints.size()},
          {"holes", input.file.holes.size()},
          {"domain", to_string(input.domain)},
          {"touches", found.touches.size()},
          {"swaps", found.swaps},
          {"crossing_points", input.file.sites.points.size() - input.file.sites.lines.size()},
          {"rounded", input.rounded},
          {"snapped", input.snapped}};
}

}  // namespace tribunal::cli
