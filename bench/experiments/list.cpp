#include "bench/experiments/listed.hpp"
#include "datasets/files/files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace tribunal::bench {
namespace {

std::optional<std::uint64_t> parse_whole_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string value_of(const Cell& cell, const Parameter& parameter) {
  const auto found = cell.parameters.find(std::string(parameter.name));
  std::string value = found == cell.parameters.end() ? std::string(parameter.standard) : found->second;
  if (const std::string reason = refuse(parameter, value); !reason.empty()) throw BadInput(reason);
  return value;
}

}  // namespace

std::span<const Experiment> experiments() {
  static const std::array all{
#define EXPERIMENT(name) name##_experiment,
#include "bench/experiments/list.def"
#undef EXPERIMENT
  };
  return all;
}

const Experiment* find_experiment(std::string_view name) {
  const auto all = experiments();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Experiment& e) { return e.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string refuse(const Parameter& parameter, std::string_view value) {
  const std::string name(parameter.name);
  if (parameter.choices == nullptr) {
    const auto number = parse_whole_number(value);
    if (number && *number >= parameter.least && *number <= parameter.most) return {};
    return name + " is a whole number from " + std::to_string(parameter.least) + " to " +
           std::to_string(parameter.most) + ", not \"" + std::string(value) + "\"";
  }
  std::string listed;
  for (const std::string_view choice : parameter.choices()) {
    if (choice == value) return {};
    listed += (listed.empty() ? "" : ", ") + std::string(choice);
  }
  return name + " is one of " + listed + ", not \"" + std::string(value) + "\"";
}

std::uint64_t whole_number(const Cell& cell, const Parameter& parameter) {
  return *parse_whole_number(value_of(cell, parameter));
}

std::string choice(const Cell& cell, const Parameter& parameter) { return value_of(cell, parameter); }

}  // namespace tribunal::bench
