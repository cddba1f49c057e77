// tribunal try: an outsider's predicates or triangulator over the whole zoo of hard inputs.
#include "bench/interrupt.hpp"
#include "bench/outsider/command.hpp"
#include "bench/outsider/mesh_trial.hpp"
#include "bench/outsider/plugin_triangulator.hpp"
#include "bench/outsider/predicate_trial.hpp"
#include "bench/outsider/probe.hpp"
#include "cli/lookup.hpp"
#include "cli/numbers.hpp"
#include "cli/output_folder.hpp"
#include "cli/progress.hpp"
#include "cli/scratch.hpp"
#include "cli/trial_report.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "datasets/queries/queries.hpp"
#include "predicates/plugin/library.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

namespace tribunal::cli {
namespace {
using namespace tribunal::bench;

/// "orient2d 0x1p-1 0 ...", as a counterexample's replay gives it.
fuzz::Case parse_query(const std::string& text) {
  std::istringstream words(text);
  std::string name;
  words >> name;
  fuzz::Case asked{.predicate = predicate_named(name)};
  std::vector<double> numbers;
  for (std::string word; words >> word;) numbers.push_back(parse_number(word));
  if (numbers.size() != asked.size())
    throw BadUsage("--query: " + name + " takes " + std::to_string(asked.size()) + " numbers, " +
                   std::to_string(numbers.size()) + " given");
  std::ranges::copy(numbers, asked.numbers().begin());
  return asked;
}

void append(TrialResult& all, TrialResult more) {
  std::ranges::move(more.exercises, std::back_inserter(all.exercises));
  std::ranges::move(more.counterexamples, std::back_inserter(all.counterexamples));
}

/// One outsider and what the user wants it tried on.
class Trial {
 public:
  Trial(const TryOptions& options, Console& console) : options_(options), print_(progress_printer(console)) {
    trial_options_ = {.seed = options.seed,
                      .queries = options.queries,
                      .points = options.n,
                      .limits = {.seconds = options.seconds},
                      .wake = interrupt_.descriptor()};
  }

  /// By the user: what there is is not all.
  bool interrupted() { return interrupt_.requested(); }

  TrialResult of_plugin(const PluginAbout& about) {
    TrialResult result;
    if (!options_.query.empty()) return of_query(about);
    if (whole_zoo() && about.predicates)
      progress_.total += about.offered.size() * (query_families().size() + 1);
    if (about.triangulator) progress_.total += datasets_to_try().size();
    if (whole_zoo() && about.predicates)
      append(result, try_predicates(options_.plugin, about.offered, trial_options_, watcher()));
    if (about.triangulator && !interrupted())
      append(result, of_triangulator(PluginTriangulator(options_.plugin)));
    else if (!about.triangulator && !whole_zoo())
      throw BadUsage(options_.plugin + ": offers no triangulator for --points or --dataset");
    return result;
  }

  TrialResult of_command() {
    if (!options_.query.empty()) throw BadUsage("--query goes with --plugin");
    progress_.total = datasets_to_try().size();
    const ScratchFolder scratch;
    return of_triangulator(CommandTriangulator(options_.command, scratch.path()));
  }

 private:
  bool whole_zoo() const { return options_.points.empty() && options_.dataset.empty(); }

  TrialResult of_query(const PluginAbout& about) const {
    const fuzz::Case asked = parse_query(options_.query);
    if (std::ranges::find(about.offered, asked.predicate) == about.offered.end())
      throw BadUsage(options_.plugin + ": offers no " + std::string(to_string(asked.predicate)));
    return try_query(options_.plugin, asked, trial_options_);
  }

  std::vector<Dataset> datasets_to_try() const {
    if (!options_.points.empty()) return {};
    if (!options_.dataset.empty()) return {dataset_named(options_.dataset)};
    return {datasets().begin(), datasets().end()};
  }

  TrialResult of_triangulator(const Triangulator& triangulator) {
    if (!options_.points.empty())
      return try_points(triangulator, read_points(options_.points).points, trial_options_);
    return try_triangulator(triangulator, datasets_to_try(), trial_options_, watcher());
  }

  Watcher watcher() {
    return [this](const Exercise& exercise) {
      ++progress_.done;
      progress_.failures += failed(exercise.finding);
      if (print_) print_(progress_);
      return !interrupt_.requested();
    };
  }

  const TryOptions& options_;
  Interrupt interrupt_;
  TrialOptions trial_options_;
  bench::Progress progress_;
  std::function<void(const bench::Progress&)> print_;
};

void check_options(const TryOptions& options) {
  if (options.plugin.empty() == options.command.empty())
    throw BadUsage("one of --plugin and --command is wanted");
  const int inputs = !options.query.empty() + !options.points.empty() + !options.dataset.empty();
  if (inputs > 1) throw BadUsage("one of --query, --points and --dataset at a time");
}

}  // namespace

int try_outsider(const TryOptions& options, Console& console) {
  check_options(options);
  if (!options.picture.empty()) require_writable_folder(options.picture);
  try {
    Trial trial(options, console);
    TrialReport report;
    if (options.command.empty()) {
      const PluginAbout about = probe_plugin(options.plugin, {.seconds = options.seconds});
      const OfferAbout& offer = about.first();
      if (!about.predicates && !about.triangulator)
        throw BadUsage(options.plugin + ": offers a mesher alone, which is raced and not tried");
      report = {.name = offer.name,
                .cites = offer.cites,
                .summary = offer.summary,
                .result = trial.of_plugin(about),
                .interrupted = false};
    } else {
      report = {.name = options.command,
                .cites = {},
                .summary = {},
                .result = trial.of_command(),
                .interrupted = false};
    }
    report.interrupted = trial.interrupted();
    print_trial(report, console);
    if (!options.picture.empty()) draw_counterexamples(options.picture, report.result.counterexamples);
    return is_clean(report) ? good : judged_bad;
  } catch (const PluginError& error) {
    throw BadInput(error.what());
  }
}

}  // namespace tribunal::cli
