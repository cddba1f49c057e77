// Who takes part in a race: our algorithms in all their variants, and other people's.
#pragma once

#include "algorithms/algorithm.hpp"
#include "datasets/dataset.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// A way of ours to triangulate, complete.
struct Method {
  std::string algorithm;
  Settings settings = {};  ///< those that are not standard
  std::string backend = "filtered";
  Order order = Order::random;

  bool operator==(const Method&) const = default;
};

/// "green-sibson location=walk, filtered, brio order".
std::string describe(const Method& method);

/// One run.
struct Lap {
  Outcome outcome = Outcome::ok;
  std::string reason = {};
  std::vector<Triangle> triangles = {};
  double seconds = 0;  ///< processor time of the thread, from points to triangles
};

struct Contestant {
  std::string name;
  Promise promise;
  std::function<Lap(std::span<const Point2>)> run;
};

/// The clock runs while the insertion order is made, the backend is bound, and the algorithm runs. The method
/// must name things that there are.
Contestant contestant_of(const Method& method, std::uint64_t order_seed);

/// The triangulator of a plug-in (algorithms/plugin/tribunal_triangulator.h), in this process; nothing where
/// the module offers none. Throws PluginError where it cannot be used.
std::optional<Contestant> peer_contestant(const std::string& module_path);

}  // namespace tribunal::bench
