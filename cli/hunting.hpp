// A hunt from its request to its document, in this process or, with outsiders in it, in one of its own.
#pragma once

#include "bench/fuzz/hunt.hpp"
#include "cli/console.hpp"
#include "cli/suspects.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace tribunal::cli {

struct HuntRequest {
  std::vector<Suspect> suspects;
  bench::fuzz::HuntOptions hunt;  ///< without subjects and progress
  bool pictures = false;
  /// The command that repeats what the suspect did wrong.
  std::function<std::string(const Suspect&, const bench::fuzz::Counterexample&)> replay_of;
};

/// What is to be kept of a counterexample beside the document.
struct Keepsake {
  std::string corpus;   ///< the text of its entry
  std::string picture;  ///< an SVG document; empty: none was wanted
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Keepsake, corpus, picture)

struct HuntFound {
  nlohmann::json document;          ///< as hunt_document gives it
  std::vector<Keepsake> keepsakes;  ///< one for each counterexample of the document
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HuntFound, document, keepsakes)

/// Hunts until it is done or the user interrupts. Outsiders' code runs in a child, whose standard streams
/// lead nowhere: one that dies, exits or gives no answer for five seconds is a breach in a document that
/// holds nothing else.
HuntFound run_hunt(const HuntRequest& request, Console& console);

}  // namespace tribunal::cli
