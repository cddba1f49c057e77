// Predicates of a plug-in behind the interface of kernels.
#pragma once

#include "predicates/kernel.hpp"
#include "predicates/plugin/library.hpp"
#include "predicates/plugin/tribunal_predicates.h"
#include "predicates/point.hpp"
#include "predicates/predicate.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tribunal {

/// The predicates that a shared library offers (tribunal_predicates.h). Their code is an outsider's: a call
/// may crash or never return.
class PredicatePlugin {
 public:
  /// Nothing when the library defines no tribunal_predicates_entry. Throws PluginError when it defines one of
  /// another version, without a name or without a single predicate.
  static std::optional<PredicatePlugin> load(const SharedLibrary& library);

  std::string name() const { return offer_->name; }
  std::string cites() const { return offer_->cites != nullptr ? offer_->cites : ""; }
  std::string summary() const { return offer_->summary != nullptr ? offer_->summary : ""; }

  bool offers(Predicate predicate) const;

  /// Whether it answers many such queries in one call.
  bool offers_batch(Predicate predicate) const;

  /// The signs of queries whose points stand one after the other, asked in one call by a context bound to all
  /// of them. The plug-in must offer the batch and not refuse the points. D is the predicate's dimension.
  template <int D>
  std::vector<Sign> batch(Predicate predicate, std::span<const Point<D>> points) const;

  /// A kernel over the points, which need not outlive the call, or the plug-in's refusal. Its decisions are
  /// of Stage::plugin. Only predicates that the plug-in offers may be asked. Points that were not bound are
  /// admitted only by a plug-in without bind.
  Kernel2Binding bind2(std::span<const Point2> points) const;
  Kernel3Binding bind3(std::span<const Point3> points) const;

 private:
  explicit PredicatePlugin(const tribunal_predicates& offer) : offer_(&offer) {}

  const tribunal_predicates* offer_;
};

}  // namespace tribunal
