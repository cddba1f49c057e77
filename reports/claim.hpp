// A claim as data: what somebody stated, the cells that try it, the rule that judges it.
#pragma once

#include "reports/judgement.hpp"

#include <nlohmann/json.hpp>
#include <toml++/toml.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::reports {

/// The name of a judge and the parameters the claim gives it.
struct Rule {
  std::string judge;
  nlohmann::json parameters = nlohmann::json::object();
};

struct Claim {
  std::string id;         ///< e.g. "T4": letters, digits and '-', the file's name without .toml
  std::string title;      ///< a few words, for tables and tiles
  std::string statement;  ///< in our own words
  std::string source;     ///< who stated it and where
  Verdict expected = Verdict::reproduced;
  Rule rule;
  /// By tier ("quick", and "full" where the file has one): a table whose array `cells` is what a campaign
  /// file's is.
  std::map<std::string, std::shared_ptr<const toml::table>, std::less<>> tiers;
  std::string file;  ///< for messages

  /// The cells of a tier, of the quick one where the file has no such tier.
  [[nodiscard]] const toml::table& tier(std::string_view name) const;
};

/// A claim file that is wrong; what() is "file:line:column: reason".
struct ClaimError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads one claim file. Throws ClaimError on bad TOML, an unknown or missing key, a value of the wrong type,
/// an unknown judge, or a parameter that this judge does not take. The cells themselves are the bench's to
/// check.
Claim parse_claim(std::string_view text, const std::string& file);

/// The claims built into the program, in the order of their list.
std::vector<Claim> registered_claims();

}  // namespace tribunal::reports
