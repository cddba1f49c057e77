#include "reports/judges/list.hpp"

#include "reports/judges/judges.hpp"

#include <algorithm>
#include <array>

namespace tribunal::reports {

std::span<const Judge> judges() {
  // Built on first use: the entries live in other files, whose order of initialisation is nobody's business.
  static const std::array all{
      expected_tau_judge,
      scope_identities_judge,
      mean_below_bound_judge,
      mean_at_value_judge,
      single_runs_below_bound_judge,
      run_identities_judge,
      order_determines_tau_judge,
      growth_model_judge,
      failure_rates_judge,
      exact_signs_judge,
      witnesses_judge,
      sign_map_counts_judge,
  };
  return all;
}

const Judge* find_judge(std::string_view name) {
  const auto all = judges();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Judge& judge) { return judge.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribunal::reports
