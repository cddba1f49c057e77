#include "predicates/plugin/loader.hpp"

#include "predicates/certified.hpp"
#include "predicates/domain.hpp"
#include "predicates/formulas/compare_length.hpp"

#include <cassert>
#include <memory>
#include <utility>

namespace tribunal {
namespace {

template <int D>
const double* coordinates(std::span<const Point<D>> points) {
  static_assert(sizeof(Point<D>) == D * sizeof(double), "points are laid out as the interface says");
  return points.empty() ? nullptr : points.front().coordinate.data();
}

auto batch_function(const tribunal_predicates& offer, Predicate predicate) {
  switch (predicate) {
    case Predicate::orient2d:
      return offer.orient2d_batch;
    case Predicate::incircle:
      return offer.incircle_batch;
    case Predicate::orient3d:
      return offer.orient3d_batch;
    case Predicate::insphere:
      break;
  }
  return offer.insphere_batch;
}

template <int D>
Binding<PluginContext> bind_context(const tribunal_predicates& offer, std::span<const Point<D>> points) {
  if (auto refusal = refuse_non_finite(points)) return *refusal;
  if (offer.bind == nullptr) return PluginContext(offer, nullptr);
  std::size_t refused = points.size();
  void* value = offer.bind(coordinates(points), points.size(), D, &refused);
  if (refused < points.size()) return Refusal{refused, "refused by the plug-in"};
  return PluginContext(offer, value);
}

Decision decided(int answer) { return {sign_of(answer), Stage::plugin}; }

template <int D>
const double* raw(const Point<D>& p) {
  return p.coordinate.data();
}

class PluginKernel2 final : public Kernel2 {
 public:
  explicit PluginKernel2(PluginContext context) : context_(std::move(context)) {}
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override {
    assert(context_.offer().orient2d != nullptr);
    return decided(context_.offer().orient2d(context_.value(), raw(a), raw(b), raw(c)));
  }
  Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    assert(context_.offer().incircle != nullptr);
    return decided(context_.offer().incircle(context_.value(), raw(a), raw(b), raw(c), raw(d)));
  }
  /// No plug-in offers comparisons of lengths and angles: these are ours, and exact.
  Decision decide_compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return Certified{}.decide<CompareLength<2>>({a, b, c, d});
  }
  Decision decide_compare_angle(const Angle<2>& p, const Angle<2>& q) const override {
    return tribunal::compare_angle<2>(Certified{}, p, q);
  }
  bool admits(Point2 p) const override { return context_.offer().bind == nullptr && is_finite(p); }

 private:
  PluginContext context_;
};

class PluginKernel3 final : public Kernel3 {
 public:
  explicit PluginKernel3(PluginContext context) : context_(std::move(context)) {}
  Decision decide_orient3d(Point3 a, Point3 b, Point3 c, Point3 d) const override {
    assert(context_.offer().orient3d != nullptr);
    return decided(context_.offer().orient3d(context_.value(), raw(a), raw(b), raw(c), raw(d)));
  }
  Decision decide_insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) const override {
    assert(context_.offer().insphere != nullptr);
    return decided(context_.offer().insphere(context_.value(), raw(a), raw(b), raw(c), raw(d), raw(e)));
  }
  bool admits(Point3 p) const override { return context_.offer().bind == nullptr && is_finite(p); }

 private:
  PluginContext context_;
};

}  // namespace

std::optional<PredicatePlugin> PredicatePlugin::load(const SharedLibrary& library) {
  const auto* offer =
      library.offer<tribunal_predicates>("tribunal_predicates_entry", TRIBUNAL_PLUGIN_VERSION);
  if (offer == nullptr) return std::nullopt;
  const PredicatePlugin plugin(*offer);
  for (const Predicate predicate : all_predicates)
    if (plugin.offers(predicate)) return plugin;
  library.refuse("tribunal_predicates_entry offers no predicate");
}

bool PredicatePlugin::offers(Predicate predicate) const {
  switch (predicate) {
    case Predicate::orient2d:
      return offer_->orient2d != nullptr;
    case Predicate::incircle:
      return offer_->incircle != nullptr;
    case Predicate::orient3d:
      return offer_->orient3d != nullptr;
    case Predicate::insphere:
      return offer_->insphere != nullptr;
  }
  return false;
}

bool PredicatePlugin::offers_batch(Predicate predicate) const {
  return batch_function(*offer_, predicate) != nullptr;
}

template <int D>
Binding<PluginBatch> PredicatePlugin::bind_batch(Predicate predicate,
                                                 std::span<const Point<D>> points) const {
  assert(dimension_of(predicate) == D);
  if (!offers_batch(predicate)) return Refusal{0, "it offers no batch of this predicate"};
  Binding<PluginContext> bound = bind_context(*offer_, points);
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return PluginBatch(batch_function(*offer_, predicate), std::get<PluginContext>(std::move(bound)));
}
template Binding<PluginBatch> PredicatePlugin::bind_batch<2>(Predicate, std::span<const Point2>) const;
template Binding<PluginBatch> PredicatePlugin::bind_batch<3>(Predicate, std::span<const Point3>) const;

Kernel2Binding PredicatePlugin::bind2(std::span<const Point2> points) const {
  Binding<PluginContext> bound = bind_context(*offer_, points);
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return std::make_unique<const PluginKernel2>(std::get<PluginContext>(std::move(bound)));
}

Kernel3Binding PredicatePlugin::bind3(std::span<const Point3> points) const {
  Binding<PluginContext> bound = bind_context(*offer_, points);
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return std::make_unique<const PluginKernel3>(std::get<PluginContext>(std::move(bound)));
}

}  // namespace tribunal
