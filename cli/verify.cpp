// tribunal verify: an exact check of anybody's mesh.
#include "algorithms/verify/verify.hpp"

#include "cli/mesh_input.hpp"
#include "cli/verbs.hpp"

#include <nlohmann/json.hpp>

#include <ostream>

namespace tribunal::cli {

int verify(const VerifyOptions& options, Console& console) {
  tribunal::verify::Options checks;
  if (options.kind == "delaunay")
    checks.kind = tribunal::verify::Kind::delaunay;
  else if (options.kind == "triangulation")
    checks.kind = tribunal::verify::Kind::triangulation;
  else
    throw BadUsage("--kind " + options.kind + ": delaunay or triangulation");
  const auto [points, mesh] = read_mesh_over(options.points, options.mesh);
  const auto verdict = tribunal::verify::verify_planar(points.points, {mesh.triangles}, checks);

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
    console.out << "invalid: " << verdict.faults.size()
                << (verdict.faults.size() == checks.max_faults ? "+" : "") << " faults\n";
    for (const auto& fault : verdict.faults)
      console.out << tribunal::verify::to_string(fault.kind) << ": " << fault.detail << '\n';
  }
  return verdict.valid() ? good : judged_bad;
}

}  // namespace tribunal::cli
