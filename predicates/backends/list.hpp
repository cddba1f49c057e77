// The backends there are.
#pragma once

#include "predicates/backends/backend.hpp"

#include <span>
#include <string_view>

namespace tribunal {

/// All backends, in the order in which they are listed to users.
std::span<const BackendEntry> backends();

/// The backend of that name, or null.
const BackendEntry* find_backend(std::string_view name);

}  // namespace tribunal
