// Integer configurations that are, or nearly are, degenerate: where generated cases begin.
#pragma once

#include "bench/fuzz/case.hpp"
#include "datasets/random.hpp"

#include <span>
#include <string_view>

namespace tribunal::bench::fuzz {

/// One way to draw points with integer coordinates in [-2^(bits-1), 2^(bits-1)), 4 <= bits <= 53.
struct Shape {
  std::string_view name;
  std::string_view summary;  ///< one line: what is drawn
  void (*draw)(Random&, int bits, Case&);
};

/// All shapes. A function in shapes.cpp and a line of its list are all that a shape takes.
std::span<const Shape> shapes();

}  // namespace tribunal::bench::fuzz
