#include "predicates/batch/lanes.hpp"

#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"

#include <cstring>

// Defined by the build for each instruction set.
#ifndef TRIBUNAL_INSTRUCTIONS
#define TRIBUNAL_INSTRUCTIONS baseline
#define TRIBUNAL_VECTOR_BYTES 16
#endif

namespace tribunal::TRIBUNAL_INSTRUCTIONS {
namespace {

constexpr std::size_t lane_count = TRIBUNAL_VECTOR_BYTES / sizeof(double);

/// One coordinate of as many queries as a register holds.
struct Lanes {
  using Vector __attribute__((vector_size(TRIBUNAL_VECTOR_BYTES))) = double;
  Vector vector;

  friend Lanes operator+(Lanes a, Lanes b) { return {a.vector + b.vector}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.vector - b.vector}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.vector * b.vector}; }
};

Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof(lanes));
  return lanes;
}

template <class Formula>
std::size_t filter(const double* const* columns, double threshold, std::int8_t* signs, std::size_t count) {
  using Mask __attribute__((vector_size(TRIBUNAL_VECTOR_BYTES))) = std::int64_t;
  using Bytes __attribute__((vector_size(lane_count))) = std::int8_t;
  const Lanes::Vector upper = threshold - Lanes::Vector{}, lower = -upper;
  std::size_t i = 0;
  for (; i + lane_count <= count; i += lane_count) {
    Lanes arguments[Formula::points][Formula::dimension];
    for (int k = 0; k < Formula::points; ++k)
      for (int axis = 0; axis < Formula::dimension; ++axis)
        arguments[k][axis] = load(columns[k * Formula::dimension + axis] + i);
    const Lanes::Vector determinant = Formula::determinant(arguments).vector;
    // A comparison gives -1 where it holds; NaN compares as undecided.
    const Mask sign = (determinant < lower) - (determinant > upper);
    const Bytes bytes = __builtin_convertvector(sign, Bytes);
    std::memcpy(signs + i, &bytes, lane_count);
  }
  return i;
}

}  // namespace

const LaneFilters lane_filters{&filter<Orient<2>>, &filter<InSphere<2>>, &filter<Orient<3>>,
                               &filter<InSphere<3>>};

}  // namespace tribunal::TRIBUNAL_INSTRUCTIONS
