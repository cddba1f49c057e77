// The backends as types, in the order in which they are listed to users. A line here and an entry in the pack
// are all that a backend takes.
#pragma once

#include "predicates/backends/adaptive.hpp"
#include "predicates/backends/double.hpp"
#include "predicates/backends/double_fma.hpp"
#include "predicates/backends/filtered.hpp"
#include "predicates/backends/fixed.hpp"
#include "predicates/backends/float.hpp"
#include "predicates/backends/fortune_van_wyk.hpp"
#include "predicates/backends/gmp.hpp"
#include "predicates/backends/interval.hpp"
#include "predicates/backends/knuth.hpp"
#include "predicates/backends/knuth64.hpp"
#include "predicates/backends/knuth_as_printed.hpp"
#include "predicates/backends/long_double.hpp"
#include "predicates/backends/redundant.hpp"

namespace tribunal {

/// Types to be expanded into one thing per backend: entries of a table, loops of a benchmark.
template <class... B>
struct BackendTypes {};

using AllBackends =
    BackendTypes<Double, DoubleFma, Float, LongDouble, Knuth, Knuth64, Redundant, KnuthAsPrinted,
                 FortuneVanWyk, IntervalArithmetic, Adaptive, Filtered, Fixed, Gmp>;

}  // namespace tribunal
