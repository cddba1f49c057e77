// Lists whose length a header announces and whose items may be numbered: what .node, .ele and .off share.
#pragma once

#include "datasets/files/scanner.hpp"

#include <algorithm>
#include <string>

namespace tribunal::files {

/// A count from a header, with the line it stands in. It is believed only as far as the text goes, so that a
/// header cannot make the reader allocate what is not there.
class Announced {
 public:
  Announced(Scanner& scanner, std::string_view items)
      : items_(items), count_(scanner.count("the number of " + items_)), line_(scanner.line()) {}

  std::uint64_t count() const { return count_; }

  /// How many items to make room for when each takes a line of at least `fields` fields.
  std::uint64_t plausible(const Scanner& scanner, std::uint64_t fields) const {
    return std::min(count_, scanner.lines_left(fields));
  }

  /// Goes to the line of item `i`, or refuses because there is none.
  void next_line(Scanner& scanner, std::uint64_t i) const {
    if (!scanner.next_line())
      scanner.refuse_line(
          line_, std::to_string(count_) + " " + items_ + " announced, " + std::to_string(i) + " found");
  }

  /// Refuses when there is another line after the last item.
  void expect_end(Scanner& scanner) const {
    if (scanner.next_line())
      scanner.refuse_line(scanner.line(), "more than the " + std::to_string(count_) + " " + items_ +
                                              " announced in line " + std::to_string(line_));
  }

 private:
  std::string items_;
  std::uint64_t count_;
  std::uint64_t line_;
};

/// Takes the number in front of item `i`: the first is `base`, 0 or 1, which it sets; the others count on
/// from it.
inline void take_number(Scanner& scanner, std::uint64_t i, std::uint64_t& base) {
  const std::uint64_t number = scanner.count("the item's number");
  if (i == 0 && number > 1)
    scanner.refuse("items are numbered from 0 or 1, not from " + std::to_string(number));
  if (i == 0) base = number;
  if (number != base + i)
    scanner.refuse("number " + std::to_string(number) + " where " + std::to_string(base + i) + " is next");
}

/// Takes a vertex index counted from `base` and returns it counted from 0; it must be below `sites`.
inline std::uint32_t take_vertex(Scanner& scanner, std::uint64_t base, std::uint64_t sites) {
  const std::int64_t index = scanner.integer("a vertex");
  const auto first = static_cast<std::int64_t>(base);
  if (index >= first && static_cast<std::uint64_t>(index - first) < sites)
    return static_cast<std::uint32_t>(index - first);
  if (sites == 0) scanner.refuse("vertex " + std::to_string(index) + " of a mesh without points");
  scanner.refuse("vertex " + std::to_string(index) + " is outside " + std::to_string(base) + ".." +
                 std::to_string(base + sites - 1));
}

}  // namespace tribunal::files
