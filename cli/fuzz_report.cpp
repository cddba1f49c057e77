#include "cli/fuzz_report.hpp"

#include "bench/fuzz/bytes.hpp"
#include "bench/fuzz/hex_float.hpp"

#include <nlohmann/json.hpp>

#include <ostream>
#include <vector>

namespace tribunal::cli {
namespace {
using bench::fuzz::Counterexample;
using bench::fuzz::HuntReport;
using bench::fuzz::Tally;
using nlohmann::json;

json by_stage(const Tally::ByStage& counts) {
  json stages = json::object();
  for (std::size_t s = 0; s < counts.size(); ++s)
    if (counts[s] != 0) stages[std::string(stage_names[s])] = counts[s];
  return stages;
}

json to_json(const Tally& tally) {
  json entry{{"backend", tally.backend},
             {"exact", tally.exact},
             {"predicate", to_string(tally.predicate)},
             {"checked", tally.checked},
             {"refused", tally.refused},
             {"wrong", tally.wrong},
             {"stages", by_stage(tally.stages)},
             {"near_threshold", by_stage(tally.near_threshold)}};
  if (!tally.refusal.empty()) entry["refusal"] = tally.refusal;
  return entry;
}

json to_json(const Counterexample& found, const std::string& replay) {
  json points = json::array();
  for (const double c : found.asked.numbers()) points.push_back(bench::fuzz::hex_float(c));
  return {{"backend", found.backend},
          {"predicate", to_string(found.asked.predicate)},
          {"points", points},
          {"exact", std::string(1, to_char(found.exact))},
          {"got", std::string(1, to_char(found.got))},
          {"stage", to_string(found.stage)},
          {"law", to_string(found.law)},
          {"source", found.source},
          {"replay", replay}};
}

/// The oracle's own trial, in words.
std::vector<std::string> oracle_faults(const HuntReport& report) {
  std::vector<std::string> faults;
  for (const auto& [asked, exact, certified] : report.oracle_faults)
    faults.push_back(std::string("the certified filter says ") + to_char(certified) + ", GMP " +
                     to_char(exact) + ": tribunal sign " + bench::fuzz::query_text(asked));
  return faults;
}

/// "filter 9948 (13), exact 80".
std::string stages_text(const json& tally) {
  std::string text;
  for (const std::string_view stage : stage_names) {
    const json &answers = tally["stages"], &near = tally["near_threshold"];
    if (!answers.contains(stage)) continue;
    text += (text.empty() ? "" : ", ") + std::string(stage) + " " + answers[stage].dump();
    if (near.contains(stage)) text += " (" + near[stage].dump() + ")";
  }
  return text;
}

std::string text_of(const json& value) { return value.get<std::string>(); }

void print_tallies(Console& console, const json& tallies) {
  std::vector<std::vector<std::string>> rows{
      {"backend", "predicate", "checked", "refused", "wrong", "decided by (of a sample: at its threshold)"}};
  for (const json& tally : tallies)
    rows.push_back({text_of(tally["backend"]), text_of(tally["predicate"]), tally["checked"].dump(),
                    tally["refused"].dump(), tally["wrong"].dump(), stages_text(tally)});
  print_table(console, rows);
}

void print_counterexample(Console& console, const json& found) {
  console.out << '\n'
              << text_of(found["backend"]) << ' ' << text_of(found["predicate"]) << ": exactly "
              << text_of(found["exact"]) << ", got " << text_of(found["got"]) << " ("
              << text_of(found["stage"])
              << (found["law"] == to_string(bench::fuzz::Law::antisymmetry) ? ", not antisymmetric" : "")
              << "; from " << text_of(found["source"]) << ")\n  " << text_of(found["replay"]) << '\n';
  if (found.contains("file")) console.out << "  saved as " << text_of(found["file"]) << '\n';
  if (found.contains("picture")) console.out << "  drawn in " << text_of(found["picture"]) << '\n';
}

void print_text(Console& console, const json& document) {
  const json& oracle = document["oracle"];
  print_tallies(console, document["backends"]);
  console.out << '\n'
              << document["checked"] << " queries checked, seed " << document["seed"] << "; oracle "
              << text_of(oracle["kind"]) << ": GMP asked about " << oracle["asked_gmp"] << ", of them "
              << oracle["rechecked"] << " to check the filter\n";
  for (const json& fault : oracle["faults"]) console.out << "the oracle failed: " << text_of(fault) << '\n';
  for (const json& breach : document["breaches"]) console.out << text_of(breach) << '\n';
  for (const json& found : document["counterexamples"]) print_counterexample(console, found);
}

}  // namespace

json hunt_document(std::uint64_t seed, const HuntReport& report,
                   const std::function<std::string(const Counterexample&)>& replay_of) {
  json tallies = json::array(), counterexamples = json::array();
  for (const Tally& tally : report.tallies) {
    tallies.push_back(to_json(tally));
    if (tally.counterexample)
      counterexamples.push_back(to_json(*tally.counterexample, replay_of(*tally.counterexample)));
  }
  return {{"checked", report.checked},
          {"seconds", report.seconds ? json(*report.seconds) : json(nullptr)},
          {"seed", seed},
          {"oracle",
           {{"kind", to_string(report.oracle)},
            {"asked_gmp", report.asked_gmp},
            {"rechecked", report.rechecked},
            {"faults", oracle_faults(report)}}},
          {"breaches", report.breaches},
          {"backends", tallies},
          {"counterexamples", counterexamples}};
}

void print_hunt(Console& console, const json& document) {
  console.json ? print_json(console, document) : print_text(console, document);
}

}  // namespace tribunal::cli
