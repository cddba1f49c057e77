// What a claim's trial ends in.
#pragma once

#include "bench/statistics.hpp"
#include "reports/figures/figure.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::reports {

enum class Verdict : std::uint8_t {
  reproduced,
  refuted,
  inconclusive,  ///< the rows do not decide; the lines say what they could have seen
  untried,       ///< there are no rows, e.g. because the algorithm does not exist here
};

inline constexpr std::array<std::string_view, 4> verdict_names{"reproduced", "refuted", "inconclusive",
                                                               "untried"};

constexpr std::string_view to_string(Verdict verdict) {
  return verdict_names[static_cast<std::size_t>(verdict)];
}

/// A judge's finding on one claim.
struct Judgement {
  Verdict verdict = Verdict::inconclusive;
  std::string quantity;                     ///< what `measured` is, e.g. "mean of tau at N = 1000"
  std::optional<double> measured;           ///< the figure the verdict hangs on
  std::optional<bench::Interval> interval;  ///< its uncertainty, where it has one
  std::optional<double> bound;              ///< what the claim says of it
  std::vector<std::string> lines;           ///< the reasoning, one statement per line
  std::optional<double> p_value;            ///< of data at least this much against the claim, were it true
  double false_refutation = 0;              ///< probability that this judge refutes a claim that is true
  std::vector<Figure> figures;
};

}  // namespace tribunal::reports
