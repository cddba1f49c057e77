// The page: one HTML file that holds everything a run found, readable offline and without JavaScript.
#pragma once

#include "bench/row.hpp"
#include "reports/trial.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <string>

namespace tribunal::reports {

struct ReportInput {
  nlohmann::json manifest;  ///< manifest.json of the run: shown as it is
  std::span<const bench::Row> rows;
  std::span<const Tried> trials;  ///< the claims in the order in which they are shown
};

/// A complete document. Pure: same input, same bytes. Everything from the input is escaped; no address is
/// ever fetched, which the page's own content security policy enforces. Interactive where the charting
/// libraries were built in.
std::string page(const ReportInput& input);

}  // namespace tribunal::reports
