#include "cli/graph_input.hpp"

#include "algorithms/abandon.hpp"
#include "algorithms/constrained/crossings.hpp"
#include "algorithms/constrained/parameters.hpp"
#include "cli/console.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <numeric>

namespace tribunal::cli {
namespace {
constexpr std::array<std::string_view, 3> domain_names{"hull", "carved", "even-odd"};

bool is_poly(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".poly" || ending == ".POLY";
}

void split(GraphInput& input) {
  SplitGraph pieces = split_crossings(input.graph());
  std::vector<std::uint64_t> lines;
  for (const Index segment : pieces.origin) lines.push_back(input.file.segment_lines[segment]);
  input.file.sites.points = std::move(pieces.points);
  input.file.segments = std::move(pieces.segments);
  input.file.segment_lines = std::move(lines);
  input.origin = std::move(pieces.origin);
  input.rounded = pieces.rounded;
  input.snapped = pieces.snapped;
}
}  // namespace

std::string GraphInput::place(Index segment) const {
  return path + ":" + std::to_string(file.segment_lines[segment]);
}

std::string_view to_string(Domain domain) { return domain_names[static_cast<std::size_t>(domain)]; }

Domain domain_of(const std::string& path, const PslgFile& file) {
  return file.polygons ? Domain::even_odd : is_poly(path) ? Domain::carved : Domain::hull;
}

Domain domain_named(const std::string& name, const std::string& path, const PslgFile& file) {
  if (name == "auto") return domain_of(path, file);
  for (std::size_t i = 0; i < domain_names.size(); ++i)
    if (domain_names[i] == name) return static_cast<Domain>(i);
  throw BadUsage("there is no domain '" + name + "'; there are hull, carved, even-odd, auto");
}

GraphInput graph_input(std::string path, PslgFile file, const Settings& settings) {
  const Domain domain = constrained::domain(settings).value_or(domain_of(path, file));
  GraphInput input{std::move(path), std::move(file), {}, domain};
  input.origin.resize(input.file.segments.size());
  std::iota(input.origin.begin(), input.origin.end(), Index{0});
  if (!constrained::splits_crossings(settings)) return input;
  try {
    split(input);
  } catch (const Abandon& abandon) {
    throw BadInput(input.path + ": " + abandon.what());
  }
  return input;
}

std::string describe(const GraphInput& input, const ConstrainedTriangulation& refused) {
  if (refused.crossing)
    return input.place((*refused.crossing)[1]) + ": this segment crosses that of line " +
           std::to_string(input.file.segment_lines[(*refused.crossing)[0]]) +
           " (--set crossings=split would split both)";
  if (refused.hole)
    return input.path + ":" + std::to_string(input.file.hole_lines[*refused.hole]) + ": " +
           refused.mesh.reason;
  if (refused.open_end && *refused.open_end < input.file.sites.lines.size())
    return input.path + ":" + std::to_string(input.file.sites.lines[*refused.open_end]) +
           ": an open loop ends at this point, and the domain is to be bounded by closed ones";
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
