#include "bench/fuzz/batch.hpp"

#include "bench/fuzz/dressing.hpp"
#include "bench/fuzz/mutation.hpp"
#include "bench/fuzz/oracle.hpp"
#include "bench/fuzz/shapes.hpp"
#include "bench/fuzz/ulps.hpp"
#include "datasets/queries/queries.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tribunal::bench::fuzz {
namespace {

template <class Entry>
const Entry& any_of(std::span<const Entry> entries, Random& random) {
  return entries[random.below(entries.size())];
}

/// Within the boxes of the integer backends, and at the bit lengths where exact stages change: Knuth's 14,
/// single precision's 24, then 28, 36 and 53.
constexpr std::array box_bits{5, 13, 14, 24, 28, 36, 53};

void draw_shapes(Batch& batch, Random& random) {
  const Shape& shape = any_of(shapes(), random);
  const int bits = box_bits[random.below(box_bits.size())];
  const Dressing dressing(batch.predicate, bits, random);
  batch.source = std::string(shape.name) + " " + std::to_string(bits) + " bits, " +
                 std::string(to_string(dressing.fabric()));
  for (Case& asked : batch.cases) {
    shape.draw(random, bits, asked);
    dressing.apply(asked, random);
  }
}

template <int D>
void draw_points(void (*draw)(Predicate, Random&, std::span<Point<D>>), Random& random, Case& asked) {
  std::array<Point<D>, D + 2> points{};
  draw(asked.predicate, random, std::span(points).first(static_cast<std::size_t>(asked.points())));
  for (int i = 0; i < asked.points(); ++i)
    std::copy_n(points[i].coordinate.begin(), D, asked.point(i).begin());
}

void draw_family(Batch& batch, Random& random) {
  const QueryFamily& family = any_of(query_families(), random);
  batch.source = "family " + std::string(family.name);
  for (Case& asked : batch.cases)
    asked.dimension() == 2 ? draw_points<2>(family.draw2, random, asked)
                           : draw_points<3>(family.draw3, random, asked);
}

/// Each a hard case, changed one to four times.
void draw_mutants(Batch& batch, const Pool& pool, Random& random) {
  batch.source = "mutants";
  for (Case& asked : batch.cases) {
    asked = any_of(pool.of(batch.predicate), random);
    for (auto changes = 1 + random.below(4); changes > 0; --changes) apply(draw_mutation(random), asked);
  }
}

/// Moves one number of the case, by ulps, to the edge of what the certified filter proves: of two
/// neighbouring doubles it settles one and not the other. Unchanged where a number can move a long way
/// without effect.
void move_to_threshold(Case& asked, Random& random) {
  double& number = asked.numbers()[random.below(asked.size())];
  const double start = number;
  const int direction = random.below(2) == 0 ? 1 : -1;
  const auto is_certified_after = [&](int steps) {
    number = moved_by_ulps(start, direction * steps);
    return certified_sign(asked) != Sign::zero;
  };
  constexpr int most = 1 << 30;
  int outside = 0, inside = 1;
  while (inside < most && !is_certified_after(inside)) outside = std::exchange(inside, 2 * inside);
  while (inside - outside > 1) {
    const int middle = outside + (inside - outside) / 2;
    (is_certified_after(middle) ? inside : outside) = middle;
  }
  const int chosen = inside < most ? inside + static_cast<int>(random.below(4)) - 2 : 0;
  number = moved_by_ulps(start, direction * chosen);
}

/// Hard cases at the threshold of the first stage that most exact backends have.
void draw_thresholds(Batch& batch, const Pool& pool, Random& random) {
  batch.source = "thresholds";
  for (Case& asked : batch.cases) {
    asked = any_of(pool.of(batch.predicate), random);
    move_to_threshold(asked, random);
  }
}

}  // namespace

void permute(Batch& batch, std::size_t queries, Random& random) {
  const std::size_t drawn = batch.cases.size();
  batch.parities.assign(drawn, Sign::positive);
  for (std::size_t i = 0; batch.cases.size() < queries; ++i) {
    Case permuted = batch.cases[i];
    for (int last = permuted.points() - 1; last > 0; --last) {
      const auto other = static_cast<int>(random.below(static_cast<std::uint64_t>(last) + 1));
      if (other == last) continue;
      permuted.swap_points(other, last);
      batch.parities[i] = -batch.parities[i];
    }
    batch.cases.push_back(permuted);
  }
}

void Pool::add(const Case& asked) { cases_[static_cast<std::size_t>(asked.predicate)].push_back(asked); }

void Pool::add_or_replace(const Case& asked, Random& random) {
  auto& cases = cases_[static_cast<std::size_t>(asked.predicate)];
  if (cases.size() < most)
    cases.push_back(asked);
  else
    cases[random.below(cases.size())] = asked;
}

Batch draw_batch(std::uint64_t seed, std::uint64_t index, Predicate predicate, const Pool& pool,
                 std::size_t queries) {
  assert(queries > 0);
  Random random(Random::splitmix64(seed) + index);  // by value: a copy of the seed is advanced
  Batch batch;
  batch.predicate = predicate;
  batch.cases.reserve(queries);
  batch.cases.assign((queries + 1) / 2, Case{predicate});
  const auto kind = random.below(8);
  if (kind == 0 && !pool.of(predicate).empty())
    draw_mutants(batch, pool, random);
  else if (kind == 1 && !pool.of(predicate).empty())
    draw_thresholds(batch, pool, random);
  else if (kind < 5)
    draw_family(batch, random);
  else
    draw_shapes(batch, random);
  permute(batch, queries, random);
  return batch;
}

}  // namespace tribunal::bench::fuzz
