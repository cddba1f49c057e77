// A text whose lines mean nothing (JSON, WKT): characters, words and numbers, with refusals that name the
// place.
#pragma once

#include "datasets/files/scanner.hpp"

#include <string>
#include <string_view>

namespace tribunal::files {

/// Walks through a text token by token; blanks, line ends and comments from '#' on between tokens are
/// skipped, and a UTF-8 byte order mark at the beginning. The text must outlive the cursor.
class Cursor {
 public:
  Cursor(std::string name, std::string_view text);

  bool at_end();
  /// The next character, '\0' at the end.
  char peek();
  /// Takes `c` if it comes next.
  bool take(char c);
  /// Takes `c` or refuses, saying what stands there instead.
  void expect(char c);
  /// Takes letters and '_'; may be empty.
  std::string_view word();
  /// Takes all up to the next blank, comma, colon, bracket or comment; may be empty.
  std::string_view bare();
  /// Takes a finite number; `what` names it in refusals.
  double number(std::string_view what);
  /// Whether a number seems to come next: a digit, a sign or a point.
  bool number_follows();
  /// Takes a JSON string and returns what stands between its quotation marks, escapes as they are.
  std::string_view quoted();

  Scanner::Place place();
  /// Goes back to a place where the cursor has been.
  struct Mark {
    std::size_t position, line_begin;
    std::uint64_t line;
  };
  Mark mark();
  void return_to(const Mark& mark) { at_ = mark; }

  /// Throws BadInput at the next token, at a place, or about the file as a whole.
  [[noreturn]] void refuse(std::string_view reason);
  [[noreturn]] void refuse_at(Scanner::Place where, std::string_view reason) const;
  [[noreturn]] void refuse_file(std::string_view reason) const;

 private:
  void skip_blanks();
  std::string found();

  std::string name_;
  std::string_view text_;
  Mark at_{0, 0, 1};
};

}  // namespace tribunal::files
