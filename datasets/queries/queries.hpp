// Query families: random arguments of one predicate, for timing it and for catching it out.
#pragma once

#include "datasets/random.hpp"
#include "predicates/point.hpp"
#include "predicates/predicate.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal {

/// One way to draw a query. Each function writes the points_of(predicate) points of one query, all finite;
/// the predicate is one of the function's dimension. Only exact operations and square roots: same random
/// numbers, same bytes.
struct QueryFamily {
  std::string_view name;
  std::string_view summary;  ///< one line: what is drawn
  void (*draw2)(Predicate, Random&, std::span<Point2>);
  void (*draw3)(Predicate, Random&, std::span<Point3>);
};

/// All families, in the order in which they are listed to users.
std::span<const QueryFamily> query_families();

/// The family of that name, or null.
const QueryFamily* find_query_family(std::string_view name);

/// `count` queries back to back: count * points_of(predicate) points; same arguments, same bytes. The
/// predicate is planar.
std::vector<Point2> draw_queries2(const QueryFamily& family, Predicate predicate, std::size_t count,
                                  std::uint64_t seed);

/// The same for a predicate in space.
std::vector<Point3> draw_queries3(const QueryFamily& family, Predicate predicate, std::size_t count,
                                  std::uint64_t seed);

}  // namespace tribunal
