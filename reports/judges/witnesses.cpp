// Judge "witnesses": does a printed program give the right sign, on inputs named beforehand and on random
// ones?
//
// Rows of the experiment `knuth-printed`. refuted: the printed code errs on a witness (its sign differs from
// the exact one) or on a random case; reproduced: it never errs. The corrected transcription runs beside it:
// were it wrong too, the fault might be the transcriber's, and there is no verdict. Rates depend on how the
// cases are drawn, so each is named with its generator and seed.
#include "reports/judges/evidence.hpp"
#include "reports/judges/listed.hpp"
#include "reports/text.hpp"

namespace tribunal::reports {
namespace {

std::string sign_text(double sign) { return sign > 0 ? "+" : sign < 0 ? "-" : "0"; }

/// Reads witness.1, witness.2, ... as far as there are any.
std::uint64_t count_failed_witnesses(const bench::Row& row, Judgement& judgement) {
  std::uint64_t failed = 0;
  for (int i = 1; row.counters.contains("witness." + std::to_string(i) + ".exact"); ++i) {
    const std::string name = "witness." + std::to_string(i);
    const double exact = counter(row, name + ".exact");
    const double printed = counter(row, name + ".printed");
    if (counter(row, name + ".corrected") != exact)
      throw Incomplete("the corrected code errs on " + name + ": the transcription is not to be trusted");
    failed += printed != exact ? 1 : 0;
    judgement.lines.push_back("Witness " + std::to_string(i) + ": exact sign " + sign_text(exact) +
                              ", printed code " + sign_text(printed) + ", corrected code " +
                              sign_text(exact));
  }
  return failed;
}

std::string generator_of(const bench::Row& row) {
  const auto found = row.cell.parameters.find("generator");
  return found == row.cell.parameters.end() ? "uniform" : found->second;
}

std::string rate_line(const bench::Row& row) {
  std::string line = generator_of(row) + ", seed " + std::to_string(row.cell.seed) + ", " +
                     number_text(counter(row, "queries")) + " cases, wrong signs:";
  for (const auto& [name, value] : row.counters)
    if (name.starts_with("wrong."))
      line += concat(" ", name.substr(6), " ", percent_text(value / counter(row, "queries")), ",");
  line.pop_back();
  return line;
}

Judgement judge(const Rule& /*rule*/, Rows rows) {
  require_finished(rows);
  Judgement judgement;
  std::uint64_t failed_witnesses = count_failed_witnesses(rows.front(), judgement);
  double wrong = 0;
  double queries = 0;
  for (const bench::Row& row : rows) {
    if (counter(row, "wrong.corrected") > 0)
      throw Incomplete("the corrected code errs on random cases: the transcription is not to be trusted");
    judgement.lines.push_back(rate_line(row));
    if (generator_of(row) != generator_of(rows.front())) continue;
    wrong += counter(row, "wrong.printed");
    queries += counter(row, "queries");
  }
  judgement.quantity = "share of wrong signs of the printed code, " + generator_of(rows.front()) + " cases";
  judgement.measured = wrong / queries;
  judgement.interval = bench::wilson(static_cast<std::uint64_t>(wrong), static_cast<std::uint64_t>(queries));
  judgement.bound = 0;
  const bool errs = failed_witnesses > 0 || wrong > 0;
  judgement.verdict = errs ? Verdict::refuted : Verdict::reproduced;
  if (errs) judgement.p_value = 0;
  return judgement;
}

}  // namespace

constinit const Judge witnesses_judge{
    "witnesses", "a printed program's signs on named witnesses and random cases", {}, judge};

}  // namespace tribunal::reports
