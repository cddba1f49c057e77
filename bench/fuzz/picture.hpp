// A counterexample as a picture.
#pragma once

#include "bench/fuzz/hunt.hpp"
#include "bench/fuzz/subject.hpp"

#include <string>

namespace tribunal::bench::fuzz {

/// An SVG document. In the plane: the points, and the line or circle through all but the last. Beside it, in
/// space alone: what the subject answers where the last point is moved by up to 16 ulps along x and y, wrong
/// answers in strong colours. Same arguments, same bytes.
std::string picture_of(const Counterexample& counterexample, const Subject& subject);

}  // namespace tribunal::bench::fuzz
