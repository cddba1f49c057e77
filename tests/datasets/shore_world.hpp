#pragma once

// A world of shores cut at bins, and what tests of them ask.
#include "datasets/external/shore.hpp"
#include "datasets/files/files.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace tribunal::shores {

inline constexpr std::int64_t side = 65535;  // of a bin, in its own points
inline constexpr std::int64_t degrees = 10;  // of a bin
inline constexpr std::int64_t step =
    degrees * steps_per_degree / side;  // of a bin's points, on the lattice of places

/// A world of bins of ten degrees, to which polygons are added: what a maker of such files does, in one's own
/// words. Points are counted from (0 E, 90 S); edges cross the borders of bins at right angles.
class World {
 public:
  World() {
    binned_.bin_degrees = degrees;
    in_bin_.resize(36 * 18);
  }

  /// Counter-clockwise, land inside.
  void add(std::vector<std::array<std::int64_t, 2>> polygon) {
    const auto with_borders = split(polygon);
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < with_borders.size(); ++i)
      if (on_border(with_borders[i])) starts.push_back(i);
    if (starts.empty()) {
      auto closed = with_borders;
      closed.push_back(closed.front());
      put(closed, 4, 4);
    }
    for (std::size_t s = 0; s < starts.size(); ++s) {
      std::vector<std::array<std::int64_t, 2>> piece;
      const std::size_t last = starts[(s + 1) % starts.size()];
      for (std::size_t i = starts[s];; i = (i + 1) % with_borders.size()) {
        piece.push_back(with_borders[i]);
        if (i == last && piece.size() > 1) break;
      }
      put(piece, side_of(piece[0], piece[1]), side_of(piece.back(), piece[piece.size() - 2]));
    }
    ++polygon_;
  }

  BinnedShores binned(std::uint32_t level = 1) const {
    BinnedShores all = binned_;
    for (const auto& pieces : in_bin_) {
      all.bins.push_back(
          {static_cast<std::int32_t>(all.pieces.size()), static_cast<std::int32_t>(pieces.size())});
      for (const auto& [polygon, entry, exit, points] : pieces) {
        all.pieces.push_back({static_cast<std::uint32_t>(points.size() << 9) | level << 6 | entry << 3 | exit,
                              static_cast<std::int32_t>(all.east.size()), polygon});
        for (const auto& [x, y] : points) {
          all.east.push_back(static_cast<std::uint16_t>(x));
          all.north.push_back(static_cast<std::uint16_t>(y));
        }
      }
    }
    return all;
  }

 private:
  using Point = std::array<std::int64_t, 2>;
  struct Put {
    std::int32_t polygon;
    std::uint32_t entry, exit;
    std::vector<Point> points;
  };

  static bool on_border(const Point& p) { return p[0] % side == 0 || p[1] % side == 0; }

  static std::vector<Point> split(const std::vector<Point>& polygon) {
    std::vector<Point> all;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point p = polygon[i], q = polygon[(i + 1) % polygon.size()];
      all.push_back(p);
      for (const int axis : {0, 1}) {
        if (p[1 - axis] != q[1 - axis]) continue;
        const std::int64_t sign = p[axis] < q[axis] ? 1 : -1;
        for (std::int64_t c = p[axis] + sign; c != q[axis]; c += sign) {
          if (c % side != 0) continue;
          Point crossing = p;
          crossing[axis] = c;
          all.push_back(crossing);
        }
      }
    }
    return all;
  }

  /// South, east, north or west: where `end` lies on the border of the bin that `next` is in.
  static std::uint32_t side_of(const Point& end, const Point& next) {
    if (end[1] == next[1]) return end[0] < next[0] ? 3 : 1;
    return end[1] < next[1] ? 0 : 2;
  }

  void put(std::vector<Point> points, std::uint32_t entry, std::uint32_t exit) {
    // Twice the middle of the first edge is in the bin.
    const std::int64_t column = (points[0][0] + points[1][0]) / (2 * side),
                       row = (points[0][1] + points[1][1]) / (2 * side);
    for (Point& p : points) p = {p[0] - column * side, p[1] - row * side};
    in_bin_[static_cast<std::size_t>((17 - row) * 36 + column)].push_back({polygon_, entry, exit, points});
  }

  BinnedShores binned_;
  std::vector<std::vector<Put>> in_bin_;
  std::int32_t polygon_ = 0;
};

inline std::vector<std::array<std::int64_t, 2>> box(std::int64_t west, std::int64_t east, std::int64_t south,
                                                    std::int64_t north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

inline Place place(std::int64_t x, std::int64_t y) { return {x * step, y * step - 90 * steps_per_degree}; }

inline Wide doubled_area(const std::vector<Place>& polygon) {
  Wide area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    area += Wide{p.x} * q.y - Wide{q.x} * p.y;
  }
  return area;
}

inline bool encloses(const std::vector<Place>& polygon, const Place& p) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Place a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (a.y > b.y) std::swap(a, b);
    odd ^= turn(a, b, p) > 0;
  }
  return odd;
}

inline std::string reason_of(const auto& run) {
  try {
    run();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

inline const Window everything = window_of_degrees(1, 359, -89, 89);

}  // namespace tribunal::shores
