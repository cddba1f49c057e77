// Many queries at once: the filter in vector instructions, and the backend itself for what it leaves open.
#pragma once

#include "predicates/backends/filtered.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/sign.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace tribunal {

/// Points as one array for each axis (a structure of arrays).
template <int D>
using Columns = std::array<const double*, D>;

/// The operands of a formula: operand[k][axis][i] is a coordinate of the k-th point of query i.
template <class Formula>
using ColumnArguments = std::array<Columns<Formula::dimension>, Formula::points>;

/// signs[i] = kernel.decide<Formula>(query i).sign for every i < signs.size(). Each column holds that many
/// coordinates, of points that the kernel admits. The widest vector instructions of the processor (SSE2, AVX2
/// or AVX-512; on other machines what the compiler takes for granted) evaluate the threshold of the kernel's
/// box, in the same operations as the scalar code: the signs agree bit for bit. Thread-safe; what the
/// threshold leaves open is decided one by one as `kernel` does, which allocates in its exact stage alone.
///
/// Defined for Orient<2>, InSphere<2>, Orient<3> and InSphere<3>.
template <class Formula>
void decide_batch(const Filtered& kernel, const ColumnArguments<Formula>& operands, std::span<Sign> signs);

/// "avx512", "avx2" or "baseline": what decide_batch uses on this processor.
std::string_view batch_instructions();

extern template void decide_batch<Orient<2>>(const Filtered&, const ColumnArguments<Orient<2>>&,
                                             std::span<Sign>);
extern template void decide_batch<InSphere<2>>(const Filtered&, const ColumnArguments<InSphere<2>>&,
                                               std::span<Sign>);
extern template void decide_batch<Orient<3>>(const Filtered&, const ColumnArguments<Orient<3>>&,
                                             std::span<Sign>);
extern template void decide_batch<InSphere<3>>(const Filtered&, const ColumnArguments<InSphere<3>>&,
                                               std::span<Sign>);

}  // namespace tribunal
