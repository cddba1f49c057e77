// The backends there are.
#pragma once

#include "predicates/backend.hpp"

#include <span>
#include <string_view>

namespace tribunal {

/// All backends, in the order in which they are listed to users.
std::span<const BackendEntry> backends();

/// Of each exact backend the one that breaks in-sphere ties, "+sos" behind its name, in the same order. They
/// are not among the others: where points are cospherical their answer is not the true one, which is zero.
std::span<const BackendEntry> symbolic_backends();

/// The backend of that name, of either kind, or null.
const BackendEntry* find_backend(std::string_view name);

}  // namespace tribunal
