#include "reports/claim.hpp"

#include "reports/embedded.hpp"
#include "reports/judges/list.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace tribunal::reports {
namespace {

/// Reads one file; every complaint carries the place of what it complains about.
class Reader {
 public:
  Reader(toml::table table, std::string file) : root_(std::move(table)), file_(std::move(file)) {}

  Claim claim() {
    constexpr std::array<std::string_view, 8> keys{"id",       "title", "statement", "source",
                                                   "expected", "rule",  "quick",     "full"};
    for (const auto& [key, value] : root_)
      if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
        fail(key.source(), "unknown key \"" + std::string(key.str()) + "\"");
    Claim claim;
    claim.file = file_;
    claim.id = required_text(root_, "id");
    claim.title = required_text(root_, "title");
    claim.statement = required_text(root_, "statement");
    claim.source = required_text(root_, "source");
    claim.expected = expected();
    claim.rule = rule();
    take_tier(claim, "quick");
    if (root_.contains("full")) take_tier(claim, "full");
    return claim;
  }

 private:
  [[noreturn]] void fail(const toml::source_region& place, const std::string& reason) const {
    std::ostringstream message;
    message << file_ << ':' << place.begin.line << ':' << place.begin.column << ": " << reason;
    throw ClaimError(message.str());
  }

  const toml::node& required(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) fail(table.source(), "missing key \"" + std::string(key) + "\"");
    return *node;
  }

  std::string required_text(const toml::table& table, std::string_view key) const {
    const toml::node& node = required(table, key);
    const auto* value = node.as_string();
    if (value == nullptr || value->get().empty())
      fail(node.source(), "\"" + std::string(key) + "\" is a text that is not empty");
    return value->get();
  }

  Verdict expected() const {
    const std::string name = required_text(root_, "expected");
    if (name == "reproduced") return Verdict::reproduced;
    if (name == "refuted") return Verdict::refuted;
    fail(root_.get("expected")->source(), "expected is \"reproduced\" or \"refuted\", not \"" + name + "\"");
  }

  Rule rule() const {
    const toml::node& node = required(root_, "rule");
    const toml::table* table = node.as_table();
    if (table == nullptr) fail(node.source(), "\"rule\" is a table");
    Rule rule;
    rule.judge = required_text(*table, "judge");
    const Judge* judge = find_judge(rule.judge);
    if (judge == nullptr) fail(table->get("judge")->source(), "no judge is named \"" + rule.judge + "\"");
    for (const auto& [key, value] : *table)
      if (key.str() != "judge") rule.parameters[std::string(key.str())] = parameter(*judge, key, value);
    for (const Parameter& wanted : judge->parameters)
      if (wanted.required && !rule.parameters.contains(wanted.name))
        fail(table->source(), "judge \"" + rule.judge + "\" needs \"" + std::string(wanted.name) + "\"");
    return rule;
  }

  nlohmann::json parameter(const Judge& judge, const toml::key& key, const toml::node& value) const {
    const auto known = std::find_if(judge.parameters.begin(), judge.parameters.end(),
                                    [&](const Parameter& p) { return p.name == key.str(); });
    if (known == judge.parameters.end())
      fail(key.source(),
           "judge \"" + std::string(judge.name) + "\" has no parameter \"" + std::string(key.str()) + "\"");
    nlohmann::json json = scalar_or_list(value);
    if (!fits(json, known->kind))
      fail(value.source(), "\"" + std::string(key.str()) + "\" has the wrong type");
    return json;
  }

  /// Rules hold numbers, texts, yes or no, lists of them, and flat tables; nothing nests deeper.
  nlohmann::json scalar_or_list(const toml::node& node) const {
    if (const auto* value = node.as_string()) return value->get();
    if (const auto* value = node.as_integer()) return value->get();
    if (const auto* value = node.as_floating_point()) return value->get();
    if (const auto* value = node.as_boolean()) return value->get();
    if (const auto* array = node.as_array()) {
      nlohmann::json json = nlohmann::json::array();
      for (const toml::node& item : *array)
        json.push_back(item.is_table() ? flat(*item.as_table()) : scalar(item));
      return json;
    }
    fail(node.source(), "a rule holds numbers, texts, true, false and lists of them");
  }

  nlohmann::json scalar(const toml::node& node) const {
    if (node.is_array()) fail(node.source(), "a list within a list");
    return scalar_or_list(node);
  }

  nlohmann::json flat(const toml::table& table) const {
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [key, value] : table) json[std::string(key.str())] = scalar(value);
    return json;
  }

  static bool fits(const nlohmann::json& json, ParameterKind kind) {
    const auto all = [&](auto&& is) { return json.is_array() && std::all_of(json.begin(), json.end(), is); };
    switch (kind) {
      case ParameterKind::number:
        return json.is_number();
      case ParameterKind::text:
        return json.is_string();
      case ParameterKind::texts:
        return all([](const auto& item) { return item.is_string(); });
      case ParameterKind::tables:
        return all([](const auto& item) { return item.is_object(); });
    }
    return false;
  }

  /// Moves the cells out of the file's table: moved nodes keep the lines they came from, copied ones do not.
  void take_tier(Claim& claim, std::string_view name) {
    const toml::node& node = required(root_, name);
    if (!node.is_array_of_tables())
      fail(node.source(), "\"" + std::string(name) + "\" is a list of cell tables");
    toml::table tier;
    tier.insert("cells", std::move(*root_.get_as<toml::array>(name)));
    claim.tiers.emplace(name, std::make_shared<const toml::table>(std::move(tier)));
  }

  toml::table root_;
  std::string file_;
};

}  // namespace

const toml::table& Claim::tier(std::string_view name) const {
  const auto found = tiers.find(name);
  return found == tiers.end() ? *tiers.at("quick") : *found->second;
}

Claim parse_claim(std::string_view text, const std::string& file) {
  try {
    return Reader(toml::parse(text, file), file).claim();
  } catch (const toml::parse_error& error) {
    std::ostringstream message;
    message << file << ':' << error.source().begin.line << ':' << error.source().begin.column << ": "
            << error.description();
    throw ClaimError(message.str());
  }
}

std::vector<Claim> registered_claims() {
  std::vector<Claim> claims;
  for (const EmbeddedFile& file : embedded_claims())
    claims.push_back(parse_claim(file.text, std::string(file.name)));
  return claims;
}

}  // namespace tribunal::reports
