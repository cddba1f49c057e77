// A long job with an outsider's code in it, in a child that must give signs of life.
#pragma once

#include "bench/outsider/witness.hpp"
#include "bench/sandbox.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace tribunal::bench {

/// What a child and its parent tell each other while the child works, in memory that both see.
struct LifeSigns {
  Witness beats{0};              ///< goes up with everything the child does
  Witness subject{0};            ///< who is being asked
  Witness checked{0}, wrong{0};  ///< for progress
  Witness stop{0};               ///< set by the parent: come to an end and report

  void beat() const { beats.set(beats.value() + 1); }
};

/// Runs `work` in a child for as long as it likes, provided that it beats: one that does not for `patience`
/// is killed with its process group, and its ending is a timeout. `tick` is called in the parent a few times
/// a second.
Ending run_watched(const std::function<std::string()>& work, const LifeSigns& life,
                   std::chrono::milliseconds patience, const std::function<void()>& tick);

/// As run_sandboxed; nothing, and the child killed with its group, once `wake` (a descriptor, or -1) is
/// readable.
std::optional<Ending> run_unless_woken(const std::function<std::string()>& work, const Limits& limits,
                                       int wake);

}  // namespace tribunal::bench
