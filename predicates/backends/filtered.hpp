// Backend `filtered`, the default: floating point where it proves the sign, integers where the data are a
// lattice, pairs of doubles and wider integers where they are not, GMP last.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/backends/exact_sign.hpp"
#include "predicates/backends/integer_sign.hpp"
#include "predicates/backends/window_sign.hpp"
#include "predicates/domain.hpp"
#include "predicates/filters/double_double.hpp"
#include "predicates/filters/dynamic.hpp"
#include "predicates/integer_frame.hpp"
#include "predicates/working_box.hpp"

#include <algorithm>
#include <cassert>
#include <concepts>
#include <optional>

namespace tribunal {

class Filtered {
 public:
  static constexpr BackendAbout about{
      .name = "filtered",
      .cites = "Fortune and Van Wyk 1993; Shewchuk 1997; Bartels, Fisikopoulos and Weiser 2023",
      .summary = "a certified filter, then integers or double-doubles as the data suggest, GMP last",
      .domain = "finite doubles",
      .exact = true,
  };

  template <int D>
  static Binding<Filtered> bind(std::span<const Point<D>> points) {
    if (auto refusal = refuse_unusable(points)) return *refusal;
    return Filtered(WorkingBox::around(points), IntegerFrame::find(points));
  }
  template <int D>
  bool admits(const Point<D>& p) const {
    return box_.contains(p);
  }

  /// One threshold for the whole box decides nearly every query; it costs a comparison more than no filter at
  /// all. Formulas without one begin with the bound of their own points: a high degree sets short edges too
  /// far below the box.
  template <class Formula>
  Decision decide(const Query<Formula>& query) const {
    assert(std::all_of(query.begin(), query.end(), [&](const auto& p) { return admits(p); }));
    Sign sign;
    if constexpr (has_threshold<Formula>)
      sign = sign_beyond(Formula::determinant(query), threshold<Formula>());
    else
      sign = filtered_sign<Formula>(query);
    if (sign != Sign::zero) [[likely]]
      return {sign, Stage::filter};
    return with_coordinates<Formula>(
        query, [this](auto... c) { return this->template decide_close<Formula>(c...); });
  }

  template <class Formula>
  static constexpr bool has_threshold =
      std::same_as<Formula, Orient<2>> || std::same_as<Formula, InSphere<2>> ||
      std::same_as<Formula, Orient<3>> || std::same_as<Formula, InSphere<3>> ||
      std::same_as<Formula, CompareLength<2>> || std::same_as<Formula, Cosine<2>>;

  /// A determinant of admitted points, computed in doubles as written, that is greater in magnitude has its
  /// true sign. Infinite for formulas that have none.
  template <class Formula>
  double threshold() const {
    if constexpr (std::same_as<Formula, Orient<2>>)
      return orient2d_threshold_;
    else if constexpr (std::same_as<Formula, InSphere<2>>)
      return incircle_threshold_;
    else if constexpr (std::same_as<Formula, Orient<3>>)
      return orient3d_threshold_;
    else if constexpr (std::same_as<Formula, InSphere<3>>)
      return insphere_threshold_;
    else if constexpr (std::same_as<Formula, CompareLength<2>>)
      return length_threshold_;
    else if constexpr (std::same_as<Formula, Cosine<2>>)
      return cosine_threshold_;
    else
      return std::numeric_limits<double>::infinity();
  }

 private:
  Filtered(const WorkingBox& box, const std::optional<IntegerFrame>& frame)
      : box_(box),
        frame_(frame),
        orient2d_threshold_(error_bound_in_box<Orient<2>>(box.width())),
        incircle_threshold_(error_bound_in_box<InSphere<2>>(box.width())),
        orient3d_threshold_(error_bound_in_box<Orient<3>>(box.width())),
        insphere_threshold_(error_bound_in_box<InSphere<3>>(box.width())),
        length_threshold_(error_bound_in_box<CompareLength<2>>(box.width())),
        cosine_threshold_(error_bound_in_box<Cosine<2>>(box.width())) {}

  /// What the threshold of the box left open. On a lattice integers come first: they cost little more than a
  /// finer filter, and always decide. `count` finds out a point off the lattice or outside the bound points'
  /// own box; then the finer filters follow.
  template <class Formula>
  [[gnu::noinline]] Decision decide_close(std::same_as<double> auto... coordinates) const {
    const Query<Formula> query = query_of<Formula>(coordinates...);
    Arguments<std::int64_t, Formula> counts;
    if (frame_ && frame_->count<Formula>(query, counts))
      return {integer_sign<Formula>(counts, frame_->bits()), Stage::integer};
    // Where the finer filter is right as often as not, guessing wrong costs what double-doubles do in the
    // plane.
    if constexpr (!std::same_as<Formula, Orient<2>>)
      if (const Sign sign = filtered_sign<Formula>(query); sign != Sign::zero) return {sign, Stage::filter};
    if (const Sign sign = double_double_sign<Formula>(query); sign != Sign::zero)
      return {sign, Stage::double_double};
    if (const auto windowed = window_sign<Formula>(query)) return {*windowed, Stage::integer};
    return {exact_sign<Formula>(query), Stage::exact};
  }

  WorkingBox box_;
  std::optional<IntegerFrame> frame_;  ///< of the bound points, where they have one
  double orient2d_threshold_, incircle_threshold_, orient3d_threshold_, insphere_threshold_,
      length_threshold_, cosine_threshold_;
};
static_assert(Backend<Filtered, 2> && Backend<Filtered, 3>);

}  // namespace tribunal
