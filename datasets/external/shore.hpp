// Shores as polylines on one lattice, and what is done with them until they bound a sea.
#pragma once

#include "datasets/external/binned_shores.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace tribunal::shores {

/// Wide enough for determinants of differences of places.
__extension__ using Wide = __int128;

/// Bins of d degrees have points at multiples of d / 65535 degrees; cuts are rounded to 1 / 8192 of one of
/// 1 / 65535 degree, so that one lattice holds all.
constexpr std::int64_t steps_per_degree = std::int64_t{65535} * 8192;

/// Degrees east of Greenwich, 0 to 360, and north, both times `steps_per_degree`.
struct Place {
  std::int64_t x, y;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 means the zero inside <=>.
  friend auto operator<=>(const Place&, const Place&) = default;
};

/// A polyline with the land to its left, or a polygon, which does not repeat its first place. Consecutive
/// places differ.
struct Shore {
  std::int32_t polygon;  ///< number of the land mass; larger ones have smaller numbers
  bool closed;
  std::vector<Place> places;
};

/// An open rectangle. No point of a bin may lie on a line through its sides: they lie half way between.
struct Window {
  Place low, high;
  friend bool operator==(const Window&, const Window&) = default;
};

/// Whole degrees, made smaller by half of the least distance between points on every side.
Window window_of_degrees(std::int64_t west, std::int64_t east, std::int64_t south, std::int64_t north);

/// The shores between sea and land in the bins that meet the window, joined across the bins' borders; those
/// that leave the bins are open. Throws BadInput where two begin in one place. O(n log n).
std::vector<Shore> assemble(const BinnedShores& binned, const Window& window);

/// What the window sees of them: closed ones that lie inside, and open ones that begin and end on its border.
/// Cuts are rounded along the border; between edges shorter than 16384 points of the file's lattice nothing
/// can come to cross by it that did not meet. Throws BadInput where a shore ends inside.
std::vector<Shore> cut(const std::vector<Shore>& shores, const Window& window);

/// Takes away islands that meet themselves or another shore elsewhere than in a common vertex, of two the
/// smaller; returns how many. Throws BadInput where shores that are no islands meet. Exact; a sweep over n
/// edges, O(n log n + n k) where a vertical line meets the x-ranges of about k.
std::size_t remove_meeting_islands(std::vector<Shore>& shores);

/// The outlines of what the open shores leave of the window, counter-clockwise; the window's where there are
/// none. Throws BadInput where they do not enter and leave in turn.
std::vector<std::vector<Place>> close_along_border(const std::vector<Shore>& shores, const Window& window);

/// Four places whose mean is strictly inside a simple polygon.
std::array<Place, 4> around_inner_point(const std::vector<Place>& polygon);

/// The sign of the area of a, b, c: positive for a turn to the left.
int turn(const Place& a, const Place& b, const Place& c);

}  // namespace tribunal::shores
