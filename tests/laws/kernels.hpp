// Kernels of either dimension under one name, so that a law is written once.
#pragma once

#include "predicates/backends/list.hpp"
#include "tests/laws/families.hpp"
#include "tests/laws/oracle.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace tribunal {
inline void PrintTo(Sign s, std::ostream* out) { *out << to_char(s); }
inline void PrintTo(Stage s, std::ostream* out) { *out << to_string(s); }
}  // namespace tribunal

namespace tribunal::laws {

template <int D>
using Kernel = std::conditional_t<D == 2, Kernel2, Kernel3>;

/// The backend's kernel over the points; null where it has none of this dimension or refuses them.
template <int D>
std::unique_ptr<const Kernel<D>> bind(const BackendEntry& entry, const std::vector<Point<D>>& points) {
  auto binding = [&] {
    if constexpr (D == 2)
      return entry.bind2(points);
    else
      return entry.bind3 ? entry.bind3(points) : Kernel3Binding(Refusal{0, "no spatial predicates"});
  }();
  if (std::holds_alternative<Refusal>(binding)) return nullptr;
  return std::get<0>(std::move(binding));
}

inline Decision decide_orient(const Kernel2& k, const Case<2>& p) {
  return k.decide_orient2d(p[0], p[1], p[2]);
}
inline Decision decide_orient(const Kernel3& k, const Case<3>& p) {
  return k.decide_orient3d(p[0], p[1], p[2], p[3]);
}
inline Decision decide_in_sphere(const Kernel2& k, const Case<2>& p) {
  return k.decide_incircle(p[0], p[1], p[2], p[3]);
}
inline Decision decide_in_sphere(const Kernel3& k, const Case<3>& p) {
  return k.decide_insphere(p[0], p[1], p[2], p[3], p[4]);
}
inline Sign orient(const auto& kernel, const auto& points) { return decide_orient(kernel, points).sign; }
inline Sign in_sphere(const auto& kernel, const auto& points) {
  return decide_in_sphere(kernel, points).sign;
}

template <int D>
Sign true_orient(const Case<D>& points) {
  return oracle::orient<D>(std::span(points).template first<D + 1>());
}
template <int D>
Sign true_in_sphere(const Case<D>& points) {
  return oracle::in_sphere<D>(std::span(points));
}

/// Coordinates in hexadecimal, ready to be pasted.
template <int D>
std::string hexadecimal(const Case<D>& points) {
  std::ostringstream text;
  text << std::hexfloat;
  for (const auto& p : points) {
    text << (&p == &points[0] ? "{" : ", {");
    for (int axis = 0; axis < D; ++axis) text << (axis == 0 ? "" : ", ") << p[axis];
    text << "}";
  }
  return text.str();
}

/// One test per backend of the list, named after it.
class EveryBackend : public testing::TestWithParam<const BackendEntry*> {
 protected:
  const BackendEntry& entry() const { return *GetParam(); }
  bool exact() const { return entry().about->exact; }
};

inline std::vector<const BackendEntry*> listed_backends() {
  std::vector<const BackendEntry*> all;
  for (const BackendEntry& entry : backends()) all.push_back(&entry);
  return all;
}

inline std::string name_of(const testing::TestParamInfo<const BackendEntry*>& info) {
  std::string name(info.param->about->name);
  for (char& c : name)
    if (c == '-' || c == '+') c = '_';
  return name;
}

}  // namespace tribunal::laws

#define TRIBUNAL_FOR_EVERY_BACKEND(suite)                                                   \
  INSTANTIATE_TEST_SUITE_P(, suite, testing::ValuesIn(::tribunal::laws::listed_backends()), \
                           ::tribunal::laws::name_of)
