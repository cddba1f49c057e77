// Cases drawn together: one kind, one predicate, so that a backend binds once and answers often.
#pragma once

#include "bench/fuzz/case.hpp"
#include "datasets/random.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench::fuzz {

/// Hard cases to mutate, per predicate: those that were given, and in the room left those met on the way.
class Pool {
 public:
  static constexpr std::size_t most = 256;

  void add(const Case& asked);
  /// Adds the case, or when the pool is full lets it replace a random one.
  void add_or_replace(const Case& asked, Random& random);

  std::span<const Case> of(Predicate predicate) const { return cases_[static_cast<std::size_t>(predicate)]; }

 private:
  std::array<std::vector<Case>, predicate_names.size()> cases_;
};

/// Cases and, after them, the same ones with their points permuted. All predicates are antisymmetric: under
/// an odd permutation the true sign changes.
struct Batch {
  Predicate predicate = Predicate::orient2d;
  std::string source;          ///< what drew it: "sphere 14 bits, nudged", "family near", "mutants"
  std::vector<Case> cases;     ///< drawn() as drawn, then at most as many permuted
  std::vector<Sign> parities;  ///< of the permutations: negative where odd

  std::size_t drawn() const { return parities.size(); }
  std::span<const Case> drawn_cases() const { return std::span(cases).first(drawn()); }
};

/// Appends the cases once more, randomly permuted, until there are `queries`, at most twice as many.
void permute(Batch& batch, std::size_t queries, Random& random);

/// Batch number `index` of the sequence that `seed` stands for, `queries` > 0 cases long. The same arguments
/// give the same bytes, whatever was drawn before; only mutants depend on the pool.
Batch draw_batch(std::uint64_t seed, std::uint64_t index, Predicate predicate, const Pool& pool,
                 std::size_t queries);

}  // namespace tribunal::bench::fuzz
