// A kernel that counts what is asked of another one, by predicate and by the stage that decided.
#pragma once

#include "predicates/decision.hpp"
#include "predicates/kernel.hpp"
#include "predicates/predicate.hpp"

#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace tribunal {

/// Calls by predicate and deciding stage.
struct PredicateCounts {
  using ByStage = std::array<std::uint64_t, stage_names.size()>;
  std::array<ByStage, predicate_names.size()> calls{};

  std::uint64_t& at(Predicate p, Stage s) {
    return calls[static_cast<std::size_t>(p)][static_cast<std::size_t>(s)];
  }
  std::uint64_t at(Predicate p, Stage s) const {
    return calls[static_cast<std::size_t>(p)][static_cast<std::size_t>(s)];
  }
  std::uint64_t total(Predicate p) const {
    const ByStage& stages = calls[static_cast<std::size_t>(p)];
    return std::accumulate(stages.begin(), stages.end(), std::uint64_t{0});
  }
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (std::size_t p = 0; p < predicate_names.size(); ++p) sum += total(static_cast<Predicate>(p));
    return sum;
  }

  /// Every predicate that was called, as ("incircle", calls), followed by its stages that decided anything,
  /// as
  /// ("incircle.filter", calls). In order of predicate and stage.
  std::vector<std::pair<std::string, std::uint64_t>> named() const {
    std::vector<std::pair<std::string, std::uint64_t>> names;
    for (std::size_t p = 0; p < predicate_names.size(); ++p) {
      if (total(static_cast<Predicate>(p)) == 0) continue;
      const std::string predicate(predicate_names[p]);
      names.emplace_back(predicate, total(static_cast<Predicate>(p)));
      for (std::size_t s = 0; s < stage_names.size(); ++s)
        if (calls[p][s] != 0) names.emplace_back(predicate + "." + std::string(stage_names[s]), calls[p][s]);
    }
    return names;
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
  bool admits(Point2 p) const override { return kernel_.admits(p); }

 private:
  Decision counted(Predicate predicate, Decision decision) const {
    ++counts_.at(predicate, decision.stage);
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
