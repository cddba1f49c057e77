#include "datasets/dataset.hpp"
#include "datasets/hilbert.hpp"
#include "datasets/radix_sort.hpp"
#include "datasets/random.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

namespace tribunal {
namespace {

constexpr std::array<std::string_view, 5> names{"random", "input", "hilbert", "x", "brio"};

/// Positions in `order`, sorted along the Hilbert curve over the points' box; on the same cell as they stand.
std::vector<Keyed> along_hilbert(std::span<const Point2> points, std::span<const std::uint32_t> order) {
  const auto lattice = quantise(points, 32);
  std::vector<Keyed> positions(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const Point2 cell = lattice[order[i]];
    positions[i] = {hilbert_key(static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1])), i};
  }
  sort_by_key(positions);
  return positions;
}

/// Where the rounds of a shuffled order begin, the last one first: each is half as long as the one after it
/// (Amenta, Choi, Rote 2003).
std::vector<std::size_t> rounds_of(std::size_t size) {
  constexpr std::size_t shortest_round = 64;
  std::vector<std::size_t> begins;
  for (std::size_t end = size; end > 0; end = begins.back())
    begins.push_back(end > shortest_round ? end / 2 : 0);
  return begins;
}

/// Sorts each round along the curve: one sort of all, whose result is dealt out to the rounds.
std::vector<std::uint32_t> sort_in_rounds(std::span<const Point2> points,
                                          std::span<const std::uint32_t> shuffled) {
  const std::vector<std::size_t> begins = rounds_of(shuffled.size());
  std::vector<std::size_t> next = begins;
  std::vector<std::uint32_t> order(shuffled.size());
  for (const Keyed& position : along_hilbert(points, shuffled)) {
    std::size_t round = 0;
    while (position.owner < begins[round]) ++round;
    order[next[round]++] = shuffled[position.owner];
  }
  return order;
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
      std::ranges::transform(along_hilbert(points, indices), indices.begin(), &Keyed::owner);
      break;
    case Order::x:
      std::ranges::stable_sort(indices,
                               [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; });
      break;
    case Order::brio:
      random_order(seed).shuffle(std::span(indices));
      return sort_in_rounds(points, indices);
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
