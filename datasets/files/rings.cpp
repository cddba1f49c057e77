#include "datasets/files/rings.hpp"

#include "datasets/files/numerals.hpp"

#include <algorithm>

namespace tribunal::files {
void Rings::push(Point2 point, Scanner::Place where) {
  if (size() == 0xFFFFFFFF) cursor_.refuse_at(where, "more points than 32 bits can number");
  pslg_.sites.points.push_back(point);
  pslg_.sites.lines.push_back(where.line);
}

void Rings::join(std::uint32_t a, std::uint32_t b) {
  pslg_.segments.push_back({a, b});
  pslg_.segment_lines.push_back(pslg_.sites.lines[b]);
  pslg_.segment_rings.push_back(PslgFile::no_ring);
}

void Rings::add(Point2 point, Scanner::Place where) {
  if (size() > first_ && pslg_.sites.points.back() == point)
    cursor_.refuse_at(where, "a segment without length: " + point_text(point) + " follows itself");
  push(point, where);
  if (size() > first_ + 1) join(size() - 2, size() - 1);
}

void Rings::end_chain(Scanner::Place where) {
  if (size() == first_ + 1) cursor_.refuse_at(where, "a line of one point");
}

void Rings::end_ring(Scanner::Place where) {
  pslg_.domain = "even-odd";
  PointFile& sites = pslg_.sites;
  if (size() == first_) return;
  if (!(sites.points[first_] == sites.points.back()) || size() == first_ + 1)
    cursor_.refuse_at(where, "an open ring: it begins at " + point_text(sites.points[first_]) + " in line " +
                                 std::to_string(sites.lines[first_]) + " and ends at " +
                                 point_text(sites.points.back()));
  if (size() < first_ + 4) cursor_.refuse_at(where, "a ring of less than three points");
  sites.points.pop_back();
  sites.lines.pop_back();
  pslg_.segments.back()[1] = first_;
  std::fill(pslg_.segment_rings.end() - (size() - first_), pslg_.segment_rings.end(),
            static_cast<std::uint32_t>(pslg_.ring_outers.size()));
  pslg_.ring_outers.push_back(outer_);
}

void Rings::add_alone(Point2 point, Scanner::Place where) { push(point, where); }

PslgFile Rings::take() {
  if (pslg_.sites.points.empty()) cursor_.refuse_file("no points");
  return std::move(pslg_);
}

}  // namespace tribunal::files
