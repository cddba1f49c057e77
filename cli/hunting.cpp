#include "cli/hunting.hpp"

#include "bench/fuzz/picture.hpp"
#include "bench/interrupt.hpp"
#include "bench/outsider/printable.hpp"
#include "bench/outsider/watched.hpp"
#include "cli/fuzz_report.hpp"

#include <algorithm>
#include <cfenv>
#include <chrono>
#include <ostream>
#include <unistd.h>

namespace tribunal::cli {
namespace {
using bench::Ending;
using bench::LifeSigns;
using bench::fuzz::Counterexample;
using bench::fuzz::HuntProgress;
using bench::fuzz::HuntReport;
using bench::fuzz::Subject;
using bench::fuzz::Tally;
using nlohmann::json;

constexpr std::chrono::seconds patience{5};

using Watch = std::function<bool(const HuntProgress&)>;

/// Prints now and then; goes on until the user interrupts.
Watch progress_printer(Console& console, bench::Interrupt& interrupt) {
  using Clock = std::chrono::steady_clock;
  const bool redraw = console.progress == Progress::automatic && isatty(STDERR_FILENO);
  const auto pause = std::chrono::seconds(redraw ? 1 : 10);
  return [=, &console, &interrupt, next = Clock::now() + pause](const HuntProgress& at) mutable {
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

std::size_t number_of(std::span<const Suspect> suspects, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(suspects, name, &Suspect::name) - suspects.begin());
}

HuntFound hunt(const HuntRequest& request, const LifeSigns& life, const Watch& watch) {
  std::vector<std::string> breaches;
  bench::fuzz::HuntOptions options = request.hunt;
  options.subjects = subjects_of(request.suspects, life, breaches);
  options.progress = watch;
  HuntReport report = bench::fuzz::hunt(options);
  report.breaches.insert(report.breaches.begin(), breaches.begin(), breaches.end());

  HuntFound found;
  for (const Tally& tally : report.tallies) {
    if (!tally.counterexample) continue;
    const Counterexample& shown = *tally.counterexample;
    Keepsake& kept = found.keepsakes.emplace_back();
    kept.corpus = bench::fuzz::corpus_text({shown.asked, shown.exact});
    if (request.pictures)
      kept.picture =
          bench::fuzz::picture_of(shown, options.subjects[number_of(request.suspects, shown.backend)]);
  }
  std::fesetenv(FE_DFL_ENV);  // a picture asks an outsider once more
  found.document = hunt_document(options.seed, report, [&](const Counterexample& shown) {
    return request.replay_of(request.suspects[number_of(request.suspects, shown.backend)], shown);
  });
  return found;
}

/// What there is to say of a hunt whose process is gone.
HuntFound report_death(const HuntRequest& request, const LifeSigns& life, const Ending& ending) {
  const Suspect& suspect = request.suspects[life.subject.value() % request.suspects.size()];
  HuntReport report;
  report.checked = life.checked.value();
  report.oracle = request.hunt.oracle;
  if (request.hunt.seconds) report.seconds = ending.seconds;
  report.breaches.push_back(suspect.name + ": " + bench::printable(ending.reason) + ", after " +
                            std::to_string(report.checked) + " queries; tribunal try " + option_of(suspect) +
                            " outlives it and tells the query");
  return {hunt_document(request.hunt.seed, report, {}), {}};
}

HuntFound hunt_in_child(const HuntRequest& request, const LifeSigns& life, const Watch& watch) {
  const auto work = [&] {
    const HuntFound found = hunt(request, life, [&](const HuntProgress& at) {
      life.checked.set(at.checked);
      life.wrong.set(at.wrong);
      life.beat();
      return life.stop.value() == 0;
    });
    return json(found).dump(-1, ' ', false, json::error_handler_t::replace);
  };
  const Ending ending = bench::run_watched(work, life, patience, [&] {
    if (!watch({life.checked.value(), life.wrong.value()})) life.stop.set(1);
  });
  if (ending.outcome != Outcome::ok) return report_death(request, life, ending);
  return json::parse(ending.result).get<HuntFound>();
}

}  // namespace

HuntFound run_hunt(const HuntRequest& request, Console& console) {
  const LifeSigns life;
  bench::Interrupt interrupt;
  const Watch watch = progress_printer(console, interrupt);
  const bool has_outsiders = std::ranges::any_of(request.suspects, &Suspect::is_plugin);
  return has_outsiders ? hunt_in_child(request, life, watch) : hunt(request, life, watch);
}

}  // namespace tribunal::cli
