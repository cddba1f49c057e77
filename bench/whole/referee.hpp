// Is what a contestant shows what the race is about?
#pragma once

#include "bench/whole/contestant.hpp"
#include "bench/whole/course.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace tribunal::bench {

/// What the referee says of a lap.
struct Ruling {
  Outcome outcome = Outcome::ok;
  std::string reason;         ///< one line where it does not stand
  bool within_bounds = true;  ///< of a mesh that is right: whether its triangles are as was asked

  bool stands() const { return outcome == Outcome::ok && within_bounds; }
};

/// Checks laps over one ground, exactly. Where there are no new vertices most contestants make the same mesh,
/// which is looked at once.
class Referee {
 public:
  Referee(const Ground& ground, RaceKind kind) : ground_(ground), kind_(kind) {}

  /// A mesh must be the triangulation that the race asks for; of a refined one, besides, every segment of the
  /// ground is a path of subsegments, and all triangles keep the bounds: see conformity.hpp.
  Ruling judge(Lap lap, Promise promise);

 private:
  Ruling judge_mesh(const Lap& lap, Promise promise) const;

  const Ground& ground_;
  RaceKind kind_;
  std::map<std::pair<std::uint64_t, Promise>, std::optional<Ruling>> verdicts_;
};

}  // namespace tribunal::bench
