// What an outcome means to a reader.
#pragma once

#include <cstdint>
#include <string_view>

namespace tribunal::reports {

enum class OutcomeKind : std::uint8_t {
  good,
  failed,      ///< a wrong result, or none
  refused,     ///< the backend or the algorithm said that it cannot
  unfinished,  ///< a cap on time or memory ended it
};

constexpr OutcomeKind outcome_kind(std::string_view outcome) {
  if (outcome == "ok") return OutcomeKind::good;
  if (outcome == "out_of_domain" || outcome == "refused_input") return OutcomeKind::refused;
  if (outcome == "timeout" || outcome == "out_of_memory") return OutcomeKind::unfinished;
  return OutcomeKind::failed;
}

}  // namespace tribunal::reports
