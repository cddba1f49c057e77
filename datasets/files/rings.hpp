// Polygons and lines, ring by ring, to a planar straight-line graph: what .geojson and .wkt share.
#pragma once

#include "datasets/files/cursor.hpp"
#include "datasets/files/pslg.hpp"

namespace tribunal::files {

/// Collects points, chains and rings. Each point of a chain or ring is joined to the one before it.
class Rings {
 public:
  explicit Rings(Cursor& cursor) : cursor_(cursor) {}

  void begin_chain() { first_ = static_cast<std::uint32_t>(pslg_.sites.points.size()); }
  /// Adds a point that stands at `where`; refuses one equal to the point before it in its chain.
  void add(Point2 point, Scanner::Place where);
  void end_chain(Scanner::Place where);
  /// The rings that follow belong to one polygon, its outer ring first.
  void begin_polygon() { outer_ = static_cast<std::uint32_t>(pslg_.ring_outers.size()); }
  /// The chain's last point must repeat its first one, which closes the ring.
  void end_ring(Scanner::Place where);
  /// A point that belongs to no chain.
  void add_alone(Point2 point, Scanner::Place where);

  /// The whole; refuses when there are no points.
  PslgFile take();

 private:
  void push(Point2 point, Scanner::Place where);
  void join(std::uint32_t a, std::uint32_t b);
  std::uint32_t size() const { return static_cast<std::uint32_t>(pslg_.sites.points.size()); }

  Cursor& cursor_;
  PslgFile pslg_;
  std::uint32_t first_ = 0;  // of the current chain
  std::uint32_t outer_ = 0;  // ring of the current polygon
};

}  // namespace tribunal::files
