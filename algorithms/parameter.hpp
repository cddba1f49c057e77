// Parameters of algorithms and experiments: variants of one thing under one name.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal {

/// What a parameter takes that is neither a whole number nor a name from a list.
struct Values {
  std::string_view describe;        ///< "a number from 0 to 60, 60 excluded"
  bool (*holds)(std::string_view);  ///< whether the text is such a value
  /// What is wrong with a text that is none, for values with a grammar; null: nothing to add.
  std::string (*reason)(std::string_view) = nullptr;
};

/// A whole number, one of a list of names, or a value of another kind. Users, plans and cells write its value
/// as text.
struct Parameter {
  std::string_view name;
  std::string_view summary;                              ///< one line
  std::string_view standard;                             ///< the default
  std::uint64_t least = 0, most = 0;                     ///< of a whole number
  std::vector<std::string_view> (*choices)() = nullptr;  ///< null: not from a list
  const Values* values = nullptr;                        ///< null, and no choices: a whole number
};

/// Values of parameters by name. What is left out has its default.
using Settings = std::map<std::string, std::string>;

/// "a whole number from 0 to 9", or "one of history, walk".
std::string describe_values(const Parameter& parameter);

/// Why `value` is no value of the parameter; empty when it is one.
std::string refuse(const Parameter& parameter, std::string_view value);

/// The parameter of that name, or null.
const Parameter* find_parameter(std::span<const Parameter> parameters, std::string_view name);

/// "bowyer has no parameter "a" (there is ...)": for a name that find_parameter does not find.
std::string describe_unknown(std::string_view owner, std::span<const Parameter> parameters,
                             std::string_view name);

/// Why `owner`, which has these parameters, does not take the settings, said of the first one in the way;
/// empty when it takes them all.
std::string refuse_settings(std::string_view owner, std::span<const Parameter> parameters,
                            const Settings& settings);

/// The settings that differ from their defaults: equal for all spellings of one variant.
Settings without_defaults(std::span<const Parameter> parameters, Settings settings);

/// The value of a parameter that is a whole number. The settings must have been accepted (refuse_settings).
std::uint64_t whole_number(const Settings& settings, const Parameter& parameter);

/// The value of any parameter, as it was written. The settings must have been accepted.
std::string value_of(const Settings& settings, const Parameter& parameter);

/// The finite number that the whole text is, in decimal notation; nothing where it is none.
std::optional<double> parse_number(std::string_view text);

/// The value of a parameter with choices, and its place among them. The settings must have been accepted.
std::string choice(const Settings& settings, const Parameter& parameter);
std::size_t choice_index(const Settings& settings, const Parameter& parameter);

/// choice_index as an enumeration whose enumerators stand in the order of the choices.
template <class Enumeration>
Enumeration choice_as(const Settings& settings, const Parameter& parameter) {
  return static_cast<Enumeration>(choice_index(settings, parameter));
}

}  // namespace tribunal
