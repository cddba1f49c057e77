#include "bench/micro/subject.hpp"
#include "predicates/plugin/library.hpp"
#include "predicates/plugin/loader.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tribunal::bench {
namespace {

class PluginLoop final : public SignLoop {
 public:
  PluginLoop(PluginBatch batch, const QuerySet& queries)
      : batch_(std::move(batch)), coordinates_(queries.coordinates()) {}

  void sign(std::span<Sign> signs) const override {
    static_assert(sizeof(Sign) == sizeof(std::int8_t));
    batch_.answer(coordinates_, {reinterpret_cast<std::int8_t*>(signs.data()), signs.size()});
  }
  void decide(std::span<Decision> decisions) const override {
    std::vector<Sign> signs(decisions.size());
    sign(signs);
    std::transform(signs.begin(), signs.end(), decisions.begin(), [](Sign s) {
      return Decision{s, Stage::plugin};
    });
  }

 private:
  PluginBatch batch_;
  const double* coordinates_;
};

template <int D>
SignLoopBinding bind(const PredicatePlugin& plugin, const QuerySet& queries) {
  Binding<PluginBatch> bound = plugin.bind_batch<D>(queries.predicate, queries.points<D>());
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return std::make_unique<const PluginLoop>(std::get<PluginBatch>(std::move(bound)), queries);
}

}  // namespace

std::optional<Subject> plugin_subject(const std::string& module_path) {
  const auto plugin = PredicatePlugin::load(SharedLibrary(module_path));
  if (!plugin) return std::nullopt;
  return Subject{plugin->name(), false, [plugin = *plugin](const QuerySet& queries) {
                   return dimension_of(queries.predicate) == 2 ? bind<2>(plugin, queries)
                                                               : bind<3>(plugin, queries);
                 }};
}

}  // namespace tribunal::bench
