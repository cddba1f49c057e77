#include "reports/trial.hpp"

#include "reports/judges/evidence.hpp"
#include "reports/judges/list.hpp"

#include <nlohmann/json.hpp>

#include <cassert>
#include <limits>

namespace tribunal::reports {

Judgement try_claim(const Claim& claim, Rows rows) {
  Judgement judgement;
  if (rows.empty()) {
    judgement.verdict = Verdict::untried;
    judgement.lines.push_back("There are no result rows of this claim's cells.");
    return judgement;
  }
  const Judge* judge = find_judge(claim.rule.judge);
  assert(judge != nullptr);  // parse_claim admits no other
  try {
    return judge->judge(claim.rule, rows);
  } catch (const Incomplete& reason) {
    judgement.verdict = Verdict::inconclusive;
    judgement.lines.push_back("No verdict: " + std::string(reason.what()) + ".");
    return judgement;
  }
}

nlohmann::json claims_json(std::span<const Tried> trials) {
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
  };
  const Family all = family(trials);
  nlohmann::json claims = nlohmann::json::array();
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto& [claim, judgement, command] = trials[i];
    nlohmann::json interval = nullptr;
    if (judgement.interval) interval = {judgement.interval->low, judgement.interval->high};
    claims.push_back(
        {{"id", claim.id},
         {"title", claim.title},
         {"statement", claim.statement},
         {"source", claim.source},
         {"verdict", to_string(judgement.verdict)},
         {"expected", to_string(claim.expected)},
         {"quantity", judgement.quantity},
         {"measured", or_null(judgement.measured)},
         {"interval", interval},
         {"bound", or_null(judgement.bound)},
         {"p_value", or_null(judgement.p_value)},
         {"p_value_holm", judgement.p_value ? nlohmann::json(all.adjusted[i]) : nlohmann::json(nullptr)},
         {"lines", judgement.lines},
         {"command", command}});
  }
  return {{"claims", claims}, {"expected_false_refutations", all.expected_false_refutations}};
}

Family family(std::span<const Tried> trials) {
  Family result;
  result.adjusted.assign(trials.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::size_t> stated;
  std::vector<double> p_values;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    result.expected_false_refutations += trials[i].judgement.false_refutation;
    if (!trials[i].judgement.p_value) continue;
    stated.push_back(i);
    p_values.push_back(*trials[i].judgement.p_value);
  }
  const std::vector<double> adjusted = bench::holm(p_values);
  for (std::size_t i = 0; i < stated.size(); ++i) result.adjusted[stated[i]] = adjusted[i];
  return result;
}

}  // namespace tribunal::reports
