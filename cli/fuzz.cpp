// tribunal fuzz: wrong signs hunted with hostile queries, against exact integers.
#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/corpus.hpp"
#include "bench/outsider/replay.hpp"
#include "cli/fuzz_report.hpp"
#include "cli/hunting.hpp"
#include "cli/lookup.hpp"
#include "cli/output_folder.hpp"
#include "cli/verbs.hpp"
#include "datasets/files/files.hpp"
#include "datasets/files/text.hpp"
#include "predicates/plugin/library.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace tribunal::cli {
namespace {
namespace fuzz_bench = bench::fuzz;
using bench::shell_word;
using fuzz_bench::Counterexample;
using nlohmann::json;

fuzz_bench::OracleKind oracle_named(const std::string& name) {
  for (const auto kind : {fuzz_bench::OracleKind::staged, fuzz_bench::OracleKind::gmp})
    if (name == to_string(kind)) return kind;
  throw BadUsage("the oracle is staged or gmp, not '" + name + "'");
}

fuzz_bench::HuntOptions hunt_options(const FuzzOptions& options) {
  fuzz_bench::HuntOptions hunt;
  if (!options.predicates.empty()) hunt.predicates.clear();
  for (const std::string& name : each_once(options.predicates))
    hunt.predicates.push_back(predicate_named(name));
  hunt.seed = options.seed;
  hunt.queries = options.queries;
  hunt.seconds = options.seconds;
  if (!hunt.queries && !hunt.seconds) hunt.seconds = default_fuzz_seconds;
  hunt.oracle = oracle_named(options.oracle);
  if (!options.corpus.empty()) hunt.corpus = fuzz_bench::load_corpus(options.corpus);
  return hunt;
}

/// The command that repeats a wrong answer.
std::string replay(const FuzzOptions& options, const Suspect& suspect, const Counterexample& found) {
  const std::string subject = option_of(suspect);
  if (!found.alone) {  // it takes the points bound with it: the sequence up to there
    std::string command = "tribunal fuzz " + subject + " --seed " + std::to_string(options.seed) +
                          " --queries " + std::to_string(found.drawn);
    for (const std::string& name : options.predicates) command += " --predicate " + name;
    return options.corpus.empty() ? command : command + " --corpus " + shell_word(options.corpus);
  }
  if (suspect.is_plugin()) return bench::replay_query(subject, found.asked);
  return "tribunal sign " + fuzz_bench::query_text(found.asked) + " " + subject + " --backend gmp";
}

HuntRequest request_of(const FuzzOptions& options) {
  HuntRequest request{.suspects = suspects_of(options.backends, options.plugins),
                      .hunt = hunt_options(options),
                      .pictures = !options.picture.empty(),
                      .replay_of = [&options](const Suspect& suspect, const Counterexample& found) {
                        return replay(options, suspect, found);
                      }};
  for (const Suspect& suspect : request.suspects)
    if (std::ranges::find_first_of(request.hunt.predicates, suspect.offered) == request.hunt.predicates.end())
      throw BadUsage("backend '" + suspect.name + "' has none of these predicates");
  return request;
}

/// A file's name from an outsider's: what is neither letter nor digit is a dash, so that it cannot lead out
/// of the folder.
std::string file_name(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_' && c != '+'; }, '-');
  return name;
}

/// Writes what is to be kept and says in the document where it is. Throws BadInput.
void keep(HuntFound& found, const FuzzOptions& options) {
  for (std::size_t i = 0; i < found.keepsakes.size(); ++i) {
    json& shown = found.document["counterexamples"][i];
    const Keepsake& kept = found.keepsakes[i];
    const std::string name =
        shown["backend"].get<std::string>() + "-" + shown["predicate"].get<std::string>();
    if (!options.corpus.empty()) {
      const auto entry = fuzz_bench::parse_corpus_entry("counterexample of " + name, kept.corpus);
      shown["file"] = fuzz_bench::save_to_corpus(options.corpus, entry).string();
    }
    if (!options.picture.empty()) {
      const auto file = std::filesystem::path(options.picture) / (file_name(name) + ".svg");
      write_text(file, kept.picture);
      shown["picture"] = file.string();
    }
  }
}

bool is_clean(const json& document, bool named) {
  return document["oracle"]["faults"].empty() && document["breaches"].empty() &&
         std::ranges::none_of(document["backends"], [&](const json& tally) {
           return tally["wrong"] != 0 && (named || tally["exact"] == true);
         });
}

/// Which of those that were named has given no answer, and why; empty where all have. Nothing judged is no
/// success.
std::string unjudged(const json& document, const std::vector<Suspect>& suspects, bool named) {
  if (document["checked"] == 0 && !named) return "no query was checked";
  for (const Suspect& suspect : suspects) {
    std::uint64_t checked = 0, refused = 0;
    std::string refusal;
    for (const json& tally : document["backends"]) {
      if (tally["backend"] != suspect.name) continue;
      checked += tally["checked"].get<std::uint64_t>();
      refused += tally["refused"].get<std::uint64_t>();
      if (refusal.empty()) refusal = tally.value("refusal", "");
    }
    if (!named || checked != 0) continue;
    if (refused == 0) return suspect.name + ": nothing was judged, for nothing was asked";
    return suspect.name + ": nothing was judged, for it refused all " + std::to_string(refused) +
           " queries: " + refusal;
  }
  return {};
}

}  // namespace

int fuzz(const FuzzOptions& options, Console& console) try {
  const HuntRequest request = request_of(options);
  for (const std::string& folder : {options.corpus, options.picture})
    if (!folder.empty()) require_writable_folder(folder);
  HuntFound found = run_hunt(request, console);
  std::string trouble;  // told after what was found
  try {
    keep(found, options);
  } catch (const BadInput& error) {
    trouble = error.what();
  }
  print_hunt(console, found.document);
  if (!trouble.empty()) throw BadInput(trouble);
  const bool named = !options.backends.empty() || !options.plugins.empty();
  if (!is_clean(found.document, named)) return judged_bad;
  if (const std::string idle = unjudged(found.document, request.suspects, named); !idle.empty())
    throw BadUsage(idle);
  return good;
} catch (const PluginError& error) {
  throw BadUsage(error.what());
}

}  // namespace tribunal::cli
