// What a dataset is: a function from (n, seed) to points.
#pragma once

#include "predicates/point.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal {

/// What `tribunal list datasets` says of a dataset.
struct DatasetAbout {
  std::string_view name;
  std::string_view cites;    ///< source or "this project"
  std::string_view summary;  ///< one line: what is hard about it
  std::uint64_t fixed_size;  ///< > 0: all there are, duplicates included; n takes the first
  bool integer;              ///< coordinates are integers as generated
};

/// A planar straight-line graph: points, segments between them by index, and a point inside each hole.
struct DatasetGraph {
  std::vector<Point2> points;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<Point2> holes;
};

struct Dataset {
  DatasetAbout about;
  /// n points, n >= 1, or as many as the summary says; same (n, seed), same bytes.
  std::vector<Point2> (*generate)(std::uint64_t n, std::uint64_t seed);
  /// A domain whose boundary they are, or lie in, of about n points; null where there is none. No segments
  /// cross.
  DatasetGraph (*graph)(std::uint64_t n, std::uint64_t seed) = nullptr;
};

/// All datasets that come with the program, in the order in which they are listed to users.
std::span<const Dataset> datasets();

/// The dataset of that name, or null; those of datasets/external/ are found, too, whether their files are
/// there or not.
const Dataset* find_dataset(std::string_view name);

/// Rounds to the integer lattice [0, 2^bits)^2 by one scale and one shift for both axes, so that the longer
/// side of the box fills it; shapes are kept, near coincidences may merge. 1 <= bits <= 53. All equal points
/// go to the origin.
std::vector<Point2> quantise(std::span<const Point2> points, int bits);

/// Points and holes of a graph by one scale and one shift; segments that this leaves without length go.
DatasetGraph quantise(DatasetGraph graph, int bits);

/// Insertion orders.
enum class Order : std::uint8_t { random, input, hilbert, x, brio };

/// A permutation of 0 .. points.size()-1; only `random` and `brio` use the seed. `x` sorts
/// lexicographically, `hilbert` along a Hilbert curve over the bounding box, ties by index; `brio` is random
/// between rounds that double in length and along the curve within each (Amenta, Choi, Rote 2003).
std::vector<std::uint32_t> insertion_order(std::span<const Point2> points, Order order, std::uint64_t seed);

/// Names of orders, as on the command line.
std::span<const std::string_view> order_names();
/// The order of that name; false when there is none.
bool parse_order(std::string_view name, Order& order);

}  // namespace tribunal
