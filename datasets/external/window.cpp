// Shores cut at a window, and the sea's outlines closed along its border.
#include "datasets/external/shore.hpp"
#include "datasets/files/files.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace tribunal::shores {
namespace {

/// A parameter along an edge, as a fraction with a positive denominator.
struct Fraction {
  Wide numerator, denominator;
  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
};

bool inside(const Place& p, const Window& w) {
  return w.low.x < p.x && p.x < w.high.x && w.low.y < p.y && p.y < w.high.y;
}

std::int64_t rounded(const Fraction& t) {
  const Wide doubled = 2 * t.numerator + t.denominator, divisor = 2 * t.denominator;
  return static_cast<std::int64_t>(doubled / divisor - (doubled % divisor < 0 ? 1 : 0));
}

/// The part of an edge in the window: nothing, or its ends, moved to the border where they lie outside.
std::optional<std::array<Place, 2>> visible(const Place& p, const Place& q, const Window& window) {
  struct Side {
    std::int64_t Place::*across;
    std::int64_t line, inwards;
  };
  const std::array<Side, 4> sides{{{&Place::x, window.low.x, 1},
                                   {&Place::x, window.high.x, -1},
                                   {&Place::y, window.low.y, 1},
                                   {&Place::y, window.high.y, -1}}};
  Fraction from{0, 1}, to{1, 1};
  const Side *entered = nullptr, *left = nullptr;
  for (const Side& side : sides) {
    const std::int64_t at_p = side.inwards * (p.*side.across - side.line),
                       at_q = side.inwards * (q.*side.across - side.line);
    if (at_p < 0 && at_q < 0) return std::nullopt;
    if (at_p < 0) {
      const Fraction t{-at_p, Wide{at_q} - at_p};
      if (from < t) from = t, entered = &side;
    } else if (at_q < 0) {
      const Fraction t{at_p, Wide{at_p} - at_q};
      if (t < to) to = t, left = &side;
    }
  }
  if (!(from < to)) return std::nullopt;
  const auto on = [&](const Side& side, const Fraction& t) {
    const auto along = side.across == &Place::x ? &Place::y : &Place::x;
    Place place{};
    place.*side.across = side.line;
    place.*along = p.*along + rounded({t.numerator * (q.*along - p.*along), t.denominator});
    return place;
  };
  return std::array{entered == nullptr ? p : on(*entered, from), left == nullptr ? q : on(*left, to)};
}

[[noreturn]] void fail_at(const Place& place, const std::string& what) {
  throw BadInput(what + " at " + std::to_string(place.x / steps_per_degree) + " degrees east, " +
                 std::to_string(place.y / steps_per_degree) + " north");
}

void cut_one(const Shore& shore, const Window& window, std::vector<Shore>& seen) {
  const std::vector<Place>& places = shore.places;
  const auto outside = std::ranges::find_if(places, [&](const Place& p) { return !inside(p, window); });
  if (outside == places.end() && shore.closed) {
    seen.push_back(shore);
    return;
  }
  for (const Place& end : {places.front(), places.back()})
    if (!shore.closed && inside(end, window)) fail_at(end, "a shore ends in the sea");
  // A closed one is walked from a place outside, and back to it.
  const auto start = shore.closed ? static_cast<std::size_t>(outside - places.begin()) : 0;
  const std::size_t edges = places.size() - (shore.closed ? 0 : 1);
  const auto place = [&](std::size_t i) { return places[(start + i) % places.size()]; };
  for (std::size_t i = 0; i < edges; ++i) {
    const auto part = visible(place(i), place(i + 1), window);
    if (!part) continue;
    if (!inside(place(i), window)) seen.push_back({shore.polygon, false, {(*part)[0]}});
    seen.back().places.push_back((*part)[1]);
  }
}

/// How far along the border a place on it is, counter-clockwise from the south-west corner.
std::int64_t position(const Place& p, const Window& w) {
  const std::int64_t width = w.high.x - w.low.x, height = w.high.y - w.low.y;
  if (p.y == w.low.y) return p.x - w.low.x;
  if (p.x == w.high.x) return width + (p.y - w.low.y);
  if (p.y == w.high.y) return width + height + (w.high.x - p.x);
  return 2 * width + height + (w.high.y - p.y);
}

struct Corner {
  std::int64_t position;
  Place place;
};

std::array<Corner, 4> corners(const Window& w) {
  std::array<Corner, 4> all{{{0, w.low}, {0, {w.high.x, w.low.y}}, {0, w.high}, {0, {w.low.x, w.high.y}}}};
  for (Corner& corner : all) corner.position = position(corner.place, w);
  return all;
}

/// Where an open shore meets the border.
struct Meeting {
  std::int64_t position;
  std::size_t shore;
  bool enters;
};

std::vector<Meeting> meetings_with_border(const std::vector<Shore>& shores, const Window& window) {
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < shores.size(); ++i) {
    if (shores[i].closed) continue;
    meetings.push_back({position(shores[i].places.front(), window), i, true});
    meetings.push_back({position(shores[i].places.back(), window), i, false});
  }
  std::ranges::sort(meetings, {}, &Meeting::position);
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const Meeting &here = meetings[i], &next = meetings[(i + 1) % meetings.size()];
    if (here.enters == next.enters || here.position == next.position)
      fail_at(shores[here.shore].places[0], "shores cross on the border of the window: that");
  }
  return meetings;
}

/// The corners met on the way along the border from one position to another.
void append_corners(std::int64_t from, std::int64_t to, const Window& window, std::vector<Place>& outline) {
  const auto all = corners(window);
  for (const Corner& corner : all)
    if (corner.position > from && (to < from || corner.position < to)) outline.push_back(corner.place);
  for (const Corner& corner : all)
    if (to < from && corner.position < to) outline.push_back(corner.place);
}

}  // namespace

std::vector<Shore> cut(const std::vector<Shore>& shores, const Window& window) {
  std::vector<Shore> seen;
  for (const Shore& shore : shores) cut_one(shore, window, seen);
  return seen;
}

std::vector<std::vector<Place>> close_along_border(const std::vector<Shore>& shores, const Window& window) {
  const std::vector<Meeting> meetings = meetings_with_border(shores, window);
  if (meetings.empty()) {
    std::vector<Place> outline;
    for (const Corner& corner : corners(window)) outline.push_back(corner.place);
    return {outline};
  }
  std::vector<std::size_t> entry(shores.size());
  for (std::size_t i = 0; i < meetings.size(); ++i)
    if (meetings[i].enters) entry[meetings[i].shore] = i;

  std::vector<std::vector<Place>> outlines;
  std::vector<bool> used(shores.size(), false);
  for (const Meeting& first : meetings) {
    if (used[first.shore]) continue;
    std::vector<Place>& outline = outlines.emplace_back();
    // With the sea to the left: along each shore backwards, then along the border to where the next leaves.
    for (std::size_t at = first.shore; !used[at];) {
      used[at] = true;
      outline.insert(outline.end(), shores[at].places.rbegin(), shores[at].places.rend());
      const Meeting& next = meetings[(entry[at] + 1) % meetings.size()];
      append_corners(meetings[entry[at]].position, next.position, window, outline);
      at = next.shore;
    }
  }
  return outlines;
}

}  // namespace tribunal::shores
