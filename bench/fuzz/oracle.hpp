// The true sign of a case.
#pragma once

#include "bench/fuzz/case.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal::bench::fuzz {

/// By exact integers alone (GMP). All finite doubles.
Sign exact_sign(const Case& asked);

/// By one certified pass of floating-point arithmetic; zero says "not proven".
Sign certified_sign(const Case& asked);

enum class OracleKind : std::uint8_t {
  staged,  ///< the certified filter, and GMP only where it proves nothing
  gmp,     ///< GMP alone
};
inline constexpr std::array<std::string_view, 2> oracle_names{"staged", "gmp"};
constexpr std::string_view to_string(OracleKind kind) { return oracle_names[static_cast<std::size_t>(kind)]; }

/// Where the staged oracle contradicts GMP: then it, and not a backend, stands convicted.
struct OracleFault {
  Case asked;
  Sign exact, certified;
};

/// Answers batches. The staged oracle is itself on trial: of the cases that its filter decides, every
/// `recheck`-th is given to GMP as well.
class Oracle {
 public:
  static constexpr std::uint64_t recheck = 16;

  explicit Oracle(OracleKind kind) : kind_(kind) {}

  /// The true sign of each case, in order. Where GMP was asked, GMP's word holds.
  std::vector<Sign> judge(std::span<const Case> cases);

  OracleKind kind() const { return kind_; }
  std::uint64_t asked_gmp() const { return asked_gmp_; }  ///< cases that GMP decided or rechecked
  std::uint64_t rechecked() const { return rechecked_; }  ///< of them, those that the filter had decided, too
  const std::vector<OracleFault>& faults() const { return faults_; }

 private:
  Sign judge_staged(const Case& asked);

  OracleKind kind_;
  std::uint64_t asked_gmp_ = 0, rechecked_ = 0, certified_ = 0;
  std::vector<OracleFault> faults_;
};

}  // namespace tribunal::bench::fuzz
