// Predicates of a plug-in behind the interface of kernels.
#pragma once

#include "predicates/kernel.hpp"
#include "predicates/plugin/library.hpp"
#include "predicates/plugin/tribunal_predicates.h"
#include "predicates/point.hpp"
#include "predicates/predicate.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tribunal {

/// What a plug-in's bind returned, null included; released with its owner.
class PluginContext {
 public:
  PluginContext(const tribunal_predicates& offer, void* value) : offer_(&offer), value_(value) {}
  PluginContext(PluginContext&& other) noexcept
      : offer_(std::exchange(other.offer_, nullptr)), value_(std::exchange(other.value_, nullptr)) {}
  PluginContext& operator=(PluginContext&&) = delete;
  ~PluginContext() {
    if (offer_ != nullptr && offer_->bind != nullptr && offer_->release != nullptr) offer_->release(value_);
  }
  const tribunal_predicates& offer() const { return *offer_; }
  const void* value() const { return value_; }

 private:
  const tribunal_predicates* offer_;
  void* value_;
};

/// A predicate's batched entry, bound to points.
class PluginBatch {
 public:
  using Function = decltype(tribunal_predicates::orient2d_batch);

  PluginBatch(Function function, PluginContext context) : function_(function), context_(std::move(context)) {}

  /// The answers to answers.size() queries, whose bound points stand one after the other: what the plug-in
  /// writes, which need not be signs.
  void answer(const double* coordinates, std::span<std::int8_t> answers) const {
    function_(context_.value(), coordinates, answers.size(), answers.data());
  }

 private:
  Function function_;
  PluginContext context_;
};

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

  /// The batched entry bound to the points, which need not outlive the call, or the plug-in's refusal; one
  /// without a batch refuses. D is the predicate's dimension.
  template <int D>
  Binding<PluginBatch> bind_batch(Predicate predicate, std::span<const Point<D>> points) const;

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
