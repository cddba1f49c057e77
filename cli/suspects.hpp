// Who is on trial in a hunt: backends of the list, and outsiders' libraries.
#pragma once

#include "bench/fuzz/subject.hpp"
#include "bench/outsider/watched.hpp"
#include "predicates/predicate.hpp"

#include <span>
#include <string>
#include <vector>

namespace tribunal::cli {

/// Known without an outsider's code in this process.
struct Suspect {
  std::string name;                ///< printable, and no other's
  std::string library;             ///< of a plug-in; empty: a backend of the list
  std::vector<Predicate> offered;  ///< the predicates that it has

  bool is_plugin() const { return !library.empty(); }
};

/// The backends and libraries that were named, each once, or all backends when none was. A library whose name
/// is taken is called by its path as well. Throws BadUsage about what there is not, PluginError about a
/// library that cannot be used.
std::vector<Suspect> suspects_of(std::span<const std::string> backends,
                                 std::span<const std::string> libraries);

/// The suspects as subjects of a hunt. Loads their libraries, so that it is to be called in a child; there
/// each plug-in gives a sign of life whenever it is bound. A library that leaves the floating-point
/// environment changed is named in `breaches`, and the environment put right.
std::vector<bench::fuzz::Subject> subjects_of(std::span<const Suspect> suspects, const bench::LifeSigns& life,
                                              std::vector<std::string>& breaches);

/// "--plugin ./mine.so" or "--backend double", ready for a shell.
std::string option_of(const Suspect& suspect);

}  // namespace tribunal::cli
