#include "datasets/hilbert.hpp"

#include <array>
#include <utility>

namespace tribunal {
namespace {

/// How the quadrant at hand lies in the plane, seen from the curve's first one: its axes may be exchanged,
/// and after that both turned round.
struct Pose {
  bool exchanged, turned;

  constexpr unsigned index() const { return 2U * exchanged + turned; }
};

/// A quadrant's place among four along the curve, and the pose of the curve within it.
struct Visit {
  unsigned place;
  Pose pose;
};

/// One level of the curve: the quadrant with bits x and y, in the plane.
constexpr Visit visit(Pose pose, unsigned x, unsigned y) {
  unsigned right = x ^ static_cast<unsigned>(pose.turned), up = y ^ static_cast<unsigned>(pose.turned);
  if (pose.exchanged) std::swap(right, up);
  const unsigned place = (3 * right) ^ up;
  if (up == 0) pose = {!pose.exchanged, pose.turned != (right == 1)};
  return {place, pose};
}

constexpr int levels_at_once = 4;

/// Of levels_at_once levels: their places, the coarsest first, and above them the pose of the finest.
using Step = std::uint16_t;
constexpr std::size_t cells = std::size_t{1} << (2 * levels_at_once);

constexpr std::array<Step, 4 * cells> make_steps() {
  std::array<Step, 4 * cells> steps{};
  for (unsigned start = 0; start < 4; ++start) {
    for (unsigned cell = 0; cell < cells; ++cell) {
      const unsigned x = cell >> levels_at_once, y = cell & ((1U << levels_at_once) - 1);
      Pose pose{start >= 2, start % 2 == 1};
      unsigned places = 0;
      for (int level = levels_at_once - 1; level >= 0; --level) {
        const Visit visited = visit(pose, (x >> level) & 1U, (y >> level) & 1U);
        places = 4 * places + visited.place;
        pose = visited.pose;
      }
      steps[start * cells + cell] = static_cast<Step>(pose.index() * cells + places);
    }
  }
  return steps;
}

constexpr std::array<Step, 4 * cells> steps = make_steps();

}  // namespace

std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  constexpr std::uint32_t digit = (1U << levels_at_once) - 1;
  std::uint64_t key = 0;
  std::size_t pose = 0;
  for (int shift = 32 - levels_at_once; shift >= 0; shift -= levels_at_once) {
    const std::size_t cell = (((x >> shift) & digit) << levels_at_once) | ((y >> shift) & digit);
    const std::size_t step = steps[pose + cell];
    key = (key << (2 * levels_at_once)) | (step % cells);
    pose = step - step % cells;
  }
  return key;
}

}  // namespace tribunal
