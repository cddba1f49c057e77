// A first look at a plug-in, from a safe distance.
#pragma once

#include "bench/sandbox.hpp"
#include "predicates/predicate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tribunal::bench {

/// What an offer says of itself, as printable text.
struct OfferAbout {
  std::string name, cites, summary;
};

struct PluginAbout {
  std::optional<OfferAbout> predicates, triangulator, mesher;  ///< at least one
  std::vector<Predicate> offered;
  bool triangulates_graphs = false, refines = false;  ///< what the mesher does

  const OfferAbout& first() const {
    return predicates ? *predicates : triangulator ? *triangulator : *mesher;
  }
};

/// Loads the library in a child and reads what it offers. Throws PluginError, one line that names the file,
/// when it cannot be loaded, offers nothing, is of another version, or dies or hangs on the way.
PluginAbout probe_plugin(const std::string& path, const Limits& limits);

}  // namespace tribunal::bench
