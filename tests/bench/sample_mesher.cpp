// Meshers for the tests of races. They serve convex polygons alone, and join their points to the first one or
// to a new one in the middle. Built in variants: one does that, one leaves out the last triangle, one never
// answers, one offers nothing, one leaves the rounding mode changed.
#include "algorithms/plugin/tribunal_mesher.h"

#include <cfenv>

namespace {

enum Flaw { none, gap, hang, idle, rounding };
constexpr Flaw flaw = SAMPLE_FLAW;

/// The polygon must be given by segments i to i + 1, and the last one to 0.
bool is_polygon(const tribunal_graph* graph) {
  for (size_t s = 0; s < graph->m; ++s)
    if (graph->segments[2 * s] != s || graph->segments[2 * s + 1] != (s + 1) % graph->n) return false;
  return graph->m == graph->n && graph->n > 2;
}

void wait_for_ever() {
  for (volatile bool waiting = true; waiting;) {
  }
}

int triangulate(const tribunal_graph* graph, const tribunal_receiver* receiver) {
  if (flaw == hang) wait_for_ever();
  if (flaw == rounding) std::fesetround(FE_UPWARD);
  if (!is_polygon(graph)) return TRIBUNAL_REFUSED;
  const auto n = static_cast<uint32_t>(graph->n);
  for (uint32_t i = 2; i < (flaw == gap ? n - 1 : n); ++i) receiver->triangle(receiver->sink, 0, i, i - 1);
  return TRIBUNAL_DONE;
}

int refine(const tribunal_graph* graph, const tribunal_bounds* bounds, const tribunal_receiver* receiver) {
  if (flaw == hang) wait_for_ever();
  if (flaw == rounding) std::fesetround(FE_UPWARD);
  if (!is_polygon(graph) || bounds->sine_squared > 0.5) return TRIBUNAL_REFUSED;
  const auto n = static_cast<uint32_t>(graph->n);
  double x = 0, y = 0;
  for (uint32_t i = 0; i < n; ++i) {
    x += graph->points[2 * i] / n;
    y += graph->points[2 * i + 1] / n;
    receiver->subsegment(receiver->sink, i, (i + 1) % n);
    if (flaw != gap || i > 0) receiver->triangle(receiver->sink, i, (i + 1) % n, n);
  }
  receiver->vertex(receiver->sink, x, y);
  return TRIBUNAL_DONE;
}

constexpr tribunal_mesher offer{
    TRIBUNAL_PLUGIN_VERSION,        "sample", nullptr, nullptr, flaw == idle ? nullptr : triangulate,
    flaw == idle ? nullptr : refine};

}  // namespace

extern "C" const tribunal_mesher* tribunal_mesher_entry(void) { return &offer; }
