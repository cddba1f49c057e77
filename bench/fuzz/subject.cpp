#include "bench/fuzz/subject.hpp"

#include "bench/fuzz/points_of.hpp"

#include <cassert>
#include <utility>

namespace tribunal::bench::fuzz {
namespace {

template <int D>
bool all_admitted(const auto& kernel, const Case& asked) {
  for (int i = 0; i < asked.points(); ++i)
    if (!kernel.admits(point_of<D>(asked, i))) return false;
  return true;
}

}  // namespace

Subject subject_of(const BackendEntry& entry) {
  return {
      .name = std::string(entry.about->name),
      .exact = entry.about->exact,
      .bind2 = entry.bind2,
      .bind3 = entry.bind3,
      .offers = [spatial = entry.bind3 != nullptr](Predicate p) { return spatial || dimension_of(p) == 2; }};
}

Decision BoundSubject::decide(const Case& asked) const {
  const auto p2 = [&](int i) { return point_of<2>(asked, i); };
  const auto p3 = [&](int i) { return point_of<3>(asked, i); };
  switch (asked.predicate) {
    case Predicate::orient2d:
      return kernel2_->decide_orient2d(p2(0), p2(1), p2(2));
    case Predicate::incircle:
      return kernel2_->decide_incircle(p2(0), p2(1), p2(2), p2(3));
    case Predicate::orient3d:
      return kernel3_->decide_orient3d(p3(0), p3(1), p3(2), p3(3));
    case Predicate::insphere:
      break;
  }
  return kernel3_->decide_insphere(p3(0), p3(1), p3(2), p3(3), p3(4));
}

bool BoundSubject::admits(const Case& asked) const {
  return kernel2_ ? all_admitted<2>(*kernel2_, asked) : all_admitted<3>(*kernel3_, asked);
}

Binding<BoundSubject> bind_subject(const Subject& subject, std::span<const Case> cases) {
  assert(!cases.empty());
  const Predicate predicate = cases.front().predicate;
  if (!subject.offers(predicate)) return Refusal{0, "it has no " + std::string(to_string(predicate))};
  BoundSubject bound;
  if (dimension_of(predicate) == 2) {
    auto binding = subject.bind2(points_of_all<2>(cases));
    if (auto* refusal = std::get_if<Refusal>(&binding)) return std::move(*refusal);
    bound.kernel2_ = std::get<0>(std::move(binding));
  } else {
    auto binding = subject.bind3(points_of_all<3>(cases));
    if (auto* refusal = std::get_if<Refusal>(&binding)) return std::move(*refusal);
    bound.kernel3_ = std::get<0>(std::move(binding));
  }
  return bound;
}

std::optional<Decision> decide_alone(const Subject& subject, const Case& asked) {
  const auto binding = bind_subject(subject, std::span(&asked, 1));
  if (std::holds_alternative<Refusal>(binding)) return std::nullopt;
  return std::get<BoundSubject>(binding).decide(asked);
}

}  // namespace tribunal::bench::fuzz
