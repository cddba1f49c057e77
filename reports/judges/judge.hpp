// What a judge is: a pure function from a claim's rule and result rows to a judgement.
#pragma once

#include "bench/row.hpp"
#include "reports/claim.hpp"
#include "reports/judgement.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace tribunal::reports {

using Rows = std::span<const bench::Row>;

/// What a parameter of a rule holds.
enum class ParameterKind : std::uint8_t { number, text, texts, tables };

struct Parameter {
  std::string_view name;
  ParameterKind kind = ParameterKind::number;
  bool required = false;
};

struct Judge {
  std::string_view name;
  std::string_view summary;  ///< one line: what it decides
  std::span<const Parameter> parameters;
  /// Called with at least one row. May throw Incomplete (judges/evidence.hpp).
  Judgement (*judge)(const Rule& rule, Rows rows);
};

}  // namespace tribunal::reports
