// A kernel that counts what is asked of another one, by predicate and by the stage that decided.
#pragma once

#include "predicates/decision.hpp"
#include "predicates/kernel.hpp"
#include "predicates/predicate.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribunal {

/// Calls by predicate and deciding stage, comparisons behind the predicates.
struct PredicateCounts {
  using ByStage = std::array<std::uint64_t, stage_names.size()>;

  /// One row of calls each.
  static constexpr auto names = [] {
    std::array<std::string_view, predicate_names.size() + comparison_names.size()> all;
    std::ranges::copy(comparison_names, std::ranges::copy(predicate_names, all.begin()).out);
    return all;
  }();
  std::array<ByStage, names.size()> calls{};

  static constexpr std::size_t row(Predicate p) { return static_cast<std::size_t>(p); }
  static constexpr std::size_t row(Comparison c) {
    return predicate_names.size() + static_cast<std::size_t>(c);
  }
  std::uint64_t& at(auto question, Stage s) { return calls[row(question)][static_cast<std::size_t>(s)]; }
  std::uint64_t at(auto question, Stage s) const { return calls[row(question)][static_cast<std::size_t>(s)]; }
  std::uint64_t total(auto question) const { return total_of_row(row(question)); }
  std::uint64_t total_of_row(std::size_t row) const {
    return std::accumulate(calls[row].begin(), calls[row].end(), std::uint64_t{0});
  }
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (std::size_t row = 0; row < names.size(); ++row) sum += total_of_row(row);
    return sum;
  }

  /// Everything that was called, as ("incircle", calls), followed by its stages that decided anything, as
  /// ("incircle.filter", calls). In order of predicate and stage.
  std::vector<std::pair<std::string, std::uint64_t>> named() const {
    std::vector<std::pair<std::string, std::uint64_t>> result;
    for (std::size_t row = 0; row < names.size(); ++row) {
      if (total_of_row(row) == 0) continue;
      const std::string question(names[row]);
      result.emplace_back(question, total_of_row(row));
      for (std::size_t s = 0; s < stage_names.size(); ++s)
        if (calls[row][s] != 0)
          result.emplace_back(question + "." + std::string(stage_names[s]), calls[row][s]);
    }
    return result;
  }

  friend bool operator==(const PredicateCounts&, const PredicateCounts&) = default;
};

/// Passes each query on and counts it. Kernel and counts belong to the caller and must outlive it. The counts
/// are not synchronised: one decorator per thread. Never where time is taken.
class CountedKernel2 final : public Kernel2 {
 public:
  CountedKernel2(const Kernel2& kernel, PredicateCounts& counts) : kernel_(kernel), counts_(counts) {}
  Decision decide_orient2d(Point2 a, Point2 b, Point2 c) const override {
    return counted(Predicate::orient2d, kernel_.decide_orient2d(a, b, c));
  }
  Decision decide_incircle(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return counted(Predicate::incircle, kernel_.decide_incircle(a, b, c, d));
  }
  Decision decide_compare_length(Point2 a, Point2 b, Point2 c, Point2 d) const override {
    return counted(Comparison::length, kernel_.decide_compare_length(a, b, c, d));
  }
  Decision decide_compare_angle(const Angle<2>& p, const Angle<2>& q) const override {
    return counted(Comparison::angle, kernel_.decide_compare_angle(p, q));
  }
  bool admits(Point2 p) const override { return kernel_.admits(p); }

 private:
  Decision counted(auto question, Decision decision) const {
    ++counts_.at(question, decision.stage);
    return decision;
  }
  const Kernel2& kernel_;
  PredicateCounts& counts_;
};

/// The same in space.
class CountedKernel3 final : public Kernel3 {
 public:
  CountedKernel3(const Kernel3& kernel, PredicateCounts& counts) : kernel_(kernel), counts_(counts) {}
  Decision decide_orient3d(Point3 a, Point3 b, Point3 c, Point3 d) const override {
    return counted(Predicate::orient3d, kernel_.decide_orient3d(a, b, c, d));
  }
  Decision decide_insphere(Point3 a, Point3 b, Point3 c, Point3 d, Point3 e) const override {
    return counted(Predicate::insphere, kernel_.decide_insphere(a, b, c, d, e));
  }
  bool admits(Point3 p) const override { return kernel_.admits(p); }

 private:
  Decision counted(Predicate predicate, Decision decision) const {
    ++counts_.at(predicate, decision.stage);
    return decision;
  }
  const Kernel3& kernel_;
  PredicateCounts& counts_;
};

}  // namespace tribunal
