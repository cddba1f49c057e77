// The parts of the page, each a pure function from rows or trials to HTML.
#pragma once

#include "reports/page/page.hpp"

#include <string>

namespace tribunal::reports {

/// A tile per claim: the verdicts at one glance.
std::string verdict_strip(const ReportInput& input);

/// Every claim with its figures, reasoning, charts and the command that repeats it.
std::string claims_section(const ReportInput& input);

/// Backend x algorithm: how many runs ended how.
std::string outcomes_section(const ReportInput& input);

/// tau / N against the bound of eq. (3.3.0).
std::string tau_section(const ReportInput& input);

/// What a growth-model claim measured, with its rivals.
std::string scaling_section(const ReportInput& input);

/// Where each backend errs on a grid of neighbouring doubles.
std::string sign_maps_section(const ReportInput& input);

/// Backend x family of queries: what a query costs, by predicate.
std::string predicate_timings_section(const ReportInput& input);

/// Every kind of failure with an example and its command.
std::string failures_section(const ReportInput& input);

/// Machine, compiler, versions: what the figures hold for.
std::string provenance_section(const ReportInput& input);

}  // namespace tribunal::reports
