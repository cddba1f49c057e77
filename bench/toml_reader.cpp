#include "bench/toml_reader.hpp"

#include "datasets/files/files.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <sstream>

namespace tribunal::bench {
namespace {

std::string in_quotes(std::string_view text) { return std::string("\"").append(text).append("\""); }

std::string type_name(const toml::node& node) {
  std::ostringstream name;
  name << node.type();
  return name.str();
}

std::optional<std::uint64_t> parse_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (number > std::numeric_limits<std::int64_t>::max()) return std::nullopt;  // as TOML's own integers
  return number;
}

std::string shortest(double number) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr};
}

}  // namespace

void TomlReader::fail(const toml::source_region& where, const std::string& reason) const {
  std::ostringstream line;
  line << filename_ << ':' << where.begin.line << ':' << where.begin.column << ": " << reason;
  throw BadInput(line.str());
}

void TomlReader::allow_only(const toml::table& table, std::vector<std::string_view> known) const {
  for (const auto& [key, value] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    std::string listed;
    for (const std::string_view name : known) listed += (listed.empty() ? "" : ", ") + std::string(name);
    fail(key.source(), "unknown key " + in_quotes(key.str()) + " (known here: " + listed + ")");
  }
}

std::vector<const toml::node*> TomlReader::values(const toml::node& node) const {
  const toml::array* array = node.as_array();
  if (array == nullptr) return {&node};
  if (array->empty()) fail(node, "an empty list leaves no cells");
  std::vector<const toml::node*> elements;
  for (const toml::node& element : *array) elements.push_back(&element);
  return elements;
}

const toml::table& TomlReader::table(const toml::node& node, std::string_view name) const {
  const toml::table* table = node.as_table();
  if (table == nullptr) fail(node, std::string(name) + " is a table, not " + type_name(node));
  return *table;
}

std::string TomlReader::text(const toml::node& node, std::string_view name) const {
  const auto* text = node.as_string();
  if (text == nullptr) fail(node, std::string(name) + " is a string, not " + type_name(node));
  return text->get();
}

std::uint64_t TomlReader::whole(const toml::node& node, std::string_view name, std::uint64_t least,
                                std::uint64_t most) const {
  const auto* integer = node.as_integer();
  if (integer == nullptr) fail(node, std::string(name) + " is a whole number, not " + type_name(node));
  const std::int64_t value = integer->get();
  if (value < 0 || static_cast<std::uint64_t>(value) < least || static_cast<std::uint64_t>(value) > most)
    fail(node, std::string(name) + " is a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most) + ", not " + std::to_string(value));
  return static_cast<std::uint64_t>(value);
}

double TomlReader::number(const toml::node& node, std::string_view name, double least, double most) const {
  if (!node.is_number()) fail(node, std::string(name) + " is a number, not " + type_name(node));
  const double value = *node.value<double>();
  if (!(value >= least && value <= most))
    fail(node, std::string(name) + " is a number from " + shortest(least) + " to " + shortest(most) +
                   ", not " + shortest(value));
  return value;
}

std::vector<std::uint64_t> TomlReader::range(const toml::node& node, std::string_view name,
                                             std::uint64_t most) const {
  if (!node.is_string()) return {whole(node, name, 0, std::numeric_limits<std::int64_t>::max())};
  const std::string written = node.as_string()->get();
  const std::size_t dots = written.find("..");
  if (dots == std::string::npos)
    fail(node, std::string(name) + ": " + in_quotes(written) + " is no range \"first..last\"");
  const auto first = parse_number(std::string_view(written).substr(0, dots));
  const auto last = parse_number(std::string_view(written).substr(dots + 2));
  if (!first || !last || *first > *last)
    fail(node, std::string(name) + ": " + in_quotes(written) + " is no range \"first..last\"");
  if (*last - *first >= most)
    fail(node, std::string(name) + ": " + in_quotes(written) + " holds more than " + std::to_string(most) +
                   " values");
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t i = *first; numbers.size() <= *last - *first; ++i) numbers.push_back(i);
  return numbers;
}

}  // namespace tribunal::bench
