/* Broken: corners that are no points, and more triangles than there can be. */
#include "tribunal_triangulator.h"

static int triangulate(const double* points, size_t n, tribunal_emit emit, void* sink) {
  (void)points;
  if (n < 10) {
    emit(sink, 0xFFFFFFFF, 7, (uint32_t)n);
  } else {
    for (uint32_t i = 0; i < 100000000; ++i) emit(sink, 0, 1, 2);
  }
  return TRIBUNAL_DONE;
}

static const tribunal_triangulator offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "wild corners", .triangulate = triangulate};

const tribunal_triangulator* tribunal_triangulator_entry(void) { return &offer; }
