#include "predicates/plugin/loader.hpp"

#include "predicates/backends/certified.hpp"
#include "predicates/domain.hpp"
#include "predicates/formulas/compare_length.hpp"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

namespace tribunal {
namespace {

/// What a plug-in's bind returned, released in the end.
class Context {
 public:
  Context(const tribunal_predicates& offer, void* value) : offer_(&offer), value_(value) {}
  Context(Context&& other) noexcept
      : offer_(std::exchange(other.offer_, nullptr)), value_(std::exchange(other.value_, nullptr)) {}
  Context& operator=(Context&&) = delete;
  ~Context() {
    if (offer_ != nullptr && offer_->bind != nullptr && offer_->release != nullptr) offer_->release(value_);
  }
  const tribunal_predicates& offer() const { return *offer_; }
  const void* value() const { return value_; }

 private:
  const tribunal_predicates* offer_;
  void* value_;
};

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
Binding<Context> bind_context(const tribunal_predicates& offer, std::span<const Point<D>> points) {
  if (auto refusal = refuse_unusable(points)) return *refusal;
  if (offer.bind == nullptr) return Context(offer, nullptr);
  std::size_t refused = points.size();
  void* value = offer.bind(coordinates(points), points.size(), D, &refused);
  if (refused < points.size()) return Refusal{refused, "refused by the plug-in"};
  return Context(offer, value);
}

Decision decided(int answer) { return {sign_of(answer), Stage::plugin}; }

template <int D>
const double* raw(const Point<D>& p) {
  return p.coordinate.data();
}

class PluginKernel2 final : public Kernel2 {
 public:
  explicit PluginKernel2(Context context) : context_(std::move(context)) {}
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
  Context context_;
};

class PluginKernel3 final : public Kernel3 {
 public:
  explicit PluginKernel3(Context context) : context_(std::move(context)) {}
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
  Context context_;
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
std::vector<Sign> PredicatePlugin::batch(Predicate predicate, std::span<const Point<D>> points) const {
  assert(dimension_of(predicate) == D && offers_batch(predicate));
  const std::size_t count = points.size() / static_cast<std::size_t>(points_of(predicate));
  std::vector<std::int8_t> answers(count);
  const Binding<Context> bound = bind_context(*offer_, points);
  assert(std::holds_alternative<Context>(bound));
  batch_function(*offer_, predicate)(std::get<Context>(bound).value(), coordinates(points), count,
                                     answers.data());
  std::vector<Sign> signs(count);
  std::ranges::transform(answers, signs.begin(), [](std::int8_t answer) { return sign_of(answer); });
  return signs;
}
template std::vector<Sign> PredicatePlugin::batch<2>(Predicate, std::span<const Point2>) const;
template std::vector<Sign> PredicatePlugin::batch<3>(Predicate, std::span<const Point3>) const;

Kernel2Binding PredicatePlugin::bind2(std::span<const Point2> points) const {
  Binding<Context> bound = bind_context(*offer_, points);
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return std::make_unique<const PluginKernel2>(std::get<Context>(std::move(bound)));
}

Kernel3Binding PredicatePlugin::bind3(std::span<const Point3> points) const {
  Binding<Context> bound = bind_context(*offer_, points);
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return std::make_unique<const PluginKernel3>(std::get<Context>(std::move(bound)));
}

}  // namespace tribunal
