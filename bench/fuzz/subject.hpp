// What is on trial: a backend of the list, or anything else that binds points and answers with signs.
#pragma once

#include "bench/fuzz/case.hpp"
#include "predicates/backend.hpp"
#include "predicates/decision.hpp"
#include "predicates/kernel.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tribunal::bench::fuzz {

struct Subject {
  std::string name;
  bool exact = false;  ///< promises the true sign of everything it binds
  std::function<Kernel2Binding(std::span<const Point2>)> bind2;
  std::function<Kernel3Binding(std::span<const Point3>)> bind3;
  std::function<bool(Predicate)> offers;  ///< which predicates it has: only these may be bound for
};

Subject subject_of(const BackendEntry& entry);

/// A subject's kernel over the points of some cases, all of one predicate's dimension.
class BoundSubject {
 public:
  Decision decide(const Case& asked) const;

  /// Whether the case's points may be asked about, bound or not.
  bool admits(const Case& asked) const;

 private:
  friend Binding<BoundSubject> bind_subject(const Subject&, std::span<const Case>);
  std::unique_ptr<const Kernel2> kernel2_;
  std::unique_ptr<const Kernel3> kernel3_;
};

/// Binds the subject to all points of the cases, which must not be empty and must agree on the predicate.
Binding<BoundSubject> bind_subject(const Subject& subject, std::span<const Case> cases);

/// The subject's answer when it is bound to the case's own points and nothing else; nothing when it refuses
/// them.
std::optional<Decision> decide_alone(const Subject& subject, const Case& asked);

}  // namespace tribunal::bench::fuzz
