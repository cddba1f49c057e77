// Each judge's entry; its file says what it decides and how. The list is list.cpp.
#pragma once

#include "reports/judges/judge.hpp"

namespace tribunal::reports {

extern const Judge expected_tau_judge;
extern const Judge scope_identities_judge;
extern const Judge mean_below_bound_judge;
extern const Judge mean_at_value_judge;
extern const Judge single_runs_below_bound_judge;
extern const Judge run_identities_judge;
extern const Judge order_determines_tau_judge;
extern const Judge growth_model_judge;
extern const Judge failure_rates_judge;
extern const Judge exact_signs_judge;
extern const Judge witnesses_judge;
extern const Judge sign_map_counts_judge;

}  // namespace tribunal::reports
