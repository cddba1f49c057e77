#include "algorithms/verify/fault_list.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tribunal::verify {
namespace {

constexpr std::array<std::string_view, fault_kinds> names{
    "index_out_of_range", "repeated_corner",   "duplicate_used", "wrong_orientation", "flat_triangle",
    "doubled_triangle",   "non_manifold_edge", "folded_edge",    "crossing_edges",    "non_manifold_vertex",
    "missing_site",       "hull_mismatch",     "not_connected",  "wrong_count",       "wrong_neighbour",
    "non_delaunay",       "missing_segment",   "wrong_domain"};

/// "triangles 4, 9"; long lists are cut short, the fault itself has them whole.
std::string enumerate(std::string_view noun, const std::vector<std::uint32_t>& items) {
  constexpr std::size_t shown = 8;
  std::string text(noun);
  if (items.size() > 1) text += 's';
  for (std::size_t i = 0; i < std::min(items.size(), shown); ++i)
    text += (i == 0 ? " " : ", ") + std::to_string(items[i]);
  if (items.size() > shown) text += ", ... (" + std::to_string(items.size()) + ")";
  return text;
}

std::string describe(std::string_view what, const std::vector<std::uint32_t>& simplices,
                     const std::vector<std::uint32_t>& points) {
  std::string text(what);
  if (simplices.empty() && points.empty()) return text;
  text += " (";
  if (!simplices.empty()) text += enumerate("triangle", simplices);
  if (!simplices.empty() && !points.empty()) text += "; ";
  if (!points.empty()) text += enumerate("point", points);
  return text + ")";
}

bool precedes(const Fault& a, const Fault& b) {
  return std::tie(a.kind, a.simplices, a.points) < std::tie(b.kind, b.simplices, b.points);
}

}  // namespace

std::string_view to_string(FaultKind kind) { return names[static_cast<std::size_t>(kind)]; }

void FaultList::add(FaultKind kind, std::vector<std::uint32_t> simplices, std::vector<std::uint32_t> points,
                    std::string_view what) {
  if (++found_[static_cast<std::size_t>(kind)] > limit_) return;
  std::string detail = describe(what, simplices, points);
  faults_.push_back({kind, std::move(simplices), std::move(points), std::move(detail)});
}

std::uint64_t FaultList::found() const {
  return std::accumulate(found_.begin(), found_.end(), std::uint64_t{0});
}

std::vector<Fault> FaultList::take() {
  std::sort(faults_.begin(), faults_.end(), precedes);
  if (faults_.size() > limit_) {
    // Rank of each fault among its kind; the lowest ranks stay.
    std::array<std::size_t, fault_kinds> seen{};
    std::vector<std::pair<std::size_t, std::size_t>> turns;
    for (std::size_t i = 0; i < faults_.size(); ++i)
      turns.emplace_back(seen[static_cast<std::size_t>(faults_[i].kind)]++, i);
    std::sort(turns.begin(), turns.end());
    std::vector<Fault> kept;
    for (std::size_t i = 0; i < limit_; ++i) kept.push_back(std::move(faults_[turns[i].second]));
    std::sort(kept.begin(), kept.end(), precedes);
    faults_ = std::move(kept);
  }
  return std::move(faults_);
}

}  // namespace tribunal::verify
