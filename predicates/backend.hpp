// What a backend is: an arithmetic plus a way to evaluate a formula's sign with it.
#pragma once

#include "predicates/certified.hpp"
#include "predicates/decision.hpp"
#include "predicates/formulas/compare_angle.hpp"
#include "predicates/formulas/compare_length.hpp"
#include "predicates/formulas/in_sphere.hpp"
#include "predicates/formulas/orient.hpp"
#include "predicates/formulas/query.hpp"
#include "predicates/kernel.hpp"

#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tribunal {

/// What `tribunal list backends` says of a backend.
struct BackendAbout {
  std::string_view name;
  std::string_view cites;    ///< author and year, or "this project"
  std::string_view summary;  ///< one line
  std::string_view domain;   ///< one line: which points it accepts
  bool exact;                ///< promises the true sign on its whole domain
};

/// Whether backend B gives the sign of a formula: most do of any.
template <class B, class Formula>
concept Evaluates = requires(const B backend) {
  { backend.template decide<Formula>(Query<Formula>{}) } -> std::same_as<Decision>;
};

/// A backend in D dimensions: a value that B::bind made for a point set, and that then only answers. `bind`
/// either accepts all the points or names the first that lies outside the domain, or what is wrong with the
/// floating-point environment; `decide` never fails.
template <class B, int D>
concept Backend = std::movable<B> &&
    requires(const B backend, std::span<const Point<D>> points, Point<D> point) {
  { B::about } -> std::convertible_to<const BackendAbout&>;
  { B::bind(points) } -> std::same_as<Binding<B>>;
  { backend.admits(point) } -> std::same_as<bool>;
} && Evaluates<B, Orient<D>> && Evaluates<B, InSphere<D>>;

/// A planar backend behind the interface. The direct member stays inlinable for engines that are templates.
template <Backend<2> B>
class ErasedKernel2 final : public Kernel2 {
 public:
  explicit ErasedKernel2(B backend) : backend_(std::move(backend)) {}
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override {
    return backend_.template decide<Orient<2>>({a, b, c});
  }
  Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return backend_.template decide<InSphere<2>>({a, b, c, d});
  }
  Decision decide_compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return evaluator<CompareLength<2>>().template decide<CompareLength<2>>({a, b, c, d});
  }
  Decision decide_compare_angle(const Angle<2>& p, const Angle<2>& q) const override {
    return tribunal::compare_angle<2>(evaluator<SineOfDifference>(), p, q);
  }
  bool admits(Point2 p) const override { return backend_.admits(p); }

 private:
  /// The backend itself, or what stands in for it where it serves two formulas only.
  template <class Formula>
  decltype(auto) evaluator() const {
    if constexpr (Evaluates<B, Formula>)
      return static_cast<const B&>(backend_);
    else
      return Certified{};
  }

  B backend_;
};

/// A spatial backend behind the interface.
template <Backend<3> B>
class ErasedKernel3 final : public Kernel3 {
 public:
  explicit ErasedKernel3(B backend) : backend_(std::move(backend)) {}
  Decision decide_orient3d(Point3 a, Point3 b, Point3 c, Point3 d) const override {
    return backend_.template decide<Orient<3>>({a, b, c, d});
  }
  Decision decide_insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) const override {
    return backend_.template decide<InSphere<3>>({a, b, c, d, e});
  }
  bool admits(Point3 p) const override { return backend_.admits(p); }

 private:
  B backend_;
};

/// One entry of the list of backends.
struct BackendEntry {
  const BackendAbout* about;
  Kernel2Binding (*bind2)(std::span<const Point2>);
  Kernel3Binding (*bind3)(std::span<const Point3>);  ///< null where the backend has no spatial predicates
};

namespace detail {
template <class Kernel, class Erased, class B, int D>
Binding<std::unique_ptr<const Kernel>> bind_erased(std::span<const Point<D>> points) {
  Binding<B> bound = B::bind(points);
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return std::make_unique<const Erased>(std::get<B>(std::move(bound)));
}
}  // namespace detail

/// The entry of backend B; its spatial half is filled in when B models Backend<3>.
template <Backend<2> B>
constexpr BackendEntry backend_entry() {
  BackendEntry entry{&B::about, &detail::bind_erased<Kernel2, ErasedKernel2<B>, B, 2>, nullptr};
  if constexpr (Backend<B, 3>) entry.bind3 = &detail::bind_erased<Kernel3, ErasedKernel3<B>, B, 3>;
  return entry;
}

}  // namespace tribunal
