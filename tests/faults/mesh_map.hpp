// Looking things up in a valid mesh, for those who want to break it.
#pragma once

#include "tests/faults/samples.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tribunal::faults {

/// A directed edge and the triangle on its left.
struct Side {
  std::uint32_t from, to, triangle, apex;
};

class MeshMap {
 public:
  explicit MeshMap(const std::vector<Triangle>& triangles) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const Side side{triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3], t, triangles[t][i]};
        sides_.emplace(std::pair(side.from, side.to), side);
      }
    for (const auto& [edge, side] : sides_)
      if (!across(side)) {
        hull_.push_back(side);
        hull_vertices_.insert(side.from);
      }
  }

  std::optional<Side> across(const Side& side) const {
    const auto found = sides_.find({side.to, side.from});
    return found == sides_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Edges with a triangle on both sides, once from each.
  std::vector<Side> interior() const {
    std::vector<Side> sides;
    for (const auto& [edge, side] : sides_)
      if (across(side)) sides.push_back(side);
    return sides;
  }

  const std::vector<Side>& hull() const { return hull_; }
  bool on_hull(std::uint32_t vertex) const { return hull_vertices_.contains(vertex); }

  /// The triangles across from the edges of `triangle`.
  std::vector<std::uint32_t> neighbours(const Triangle& triangle) const {
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto side = sides_.find({triangle[(i + 1) % 3], triangle[i]});
      if (side != sides_.end()) found.push_back(side->second.triangle);
    }
    return found;
  }

  /// Vertices not on the hull.
  std::vector<std::uint32_t> interior_vertices() const {
    std::set<std::uint32_t> vertices;
    for (const auto& [edge, side] : sides_)
      if (!on_hull(side.from)) vertices.insert(side.from);
    return {vertices.begin(), vertices.end()};
  }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, Side> sides_;
  std::vector<Side> hull_;
  std::set<std::uint32_t> hull_vertices_;
};

/// One of `items`, or nothing when there is none.
template <class T>
std::optional<T> pick(const std::vector<T>& items, Random& random) {
  if (items.empty()) return std::nullopt;
  return items[random.below(items.size())];
}

/// One of `items` that `wanted` accepts.
template <class T, class Predicate>
std::optional<T> pick(std::vector<T> items, Random& random, Predicate wanted) {
  std::erase_if(items, [&](const T& item) { return !wanted(item); });
  return pick(items, random);
}

/// The numbers of all triangles.
inline std::vector<std::uint32_t> numbers(const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> all(triangles.size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  return all;
}

/// The mesh without the triangles numbered in `lost`, and what became of the others' numbers.
struct Remains {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> number;
};
inline Remains without(const std::vector<Triangle>& triangles, const std::set<std::uint32_t>& lost) {
  Remains remains;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    remains.number.push_back(static_cast<std::uint32_t>(remains.triangles.size()));
    if (!lost.contains(t)) remains.triangles.push_back(triangles[t]);
  }
  return remains;
}

}  // namespace tribunal::faults
