#include "datasets/files/scanner.hpp"

#include "datasets/files/files.hpp"
#include "datasets/files/numerals.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace tribunal {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_blank(char c) { return blanks.find(c) != std::string_view::npos; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return text;
}

/// Where the field that begins at `cursor` ends: before its comma, or with the line. Between quotation marks
/// commas do not count.
std::size_t end_of_field(std::string_view line, std::size_t cursor) {
  bool quoted = false;
  for (; cursor < line.size() && (quoted || line[cursor] != ','); ++cursor)
    if (line[cursor] == '"') quoted = !quoted;
  return cursor;
}

std::string_view without_quotes(std::string_view field) {
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return field;
  return trimmed(field.substr(1, field.size() - 2));
}

}  // namespace

std::string in_quotes(std::string_view field) {
  constexpr std::size_t longest = 24;
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "\"";
  for (const char c : field.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F)
      text += c;
    else
      text.append("\\x").append(1, digits[byte >> 4]).append(1, digits[byte & 15]);
  }
  return text + (field.size() > longest ? "...\"" : "\"");
}

Scanner::Scanner(std::string name, std::string_view text, Separator separator)
    : name_(std::move(name)), text_(text), separator_(separator) {
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

bool Scanner::next_line() {
  while (next_ < text_.size()) {
    begin_ = next_;
    const std::size_t end = std::min(text_.find('\n', begin_), text_.size());
    current_ = text_.substr(begin_, end - begin_);
    current_ = current_.substr(0, current_.find('#'));
    next_ = std::min(end + 1, text_.size());
    ++line_number_;
    cursor_ = 0;
    if (current_.find_first_not_of(blanks) != std::string_view::npos) return true;
  }
  return false;
}

void Scanner::unread_line() {
  next_ = begin_;
  --line_number_;
}

bool Scanner::at_end_of_line() {
  if (separator_ == Separator::comma) return cursor_ > current_.size();
  while (cursor_ < current_.size() && is_blank(current_[cursor_])) ++cursor_;
  return cursor_ == current_.size();
}

std::string_view Scanner::field(std::string_view what) {
  const bool missing = at_end_of_line();
  taken_ = std::min(cursor_, current_.size());
  if (missing) refuse(std::string(what) + " is missing");
  if (separator_ == Separator::comma) {
    const std::size_t end = end_of_field(current_, cursor_);
    const auto taken = trimmed(current_.substr(cursor_, end - cursor_));
    if (!taken.empty()) taken_ = static_cast<std::size_t>(taken.data() - current_.data());
    cursor_ = end + 1;
    return without_quotes(taken);
  }
  while (cursor_ < current_.size() && !is_blank(current_[cursor_])) ++cursor_;
  return current_.substr(taken_, cursor_ - taken_);
}

double Scanner::number(std::string_view what) {
  std::string refusal;
  const double value = files::read_number(field(what), what, refusal);
  if (!refusal.empty()) refuse(refusal);
  return value;
}

template <class Integer>
Integer Scanner::whole(std::string_view what, std::string_view kind) {
  const std::string_view text = field(what);
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
  refuse(std::string(what) + " is " + in_quotes(text) + ", not " + std::string(kind));
}

std::uint64_t Scanner::count(std::string_view what) { return whole<std::uint64_t>(what, "a count"); }

std::int64_t Scanner::integer(std::string_view what) { return whole<std::int64_t>(what, "an integer"); }

void Scanner::expect_end_of_line() {
  if (at_end_of_line()) return;
  const Place where = place();
  refuse_at(where, in_quotes(field("")) + " follows the last column");
}

Scanner::Place Scanner::place() {
  (void)at_end_of_line();
  return {line_number_, std::min(cursor_, current_.size()) + 1};
}

void Scanner::refuse(std::string_view reason) const { refuse_at({line_number_, taken_ + 1}, reason); }

void Scanner::refuse_at(Place where, std::string_view reason) const {
  throw BadInput(name_ + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) + ": " +
                 std::string(reason));
}

void Scanner::refuse_line(std::uint64_t line, std::string_view reason) const {
  throw BadInput(name_ + ":" + std::to_string(line) + ": " + std::string(reason));
}

void Scanner::refuse_file(std::string_view reason) const {
  throw BadInput(name_ + ": " + std::string(reason));
}

}  // namespace tribunal
