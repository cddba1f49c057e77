// How the conformance tests call an algorithm: points and names in, a Triangulation out.
#pragma once

#include "algorithms/list.hpp"
#include "algorithms/triangulate.hpp"
#include "algorithms/verify/verify.hpp"
#include "datasets/dataset.hpp"
#include "predicates/backends/list.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <vector>

namespace tribunal {

/// Data for an algorithm that reads them: a saddle, of any size.
inline std::vector<double> values_for(const std::vector<Point2>& points, const PlanarAlgorithm& algorithm) {
  std::vector<double> values;
  if (!algorithm.about.reads_values) return values;
  for (const Point2& p : points) values.push_back(p[0] * p[1]);
  return values;
}

inline Triangulation run(const std::vector<Point2>& points, const PlanarAlgorithm& algorithm,
                         std::string_view backend = "gmp", Order order = Order::random,
                         std::uint64_t seed = 1, const Settings& settings = {}) {
  const Kernel2Binding bound = find_backend(backend)->bind2(points);
  if (const auto* refusal = std::get_if<Refusal>(&bound)) {
    Triangulation refused;
    refused.outcome = Outcome::out_of_domain;
    refused.reason = refusal->reason;
    return refused;
  }
  return triangulate(points, insertion_order(points, order, seed), *std::get<0>(bound), algorithm, settings,
                     values_for(points, algorithm));
}

inline verify::Verdict check(const std::vector<Point2>& points, const Triangulation& t,
                             Promise promise = Promise::delaunay) {
  const auto kind = promise == Promise::delaunay ? verify::Kind::delaunay : verify::Kind::triangulation;
  return verify::verify_planar(points, {t.triangles}, {.kind = kind});
}

/// A name as GoogleTest wants it: '-' and the like become '_'.
inline std::string test_name(std::string_view name) {
  std::string text(name);
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return text;
}

inline std::string faults_of(const verify::Verdict& verdict) {
  std::string text;
  for (const auto& fault : verdict.faults)
    text.append(verify::to_string(fault.kind)).append(": ").append(fault.detail).append("\n");
  return text;
}

}  // namespace tribunal
