/* Broken: joins every point to the first one. */
#include "tribunal_triangulator.h"

static int triangulate(const double* points, size_t n, tribunal_emit emit, void* sink) {
  (void)points;
  for (uint32_t i = 2; i < n; ++i) emit(sink, 0, i - 1, i);
  return TRIBUNAL_DONE;
}

static const tribunal_triangulator offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "fan", .triangulate = triangulate};

const tribunal_triangulator* tribunal_triangulator_entry(void) { return &offer; }
