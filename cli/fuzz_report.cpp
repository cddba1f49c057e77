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

json to_json(const FuzzFinding& finding) {
  const Counterexample& found = *finding.counterexample;
  json points = json::array();
  for (const double c : found.asked.numbers()) points.push_back(bench::fuzz::hex_float(c));
  json entry{{"backend", found.backend},
             {"predicate", to_string(found.asked.predicate)},
             {"points", points},
             {"exact", std::string(1, to_char(found.exact))},
             {"got", std::string(1, to_char(found.got))},
             {"stage", to_string(found.stage)},
             {"law", to_string(found.law)},
             {"source", found.source},
             {"replay", finding.replay}};
  if (!finding.file.empty()) entry["file"] = finding.file;
  if (!finding.picture.empty()) entry["picture"] = finding.picture;
  return entry;
}

/// The oracle's own trial, in words.
std::vector<std::string> oracle_faults(const HuntReport& report) {
  std::vector<std::string> faults;
  for (const auto& [asked, exact, certified] : report.oracle_faults)
    faults.push_back(std::string("the certified filter says ") + to_char(certified) + ", GMP " +
                     to_char(exact) + ": tribunal sign " + bench::fuzz::query_text(asked));
  return faults;
}

void print_document(Console& console, std::uint64_t seed, const HuntReport& report,
                    std::span<const FuzzFinding> findings) {
  json tallies = json::array(), counterexamples = json::array();
  for (const Tally& tally : report.tallies) tallies.push_back(to_json(tally));
  for (const FuzzFinding& finding : findings) counterexamples.push_back(to_json(finding));
  print_json(console, {{"checked", report.checked},
                       {"seconds", report.seconds ? json(*report.seconds) : json(nullptr)},
                       {"seed", seed},
                       {"oracle",
                        {{"kind", to_string(report.oracle)},
                         {"asked_gmp", report.asked_gmp},
                         {"rechecked", report.rechecked},
                         {"faults", oracle_faults(report)}}},
                       {"breaches", report.breaches},
                       {"backends", tallies},
                       {"counterexamples", counterexamples}});
}

/// "filter 9948 (13 at the threshold), exact 80".
std::string stages_text(const Tally& tally) {
  std::string text;
  for (std::size_t s = 0; s < tally.stages.size(); ++s) {
    if (tally.stages[s] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(stage_names[s]) + " " + std::to_string(tally.stages[s]);
    if (tally.near_threshold[s] != 0) text += " (" + std::to_string(tally.near_threshold[s]) + ")";
  }
  return text;
}

void print_text(Console& console, std::uint64_t seed, const HuntReport& report,
                std::span<const FuzzFinding> findings) {
  std::vector<std::vector<std::string>> rows{
      {"backend", "predicate", "checked", "refused", "wrong", "decided by (of a sample: at its threshold)"}};
  for (const Tally& tally : report.tallies)
    rows.push_back({tally.backend, std::string(to_string(tally.predicate)), std::to_string(tally.checked),
                    std::to_string(tally.refused), std::to_string(tally.wrong), stages_text(tally)});
  print_table(console, rows);
  console.out << '\n'
              << report.checked << " queries checked, seed " << seed << "; oracle "
              << to_string(report.oracle) << ": GMP asked about " << report.asked_gmp << ", of them "
              << report.rechecked << " to check the filter\n";
  for (const std::string& fault : oracle_faults(report))
    console.out << "the oracle failed: " << fault << '\n';
  for (const std::string& breach : report.breaches) console.out << breach << '\n';
  for (const FuzzFinding& finding : findings) {
    const Counterexample& found = *finding.counterexample;
    console.out << '\n'
                << found.backend << ' ' << to_string(found.asked.predicate) << ": exactly "
                << to_char(found.exact) << ", got " << to_char(found.got) << " (" << to_string(found.stage)
                << (found.law == bench::fuzz::Law::antisymmetry ? ", not antisymmetric" : "") << "; from "
                << found.source << ")\n  " << finding.replay << '\n';
    if (!finding.file.empty()) console.out << "  saved as " << finding.file << '\n';
    if (!finding.picture.empty()) console.out << "  drawn in " << finding.picture << '\n';
  }
}

}  // namespace

void print_hunt(Console& console, std::uint64_t seed, const HuntReport& report,
                std::span<const FuzzFinding> findings) {
  console.json ? print_document(console, seed, report, findings)
               : print_text(console, seed, report, findings);
}

}  // namespace tribunal::cli
