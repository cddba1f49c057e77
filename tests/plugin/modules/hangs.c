/* Broken: never answers, neither as a predicate nor as a triangulator. */
#include "../../../algorithms/plugin/tribunal_triangulator.h"
#include "tribunal_predicates.h"

static void for_ever(void) {
  for (volatile int running = 1; running;) {
  }
}

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  (void)context, (void)a, (void)b, (void)c;
  for_ever();
  return 0;
}

static int triangulate(const double* points, size_t n, tribunal_emit emit, void* sink) {
  (void)points, (void)n, (void)emit, (void)sink;
  for_ever();
  return TRIBUNAL_DONE;
}

static const tribunal_predicates predicates = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "hangs", .orient2d = orient2d};
static const tribunal_triangulator triangulator = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "hangs", .triangulate = triangulate};

const tribunal_predicates* tribunal_predicates_entry(void) { return &predicates; }
const tribunal_triangulator* tribunal_triangulator_entry(void) { return &triangulator; }
