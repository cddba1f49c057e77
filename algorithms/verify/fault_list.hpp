// Collects faults, a bounded number of each kind.
#pragma once

#include "algorithms/verify/verify.hpp"

#include <array>

namespace tribunal::verify {

class FaultList {
 public:
  /// At most `limit` faults are kept; 0 counts as 1, so that an invalid mesh can never look valid.
  explicit FaultList(std::size_t limit) : limit_(limit == 0 ? 1 : limit) {}

  /// Adds a fault; its detail becomes `what` followed by the triangles and points. Beyond the limit it only
  /// counts.
  void add(FaultKind kind, std::vector<std::uint32_t> simplices, std::vector<std::uint32_t> points,
           std::string_view what);

  bool has(FaultKind kind) const { return found_[static_cast<std::size_t>(kind)] > 0; }
  std::uint64_t found() const;

  /// The faults, sorted by kind, simplices, points. Where there are more than the limit, the kinds take
  /// turns, so that every kind that was found is named as long as the limit allows.
  std::vector<Fault> take();

 private:
  std::size_t limit_;
  std::array<std::uint64_t, fault_kinds> found_{};
  std::vector<Fault> faults_;
};

}  // namespace tribunal::verify
