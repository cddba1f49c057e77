#include "predicates/batch/batch.hpp"

#include "predicates/batch/lanes.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <cstring>

namespace tribunal {
namespace {

struct InstructionSet {
  std::string_view name;
  const LaneFilters& filters;
};

InstructionSet widest_instructions() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    return {"avx512", avx512::lane_filters};
  if (__builtin_cpu_supports("avx2")) return {"avx2", avx2::lane_filters};
#endif
  return {"baseline", baseline::lane_filters};
}

template <class Formula>
LaneFilters::Filter filter_of(const LaneFilters& filters) {
  if constexpr (std::same_as<Formula, Orient<2>>) return filters.orient2d;
  if constexpr (std::same_as<Formula, InSphere<2>>) return filters.incircle;
  if constexpr (std::same_as<Formula, Orient<3>>) return filters.orient3d;
  if constexpr (std::same_as<Formula, InSphere<3>>) return filters.insphere;
}

template <class Formula>
Sign decide_one(const Filtered& kernel, const ColumnArguments<Formula>& operands, std::size_t i) {
  Query<Formula> query;
  for (int k = 0; k < Formula::points; ++k)
    for (int axis = 0; axis < Formula::dimension; ++axis) query[k][axis] = operands[k][axis][i];
  return kernel.decide<Formula>(query).sign;
}

}  // namespace

std::string_view batch_instructions() { return widest_instructions().name; }

template <class Formula>
void decide_batch(const Filtered& kernel, const ColumnArguments<Formula>& operands, std::span<Sign> signs) {
  std::array<const double*, std::size_t{Formula::points} * Formula::dimension> columns;
  for (int k = 0; k < Formula::points; ++k)
    std::copy(operands[k].begin(), operands[k].end(), columns.begin() + k * Formula::dimension);
  const auto filter = filter_of<Formula>(widest_instructions().filters);
  // Sign is an enumeration over int8_t: the filter writes its values, and a zero byte is an open query.
  auto* const bytes = reinterpret_cast<std::int8_t*>(signs.data());
  const std::size_t filtered = filter(columns.data(), kernel.threshold<Formula>(), bytes, signs.size());
  for (std::size_t i = 0; i < filtered; ++i) {
    const void* open = std::memchr(bytes + i, 0, filtered - i);
    if (open == nullptr) break;
    i = static_cast<std::size_t>(static_cast<const std::int8_t*>(open) - bytes);
    signs[i] = decide_one<Formula>(kernel, operands, i);
  }
  for (std::size_t i = filtered; i < signs.size(); ++i) signs[i] = decide_one<Formula>(kernel, operands, i);
}

template void decide_batch<Orient<2>>(const Filtered&, const ColumnArguments<Orient<2>>&, std::span<Sign>);
template void decide_batch<InSphere<2>>(const Filtered&, const ColumnArguments<InSphere<2>>&,
                                        std::span<Sign>);
template void decide_batch<Orient<3>>(const Filtered&, const ColumnArguments<Orient<3>>&, std::span<Sign>);
template void decide_batch<InSphere<3>>(const Filtered&, const ColumnArguments<InSphere<3>>&,
                                        std::span<Sign>);

}  // namespace tribunal
