// A triangulator that is none of ours: a plug-in's, or a program's that reads and writes files.
#pragma once

#include "algorithms/triangulation.hpp"
#include "predicates/point.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// What an outsider answers to points.
struct OutsiderMesh {
  enum class End : std::uint8_t {
    done,        ///< `triangles` is its mesh, unchecked
    refused,     ///< it will not triangulate these points
    crash,       ///< its process died
    garbage,     ///< what it wrote is no mesh of these points
    no_program,  ///< there is no such outsider
  };
  End end = End::done;
  std::string reason;  ///< one line where it is not done
  std::vector<Triangle> triangles;
  double seconds = 0;  ///< what it took
};

class Triangulator {
 public:
  Triangulator() = default;
  Triangulator(const Triangulator&) = delete;
  Triangulator& operator=(const Triangulator&) = delete;
  virtual ~Triangulator() = default;

  /// Lets the outsider work. Called in a process of its own, which may crash or never come back.
  virtual OutsiderMesh triangulate(std::span<const Point2> points) const = 0;

  /// How many triangulations a trial may spend on making counterexamples smaller: fewer where each starts a
  /// program.
  virtual int spare_runs() const = 0;

  /// The options that name it, ready for a shell: "--plugin x.so".
  virtual std::string options() const = 0;
};

}  // namespace tribunal::bench
