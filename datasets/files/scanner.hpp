// A text file as lines of fields, with refusals that name the place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tribunal {

/// Walks through a text line by line and field by field. A '#' starts a comment that ends with the line;
/// lines without fields are skipped; "\r\n" ends a line like "\n", and the last line needs no end. A UTF-8
/// byte order mark is skipped. Numbers are read the same in every locale. The text must outlive the scanner.
class Scanner {
 public:
  /// What stands between two fields: blanks, or one comma with any blanks around it (then fields may be
  /// empty, or in quotation marks, which are no part of them).
  enum class Separator : std::uint8_t { blanks, comma };

  /// Where a field begins: both from 1, columns in bytes.
  struct Place {
    std::uint64_t line, column;
  };

  Scanner(std::string name, std::string_view text, Separator separator = Separator::blanks);

  /// Goes to the next line that has fields; false when there is none.
  bool next_line();

  /// 1-based number of the current line.
  std::uint64_t line() const { return line_number_; }

  /// Whether all fields of the current line are taken.
  bool at_end_of_line();

  /// Puts the current line back: next_line() gives it again.
  void unread_line();

  /// Takes the next field; `what` names it when it is missing.
  std::string_view field(std::string_view what);

  /// Takes a finite double: decimal, or hexadecimal with 0x. Correctly rounded; beyond the range of double is
  /// refused.
  double number(std::string_view what);

  /// Takes a non-negative integer.
  std::uint64_t count(std::string_view what);

  /// Takes an integer.
  std::int64_t integer(std::string_view what);

  /// Refuses when fields are left on the line.
  void expect_end_of_line();

  /// The place of the next field of this line.
  Place place();

  /// Throws BadInput at the field taken last, at a place, about a line, or about the file as a whole.
  [[noreturn]] void refuse(std::string_view reason) const;
  [[noreturn]] void refuse_at(Place where, std::string_view reason) const;
  [[noreturn]] void refuse_line(std::uint64_t line, std::string_view reason) const;
  [[noreturn]] void refuse_file(std::string_view reason) const;

  /// Upper bound on the number of lines with at least `fields` fields that are still to come; what an
  /// announced count may be believed to.
  std::uint64_t lines_left(std::uint64_t fields) const { return (text_.size() - next_) / (2 * fields) + 1; }

 private:
  template <class Integer>
  Integer whole(std::string_view what, std::string_view kind);

  std::string name_;
  std::string_view text_;
  std::string_view current_;  ///< current line without comment and line end
  std::size_t begin_ = 0;     ///< where the current line begins in text_
  std::size_t next_ = 0;      ///< where the next line begins in text_
  std::size_t cursor_ = 0;    ///< where the next field begins in current_, or blanks before it
  std::size_t taken_ = 0;     ///< where the field taken last begins in current_
  std::uint64_t line_number_ = 0;
  Separator separator_;
};

/// A field as it may stand in a message: quoted, what is not printable escaped, long ones cut.
std::string in_quotes(std::string_view field);

}  // namespace tribunal
