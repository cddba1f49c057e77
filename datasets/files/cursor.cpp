#include "datasets/files/cursor.hpp"

#include "datasets/files/files.hpp"
#include "datasets/files/numerals.hpp"

#include <algorithm>
#include <cctype>

namespace tribunal::files {
namespace {
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool ends_token(char c) {
  return std::string_view(" \t\r\n\v\f,:;()[]{}#\"").find(c) != std::string_view::npos;
}
}  // namespace

Cursor::Cursor(std::string name, std::string_view text) : name_(std::move(name)), text_(text) {
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

void Cursor::skip_blanks() {
  for (; at_.position < text_.size(); ++at_.position) {
    if (text_[at_.position] == '#') at_.position = std::min(text_.find('\n', at_.position), text_.size());
    if (at_.position == text_.size()) return;
    const char c = text_[at_.position];
    if (std::isspace(static_cast<unsigned char>(c)) == 0) return;
    if (c != '\n') continue;
    ++at_.line;
    at_.line_begin = at_.position + 1;
  }
}

bool Cursor::at_end() {
  skip_blanks();
  return at_.position == text_.size();
}

char Cursor::peek() { return at_end() ? '\0' : text_[at_.position]; }

bool Cursor::take(char c) {
  const bool taken = !at_end() && text_[at_.position] == c;
  if (taken) ++at_.position;
  return taken;
}

void Cursor::expect(char c) {
  if (!take(c)) refuse("'" + std::string(1, c) + "' expected, found " + found());
}

std::string_view Cursor::word() {
  skip_blanks();
  const std::size_t begin = at_.position;
  while (at_.position < text_.size() &&
         (std::isalpha(static_cast<unsigned char>(text_[at_.position])) != 0 || text_[at_.position] == '_'))
    ++at_.position;
  return text_.substr(begin, at_.position - begin);
}

bool Cursor::number_follows() {
  const char c = peek();
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
}

std::string_view Cursor::bare() {
  skip_blanks();
  const std::size_t begin = at_.position;
  while (at_.position < text_.size() && !ends_token(text_[at_.position])) ++at_.position;
  return text_.substr(begin, at_.position - begin);
}

double Cursor::number(std::string_view what) {
  const Mark begin = mark();
  const std::string_view text = bare();
  std::string refusal;
  const double value = read_number(text, what, refusal);
  if (refusal.empty()) return value;
  return_to(begin);
  refuse(text.empty() ? std::string(what) + " is missing, found " + found() : refusal);
}

std::string_view Cursor::quoted() {
  expect('"');
  const std::size_t begin = at_.position;
  for (; at_.position < text_.size() && text_[at_.position] != '\n'; ++at_.position) {
    if (text_[at_.position] == '"') return text_.substr(begin, at_.position++ - begin);
    if (text_[at_.position] == '\\') ++at_.position;
  }
  at_.position = begin - 1;
  refuse("a string without end");
}

Scanner::Place Cursor::place() {
  skip_blanks();
  return {at_.line, at_.position - at_.line_begin + 1};
}

Cursor::Mark Cursor::mark() {
  skip_blanks();
  return at_;
}

void Cursor::refuse(std::string_view reason) { refuse_at(place(), reason); }

void Cursor::refuse_at(Scanner::Place where, std::string_view reason) const {
  throw BadInput(name_ + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) + ": " +
                 std::string(reason));
}

void Cursor::refuse_file(std::string_view reason) const {
  throw BadInput(name_ + ": " + std::string(reason));
}

std::string Cursor::found() {
  if (at_end()) return "the end of the file";
  std::size_t end = at_.position + 1;
  while (end < text_.size() && !ends_token(text_[end])) ++end;
  return in_quotes(text_.substr(at_.position, end - at_.position));
}

}  // namespace tribunal::files
