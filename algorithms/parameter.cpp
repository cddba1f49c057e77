#include "algorithms/parameter.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

namespace tribunal {
namespace {

std::optional<std::uint64_t> parse_whole_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

template <class Range, class Name>
std::string listed(const Range& range, Name name_of) {
  std::string text;
  for (const auto& entry : range) text.append(text.empty() ? "" : ", ").append(name_of(entry));
  return text;
}

}  // namespace

std::string value_of(const Settings& settings, const Parameter& parameter) {
  const auto found = settings.find(std::string(parameter.name));
  std::string value = found == settings.end() ? std::string(parameter.standard) : found->second;
  assert(refuse(parameter, value).empty());
  return value;
}

std::optional<double> parse_number(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string describe_values(const Parameter& parameter) {
  if (parameter.values != nullptr) return std::string(parameter.values->describe);
  if (parameter.choices == nullptr)
    return "a whole number from " + std::to_string(parameter.least) + " to " + std::to_string(parameter.most);
  return "one of " + listed(parameter.choices(), [](std::string_view choice) { return choice; });
}

std::string refuse(const Parameter& parameter, std::string_view value) {
  if (parameter.values != nullptr) {
    if (parameter.values->holds(value)) return {};
  } else if (parameter.choices == nullptr) {
    const auto number = parse_whole_number(value);
    if (number && *number >= parameter.least && *number <= parameter.most) return {};
  } else {
    const auto choices = parameter.choices();
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return {};
  }
  std::string refusal = std::string(parameter.name) + " is " + describe_values(parameter) + ", not \"" +
                        std::string(value) + "\"";
  if (parameter.values != nullptr && parameter.values->reason != nullptr)
    refusal += ": " + parameter.values->reason(value);
  return refusal;
}

const Parameter* find_parameter(std::span<const Parameter> parameters, std::string_view name) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

std::string describe_unknown(std::string_view owner, std::span<const Parameter> parameters,
                             std::string_view name) {
  if (parameters.empty()) return std::string(owner) + " takes no parameters";
  return std::string(owner) + " has no parameter \"" + std::string(name) + "\" (there is " +
         listed(parameters, [](const Parameter& p) { return p.name; }) + ")";
}

std::string refuse_settings(std::string_view owner, std::span<const Parameter> parameters,
                            const Settings& settings) {
  for (const auto& [name, value] : settings) {
    const Parameter* parameter = find_parameter(parameters, name);
    if (parameter == nullptr) return describe_unknown(owner, parameters, name);
    if (std::string reason = refuse(*parameter, value); !reason.empty()) return reason;
  }
  return {};
}

Settings without_defaults(std::span<const Parameter> parameters, Settings settings) {
  for (const Parameter& parameter : parameters) {
    const auto found = settings.find(std::string(parameter.name));
    if (found != settings.end() && found->second == parameter.standard) settings.erase(found);
  }
  return settings;
}

std::uint64_t whole_number(const Settings& settings, const Parameter& parameter) {
  return *parse_whole_number(value_of(settings, parameter));
}

std::string choice(const Settings& settings, const Parameter& parameter) {
  return value_of(settings, parameter);
}

std::size_t choice_index(const Settings& settings, const Parameter& parameter) {
  const auto choices = parameter.choices();
  const auto found = std::find(choices.begin(), choices.end(), value_of(settings, parameter));
  return static_cast<std::size_t>(found - choices.begin());
}

}  // namespace tribunal
