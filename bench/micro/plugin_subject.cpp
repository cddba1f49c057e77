#include "bench/micro/subject.hpp"
#include "predicates/plugin/library.hpp"
#include "predicates/plugin/tribunal_predicates.h"

#include <algorithm>
#include <array>

namespace tribunal::bench {
namespace {

using Batch = decltype(tribunal_predicates::orient2d_batch);

/// What a plug-in's bind returned, released with its last owner.
using Context = std::unique_ptr<void, void (*)(void*)>;

class PluginLoop final : public SignLoop {
 public:
  PluginLoop(Batch batch, Context context, const QuerySet& queries)
      : batch_(batch), context_(std::move(context)), coordinates_(queries.coordinates()) {}

  void sign(std::span<Sign> signs) const override {
    static_assert(sizeof(Sign) == sizeof(std::int8_t));
    batch_(context_.get(), coordinates_, signs.size(), reinterpret_cast<std::int8_t*>(signs.data()));
  }
  void decide(std::span<Decision> decisions) const override {
    std::vector<Sign> signs(decisions.size());
    sign(signs);
    std::transform(signs.begin(), signs.end(), decisions.begin(), [](Sign s) {
      return Decision{s, Stage::plugin};
    });
  }

 private:
  Batch batch_;
  Context context_;
  const double* coordinates_;
};

SignLoopBinding bind(const tribunal_predicates& offer, const QuerySet& queries) {
  const std::array batches{offer.orient2d_batch, offer.incircle_batch, offer.orient3d_batch,
                           offer.insphere_batch};
  const Batch batch = batches[static_cast<std::size_t>(queries.predicate)];
  if (batch == nullptr) return Refusal{0, "it offers no batch of this predicate"};
  const auto keep = [](void*) {};
  Context context(nullptr, offer.release != nullptr ? offer.release : keep);
  if (offer.bind != nullptr) {
    const std::size_t points = queries.count * static_cast<std::size_t>(points_of(queries.predicate));
    std::size_t refused = points;
    void* bound = offer.bind(queries.coordinates(), points, dimension_of(queries.predicate), &refused);
    if (refused < points) return Refusal{refused, "refused by the plug-in"};
    context.reset(bound);
  }
  return std::make_unique<const PluginLoop>(batch, std::move(context), queries);
}

}  // namespace

Subject plugin_subject(const std::string& module_path) {
  const SharedLibrary library(module_path);
  const auto* offer =
      library.offer<tribunal_predicates>("tribunal_predicates_entry", TRIBUNAL_PLUGIN_VERSION);
  if (offer == nullptr) library.refuse("defines no tribunal_predicates_entry");
  return {offer->name, false, [offer](const QuerySet& queries) { return bind(*offer, queries); }};
}

}  // namespace tribunal::bench
