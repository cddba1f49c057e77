// tribunal verify: an exact check of anybody's mesh.
#include "algorithms/verify/verify.hpp"

#include "cli/graph_input.hpp"
#include "cli/mesh_input.hpp"
#include "cli/verbs.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <span>

namespace tribunal::cli {

namespace {
using tribunal::verify::Kind;

constexpr std::size_t max_faults = 100;

PslgFile graph_of(const VerifyOptions& options) {
  auto file = read_pslg(options.points);
  if (!file)
    throw BadUsage(options.points + " holds no segments: --kind constrained wants .poly, .geojson or .wkt");
  return std::move(*file);
}

tribunal::verify::Verdict check_constrained(const VerifyOptions& options, const PslgFile& file,
                                            const MeshFile& mesh) {
  const Domain domain = domain_named(options.domain, file);
  return tribunal::verify::verify_constrained(
      file.sites.points, {mesh.triangles},
      {file.segments, file.holes, static_cast<tribunal::verify::Domain>(domain)},
      {.kind = options.criterion == "none" ? Kind::triangulation : Kind::delaunay, .max_faults = max_faults});
}

/// The first few; a document holds them all.
void print_faults(Console& console, std::span<const tribunal::verify::Fault> faults) {
  constexpr std::size_t most_printed = 10;
  console.out << "invalid: " << faults.size() << (faults.size() == max_faults ? "+" : "") << " faults\n";
  for (const auto& fault : faults.first(std::min(faults.size(), most_printed)))
    console.out << tribunal::verify::to_string(fault.kind) << ": " << fault.detail << '\n';
  if (faults.size() > most_printed)
    console.log << faults.size() - most_printed << " more are in the document of --json\n";
}

bool is_of_circles(const tribunal::verify::Fault& fault) {
  return fault.kind == tribunal::verify::FaultKind::non_delaunay;
}

}  // namespace

int verify(const VerifyOptions& options, Console& console) {
  const bool constrained = options.kind == "constrained";
  if (!constrained && options.kind != "delaunay" && options.kind != "triangulation")
    throw BadUsage("--kind " + options.kind + ": delaunay, triangulation or constrained");
  if (!constrained && options.domain != "auto") throw BadUsage("--domain goes with --kind constrained");
  if (options.criterion != "delaunay" && options.criterion != "none")
    throw BadUsage("--criterion " + options.criterion + ": delaunay or none");
  if (options.criterion == "none" && !constrained)
    throw BadUsage("--criterion none goes with --kind constrained");
  PslgFile file;
  if (constrained)
    file = graph_of(options);
  else
    file.sites = read_points(options.points);
  const PointFile& points = file.sites;
  const MeshFile mesh = read_mesh_over(options.points, points, options.mesh);
  const auto verdict =
      constrained ? check_constrained(options, file, mesh)
                  : tribunal::verify::verify_planar(
                        points.points, {mesh.triangles},
                        {options.kind == "delaunay" ? Kind::delaunay : Kind::triangulation, max_faults});

  if (console.json) {
    nlohmann::json faults = nlohmann::json::array();
    for (const auto& fault : verdict.faults)
      faults.push_back({{"kind", tribunal::verify::to_string(fault.kind)},
                        {"simplices", fault.simplices},
                        {"points", fault.points},
                        {"detail", fault.detail}});
    print_json(console, {{"valid", verdict.valid()},
                         {"kind", options.kind},
                         {"dimension", verdict.dimension},
                         {"sites", verdict.sites},
                         {"hull", verdict.hull},
                         {"triangles", mesh.triangles.size()},
                         {"ties", verdict.ties},
                         {"faults", faults}});
  } else if (verdict.valid()) {
    console.out << "valid: " << mesh.triangles.size() << " triangles over " << verdict.sites << " sites, "
                << verdict.hull << " on the hull\n";
  } else {
    print_faults(console, verdict.faults);
    if (options.kind == "delaunay" && std::ranges::all_of(verdict.faults, is_of_circles))
      console.log << "a triangulation it is: --kind triangulation asks for no more\n";
  }
  return verdict.valid() ? good : judged_bad;
}

}  // namespace tribunal::cli
