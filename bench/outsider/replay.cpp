#include "bench/outsider/replay.hpp"

#include "bench/fuzz/hex_float.hpp"
#include "datasets/files/numerals.hpp"

#include <algorithm>
#include <cctype>

namespace tribunal::bench {
namespace {

bool is_plain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("_./-+=:,").find(c) != std::string_view::npos;
}

}  // namespace

std::string shell_word(std::string_view text) {
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return std::string(text);
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'')
      word += "'\\''";
    else
      word += c;
  }
  return word + "'";
}

std::string replay_query(const std::string& outsider, const fuzz::Case& asked) {
  std::string query(to_string(asked.predicate));
  for (const double number : asked.numbers()) query += ' ' + fuzz::hex_float(number);
  return "tribunal try " + outsider + " --query " + shell_word(query);
}

std::string replay_points(const std::string& outsider, std::span<const Point2> points) {
  std::string text;
  for (const Point2& p : points) {
    files::append_number(text, p[0]);
    text += ' ';
    files::append_number(text, p[1]);
    text += "\\n";
  }
  return "printf '" + text + "' | tribunal try " + outsider + " --points -";
}

std::string replay_dataset(const std::string& outsider, std::string_view dataset, std::uint64_t n,
                           std::uint64_t seed) {
  return "tribunal try " + outsider + " --dataset " + std::string(dataset) + " -n " + std::to_string(n) +
         " --seed " + std::to_string(seed);
}

}  // namespace tribunal::bench
