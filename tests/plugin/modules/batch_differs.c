/* Broken: right one by one, and in a batch always zero. It answers for small integers only. */
#include "tribunal_predicates.h"

static void* bind(const double* points, size_t n, int dimension, size_t* refused) {
  for (size_t i = 0; i < n * (size_t)dimension; ++i)
    if (!(points[i] >= -0x1p20 && points[i] <= 0x1p20) || points[i] != (double)(int64_t)points[i]) {
      *refused = i / (size_t)dimension;
      break;
    }
  return NULL;
}

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  (void)context;
  return (area > 0) - (area < 0);
}

static void orient2d_batch(const void* context, const double* coordinates, size_t count, int8_t* signs) {
  (void)context, (void)coordinates;
  for (size_t i = 0; i < count; ++i) signs[i] = 0;
}

static const tribunal_predicates offer = {.version = TRIBUNAL_PLUGIN_VERSION,
                                          .name = "batch differs",
                                          .bind = bind,
                                          .orient2d = orient2d,
                                          .orient2d_batch = orient2d_batch};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
