// tribunal fuzz: wrong signs hunted with hostile queries, against exact integers.
#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/hunt.hpp"
#include "bench/fuzz/picture.hpp"
#include "bench/interrupt.hpp"
#include "cli/fuzz_report.hpp"
#include "cli/lookup.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/text.hpp"
#include "predicates/backends/list.hpp"
#include "predicates/plugin/loader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <ostream>
#include <system_error>
#include <unistd.h>

namespace tribunal::cli {
namespace {
namespace fuzz_bench = bench::fuzz;
using fuzz_bench::Counterexample;
using fuzz_bench::HuntReport;
using fuzz_bench::Subject;
using fuzz_bench::Tally;
using nlohmann::json;

/// What is on trial, and how the command line named it.
struct Suspects {
  std::vector<Subject> subjects;
  std::map<std::string, std::string> plugins;  ///< the library of each subject that is a plug-in
  bool named = false;                          ///< by the user: then none of them may be wrong
};

Subject load_plugin(const std::string& path) {
  try {
    const SharedLibrary library(path);
    const auto plugin = PredicatePlugin::load(library);
    if (!plugin) throw BadUsage(path + " offers no predicates");
    return {.name = plugin->name(),
            .exact = true,
            .bind2 = [plugin](std::span<const Point2> points) { return plugin->bind2(points); },
            .bind3 = [plugin](std::span<const Point3> points) { return plugin->bind3(points); },
            .offers = [plugin](Predicate predicate) { return plugin->offers(predicate); }};
  } catch (const PluginError& error) {
    throw BadUsage(error.what());
  }
}

Suspects suspects_of(const FuzzOptions& options) {
  Suspects suspects;
  for (const std::string& name : options.backends)
    suspects.subjects.push_back(fuzz_bench::subject_of(backend_named(name)));
  for (const std::string& path : options.plugins) {
    suspects.subjects.push_back(load_plugin(path));
    suspects.plugins[suspects.subjects.back().name] = path;
  }
  suspects.named = !suspects.subjects.empty();
  if (!suspects.named)
    for (const BackendEntry& entry : backends()) suspects.subjects.push_back(fuzz_bench::subject_of(entry));
  return suspects;
}

fuzz_bench::OracleKind oracle_named(const std::string& name) {
  for (const auto kind : {fuzz_bench::OracleKind::staged, fuzz_bench::OracleKind::gmp})
    if (name == to_string(kind)) return kind;
  throw BadUsage("the oracle is staged or gmp, not '" + name + "'");
}

fuzz_bench::HuntOptions hunt_options(const FuzzOptions& options, const std::vector<Subject>& subjects) {
  fuzz_bench::HuntOptions hunt;
  hunt.subjects = subjects;
  if (!options.predicates.empty()) hunt.predicates.clear();
  for (const std::string& name : options.predicates) hunt.predicates.push_back(predicate_named(name));
  for (const Subject& subject : subjects)
    if (std::none_of(hunt.predicates.begin(), hunt.predicates.end(), subject.offers))
      throw BadUsage("backend '" + subject.name + "' has none of these predicates");
  hunt.seed = options.seed;
  hunt.queries = options.queries;
  hunt.seconds = options.seconds;
  if (!hunt.queries && !hunt.seconds) hunt.seconds = default_fuzz_seconds;
  hunt.oracle = oracle_named(options.oracle);
  if (!options.corpus.empty()) hunt.corpus = fuzz_bench::load_corpus(options.corpus);
  return hunt;
}

/// Prints now and then; goes on until the user interrupts.
std::function<bool(const fuzz_bench::HuntProgress&)> progress_printer(Console& console,
                                                                      bench::Interrupt& interrupt) {
  using Clock = std::chrono::steady_clock;
  const bool redraw = console.progress == Progress::automatic && isatty(STDERR_FILENO);
  const auto pause = std::chrono::seconds(redraw ? 1 : 10);
  return [=, &console, &interrupt, next = Clock::now() + pause](const fuzz_bench::HuntProgress& at) mutable {
    if (console.progress == Progress::none || Clock::now() < next) return !interrupt.requested();
    next = Clock::now() + pause;
    if (console.progress == Progress::json)
      console.log << json{{"checked", at.checked}, {"wrong", at.wrong}}.dump() << '\n' << std::flush;
    else
      console.log << (redraw ? "\r\033[K" : "") << at.checked << " queries checked, " << at.wrong
                  << " wrong answers" << (redraw ? "" : "\n") << std::flush;
    return !interrupt.requested();
  };
}

/// The command that repeats a wrong answer.
std::string replay_of(const Counterexample& found, const FuzzOptions& options, const Suspects& suspects) {
  const auto plugin = suspects.plugins.find(found.backend);
  const bool is_plugin = plugin != suspects.plugins.end();
  const std::string subject = is_plugin ? "--plugin " + plugin->second : "--backend " + found.backend;
  if (!found.alone) {  // it takes the points bound with it: the sequence up to there
    std::string command = "tribunal fuzz " + subject + " --seed " + std::to_string(options.seed) +
                          " --queries " + std::to_string(found.drawn);
    for (const std::string& name : options.predicates) command += " --predicate " + name;
    return options.corpus.empty() ? command : command + " --corpus " + options.corpus;
  }
  const std::string query = fuzz_bench::query_text(found.asked);
  if (is_plugin) return "tribunal try " + subject + " --query '" + query + "'";
  return "tribunal sign " + query + " " + subject + " --backend gmp";
}

std::string write_picture(const std::string& folder, const Counterexample& found, const Subject& subject) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(folder + ": " + error.message());
  const auto file = std::filesystem::path(folder) /
                    (found.backend + "-" + std::string(to_string(found.asked.predicate)) + ".svg");
  write_text(file, fuzz_bench::picture_of(found, subject));
  return file.string();
}

std::vector<FuzzFinding> keep_findings(const HuntReport& report, const FuzzOptions& options,
                                       const Suspects& suspects) {
  std::vector<FuzzFinding> findings;
  for (const Tally& tally : report.tallies) {
    if (!tally.counterexample) continue;
    const Counterexample& found = *tally.counterexample;
    FuzzFinding finding{&found, replay_of(found, options, suspects), {}, {}};
    if (!options.corpus.empty())
      finding.file = fuzz_bench::save_to_corpus(options.corpus, {found.asked, found.exact}).string();
    const auto subject = std::find_if(suspects.subjects.begin(), suspects.subjects.end(),
                                      [&](const Subject& s) { return s.name == found.backend; });
    if (!options.picture.empty()) finding.picture = write_picture(options.picture, found, *subject);
    findings.push_back(std::move(finding));
  }
  return findings;
}

bool is_clean(const HuntReport& report, bool named) {
  return report.oracle_faults.empty() && report.breaches.empty() &&
         std::none_of(report.tallies.begin(), report.tallies.end(),
                      [&](const Tally& tally) { return tally.wrong != 0 && (named || tally.exact); });
}

}  // namespace

int fuzz(const FuzzOptions& options, Console& console) {
  const Suspects suspects = suspects_of(options);
  fuzz_bench::HuntOptions hunt = hunt_options(options, suspects.subjects);
  HuntReport report;
  {
    bench::Interrupt interrupt;
    hunt.progress = progress_printer(console, interrupt);
    report = fuzz_bench::hunt(hunt);
  }
  const std::vector<FuzzFinding> findings = keep_findings(report, options, suspects);
  print_hunt(console, options.seed, report, findings);
  return is_clean(report, suspects.named) ? good : judged_bad;
}

}  // namespace tribunal::cli
