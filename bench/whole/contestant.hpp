// Who takes part in a race: our algorithms in all their variants, and other people's.
#pragma once

#include "algorithms/algorithm.hpp"
#include "bench/whole/course.hpp"
#include "bench/whole/lap.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tribunal::bench {

/// A way of ours to triangulate or to refine, complete.
struct Method {
  std::string algorithm;
  Settings settings = {};  ///< those that are not standard
  std::string backend = "filtered";
  Order order = Order::random;

  bool operator==(const Method&) const = default;
};

/// "green-sibson location=walk, filtered, brio order".
std::string describe(const Method& method);

/// What the method is raced at over a dataset: refinement, or where segments can be had and taken a graph, or
/// triangulation. Bounds are those of its settings, n is as given; 0 where the dataset's graph is all there
/// is. Throws BadInput for a method that cannot be raced there.
Course course_of(const Method& method, const Dataset& dataset, std::uint64_t n);

struct Contestant {
  std::string name;
  Promise promise;
  std::function<Lap(const Ground&)> run;
};

/// The clock runs while the insertion order is made, the backend is bound, and the algorithm runs. The method
/// must name things that there are, and be one for that kind of race.
Contestant contestant_of(const Method& method, RaceKind kind, std::uint64_t order_seed);

/// What the module offers for that kind of race, by algorithms/plugin/tribunal_triangulator.h or
/// tribunal_mesher.h; nothing where it offers none. Throws PluginError where it cannot be used.
std::optional<Contestant> peer_contestant(const std::string& module_path, RaceKind kind);

}  // namespace tribunal::bench
