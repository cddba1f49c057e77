// The `+sos` entry of an exact backend, derived from the backend's own.
#pragma once

#include "predicates/backend.hpp"
#include "predicates/symbolic/tie_breaking.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

namespace tribunal {

namespace detail {

/// The name of B with "+sos" behind it, kept where a string_view may point.
template <class B>
struct SymbolicName {
  static constexpr std::string_view suffix = "+sos";
  static constexpr auto text = [] {
    std::array<char, B::about.name.size() + suffix.size()> characters{};
    std::copy(suffix.begin(), suffix.end(),
              std::copy(B::about.name.begin(), B::about.name.end(), characters.begin()));
    return characters;
  }();
};

template <class B>
inline constexpr BackendAbout symbolic_about{
    .name = {SymbolicName<B>::text.data(), SymbolicName<B>::text.size()},
    .cites = "Devillers and Teillaud 2011; Edelsbrunner and Muecke 1990",
    .summary = "the backend before the plus; in-sphere ties are broken by the points' lexicographic order",
    .domain = B::about.domain,
    .exact = true,
};

template <class Kernel, class TieBreaking, int D>
Binding<std::unique_ptr<const Kernel>> bind_symbolic(
    Binding<std::unique_ptr<const Kernel>> (*bind)(std::span<const Point<D>>),
    std::span<const Point<D>> points) {
  auto bound = bind(points);
  if (auto* refusal = std::get_if<Refusal>(&bound)) return std::move(*refusal);
  return std::make_unique<const TieBreaking>(std::get<0>(std::move(bound)));
}

}  // namespace detail

/// The entry of B with ties broken; for exact B alone, for a zero that is not true is no tie.
template <Backend<2> B>
requires(B::about.exact) constexpr BackendEntry symbolic_entry() {
  BackendEntry entry{&detail::symbolic_about<B>,
                     [](std::span<const Point2> points) {
                       return detail::bind_symbolic<Kernel2, TieBreakingKernel2>(backend_entry<B>().bind2,
                                                                                 points);
                     },
                     nullptr};
  if constexpr (Backend<B, 3>)
    entry.bind3 = [](std::span<const Point3> points) {
      return detail::bind_symbolic<Kernel3, TieBreakingKernel3>(backend_entry<B>().bind3, points);
    };
  return entry;
}

}  // namespace tribunal
