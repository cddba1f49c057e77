#include "datasets/dataset.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

namespace tribunal {
namespace {

constexpr std::array<std::string_view, 5> names{"random", "input", "hilbert", "x", "brio"};

/// Position along the Hilbert curve of the lattice [0, 2^32)^2 (Hilbert 1891): at each level, from the
/// coarsest, the quadrant's place among four, after which the quadrant is turned into the position of the
/// first one.
std::uint64_t hilbert_key(std::uint32_t x, std::uint32_t y) {
  std::uint64_t key = 0;
  for (int level = 31; level >= 0; --level) {
    const std::uint32_t right = (x >> level) & 1;
    const std::uint32_t up = (y >> level) & 1;
    key = 4 * key + ((3 * right) ^ up);
    if (up == 1) continue;
    if (right == 1) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return key;
}

std::vector<std::uint64_t> hilbert_keys(std::span<const Point2> points) {
  const auto lattice = quantise(points, 32);
  std::vector<std::uint64_t> keys(points.size());
  std::transform(lattice.begin(), lattice.end(), keys.begin(), [](const Point2& p) {
    return hilbert_key(static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1]));
  });
  return keys;
}

void sort_by_hilbert(std::span<std::uint32_t> order, std::span<const std::uint64_t> keys) {
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return keys[i]; });
}

/// Rounds of a shuffled order, each half as long as the one after it, sorted along the curve within
/// themselves (Amenta, Choi, Rote 2003).
void sort_in_rounds(std::span<std::uint32_t> order, std::span<const std::uint64_t> keys) {
  constexpr std::size_t shortest_round = 64;
  std::size_t end = order.size();
  while (end > 0) {
    const std::size_t begin = end > shortest_round ? end / 2 : 0;
    sort_by_hilbert(order.subspan(begin, end - begin), keys);
    end = begin;
  }
}

/// A stream of its own: a dataset drawn with the same seed must not share its order's random numbers.
Random random_order(std::uint64_t seed) {
  constexpr std::uint64_t salt = 0x6F72646572;  // "order"
  return Random(seed ^ salt);
}

}  // namespace

std::vector<std::uint32_t> insertion_order(std::span<const Point2> points, Order order, std::uint64_t seed) {
  assert(points.size() <= std::uint64_t{1} << 32);
  std::vector<std::uint32_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::uint32_t{0});
  switch (order) {
    case Order::random:
      random_order(seed).shuffle(std::span(indices));
      break;
    case Order::input:
      break;
    case Order::hilbert:
      sort_by_hilbert(indices, hilbert_keys(points));
      break;
    case Order::x:
      std::ranges::stable_sort(indices,
                               [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; });
      break;
    case Order::brio:
      random_order(seed).shuffle(std::span(indices));
      sort_in_rounds(indices, hilbert_keys(points));
      break;
  }
  return indices;
}

std::span<const std::string_view> order_names() { return names; }

bool parse_order(std::string_view name, Order& order) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return false;
  order = static_cast<Order>(found - names.begin());
  return true;
}

}  // namespace tribunal
