#include "cli/suspects.hpp"

#include "bench/outsider/printable.hpp"
#include "bench/outsider/probe.hpp"
#include "bench/outsider/replay.hpp"
#include "bench/sound_environment.hpp"
#include "cli/lookup.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/plugin/loader.hpp"

#include <algorithm>

namespace tribunal::cli {
namespace {
using bench::LifeSigns;
using bench::fuzz::Subject;

constexpr double probe_seconds = 5;

Suspect backend_suspect(const BackendEntry& entry) {
  Suspect suspect{.name = std::string(entry.about->name), .library = {}, .offered = {}};
  const Subject subject = bench::fuzz::subject_of(entry);
  std::ranges::copy_if(all_predicates, std::back_inserter(suspect.offered), subject.offers);
  return suspect;
}

Suspect plugin_suspect(const std::string& library, std::span<const Suspect> others) {
  const bench::PluginAbout about = bench::probe_plugin(library, {.seconds = probe_seconds});
  if (!about.predicates) throw BadUsage(library + " offers no predicates");
  Suspect suspect{.name = about.predicates->name, .library = library, .offered = about.offered};
  const bool is_taken = find_backend(suspect.name) != nullptr ||
                        std::ranges::find(others, suspect.name, &Suspect::name) != others.end();
  if (is_taken) suspect.name += " (" + bench::printable(library) + ")";
  return suspect;
}

/// The predicates of a library; every bind is a sign of life.
Subject load(const Suspect& suspect, std::uint64_t number, const LifeSigns& life) {
  life.subject.set(number);
  const SharedLibrary library(suspect.library);
  const auto plugin = PredicatePlugin::load(library);
  if (!plugin) library.refuse("offers no predicates");
  const auto announce = [number, &life] {
    life.subject.set(number);
    life.beat();
  };
  return {.name = suspect.name,
          .exact = true,
          .bind2 =
              [=, plugin = *plugin](std::span<const Point2> points) {
                announce();
                return plugin.bind2(points);
              },
          .bind3 =
              [=, plugin = *plugin](std::span<const Point3> points) {
                announce();
                return plugin.bind3(points);
              },
          .offers = [plugin = *plugin](Predicate predicate) { return plugin.offers(predicate); }};
}

}  // namespace

std::vector<Suspect> suspects_of(std::span<const std::string> backend_names,
                                 std::span<const std::string> libraries) {
  std::vector<Suspect> suspects;
  for (const std::string& name : each_once(backend_names))
    suspects.push_back(backend_suspect(backend_named(name)));
  for (const std::string& library : each_once(libraries))
    suspects.push_back(plugin_suspect(library, suspects));
  if (suspects.empty())
    for (const BackendEntry& entry : backends()) suspects.push_back(backend_suspect(entry));
  return suspects;
}

std::vector<Subject> subjects_of(std::span<const Suspect> suspects, const LifeSigns& life,
                                 std::vector<std::string>& breaches) {
  std::vector<Subject> subjects;
  for (std::uint64_t i = 0; i < suspects.size(); ++i) {
    if (!suspects[i].is_plugin()) {
      subjects.push_back(bench::fuzz::subject_of(backend_named(suspects[i].name)));
      continue;
    }
    const bench::SoundEnvironment environment;
    subjects.push_back(load(suspects[i], i, life));
    if (const std::string fault = environment.restore(); !fault.empty())
      breaches.push_back(suspects[i].name + ": " + fault + " after it was loaded");
  }
  return subjects;
}

std::string option_of(const Suspect& suspect) {
  return suspect.is_plugin() ? "--plugin " + bench::shell_word(suspect.library)
                             : "--backend " + bench::shell_word(suspect.name);
}

}  // namespace tribunal::cli
