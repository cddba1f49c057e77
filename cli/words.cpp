#include "cli/words.hpp"

#include "cli/console.hpp"
#include "cli/numbers.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace tribunal::cli {
namespace {

/// True for what a user means as a number, good or bad: "-1", "-.5", "+3", "-0x1p3", "-Inf", "NaN", "1e".
bool looks_like_number(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  word.erase(0, std::min(word.find_first_not_of("+-"), word.size()));
  if (word.empty()) return false;
  return std::isdigit(static_cast<unsigned char>(word[0])) || word[0] == '.' || word == "inf" ||
         word == "infinity" || word == "nan";
}

}  // namespace

std::vector<std::string> take_numbers(std::vector<std::string>& words) {
  std::vector<std::string> numbers, rest;
  if (words.empty() || words[0] != "sign") return numbers;
  for (const std::string& word : words) (looks_like_number(word) ? numbers : rest).push_back(word);
  words = rest;
  return numbers;
}

std::string check_whole_number(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool leading_zero = text.size() > 1 && text[0] == '0';
  if (error != std::errc{} || end != text.data() + text.size() || leading_zero)
    return "'" + text + "' is no whole number from 0 to 2^64 - 1";
  return {};
}

std::string check_seconds(const std::string& text) {
  constexpr double three_years = 1e8;
  try {
    const double seconds = parse_number(text);
    if (seconds > 0 && seconds <= three_years) return {};
  } catch (const BadUsage&) {  // the library names the option, and the sentence below says it all
  }
  return "'" + text + "' is no number of seconds above 0 and up to 1e8";
}

std::string check_not_empty(const std::string& text) { return text.empty() ? "must not be empty" : ""; }

}  // namespace tribunal::cli
