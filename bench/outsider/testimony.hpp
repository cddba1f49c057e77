// What a plug-in's predicates say, taken down in a child that may die of it.
#pragma once

#include "bench/fuzz/case.hpp"
#include "bench/outsider/witness.hpp"
#include "bench/sandbox.hpp"
#include "predicates/sign.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tribunal::bench {

/// Queries of one predicate with their true signs, found where no outsider's code has run.
struct Examination {
  std::vector<fuzz::Case> cases;
  std::vector<Sign> exact;
};
Examination examine(std::vector<fuzz::Case> cases);

/// What came of asking them.
struct Testimony {
  std::string refusal;      ///< why the points were refused; empty: they were not
  std::string breach;       ///< which rule of the interface was broken beside the signs; empty: none
  std::uint64_t wrong = 0;  ///< signs
  std::uint64_t first = 0;  ///< the first wrong one
  int got = 0;              ///< the sign given there
  double seconds = 0;       ///< per query, where none is wrong
};

/// How the child ended, with its testimony or with the query it died in.
struct Hearing {
  Ending ending;
  bool interrupted = false;            ///< by `wake`: there is no more to say
  std::optional<Testimony> testimony;  ///< there where the ending is ok
  std::string place;                   ///< else: "in bind", "in query 17", ...
  std::optional<std::uint64_t> query;  ///< and the query, where it was one
};

/// Loads the plug-in in a child, binds it to the points of all the cases, asks and compares; where all signs
/// are right it asks again for the time. Ends when `wake` (a descriptor, or -1) is readable.
Hearing hear(const std::string& path, const Examination& examination, const Limits& limits, int wake);

/// A wrong sign.
struct WrongSign {
  fuzz::Case asked;
  Sign exact, got;
  std::string picture;  ///< an SVG document; empty: none was drawn
};

/// A simpler case about which the plug-in, bound to its points alone, is wrong as well. Nothing when it is
/// not wrong about `asked` when bound to that alone, or when the search was the end of it or ended by `wake`.
std::optional<WrongSign> simplify(const std::string& path, const fuzz::Case& asked, const Limits& limits,
                                  int wake);

}  // namespace tribunal::bench
