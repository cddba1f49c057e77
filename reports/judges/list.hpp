// The judges there are.
#pragma once

#include "reports/judges/judge.hpp"

#include <span>
#include <string_view>

namespace tribunal::reports {

/// All judges, in the order in which the documentation lists them.
std::span<const Judge> judges();

/// The judge of that name, or null.
const Judge* find_judge(std::string_view name);

}  // namespace tribunal::reports
