/* Broken: leaves the rounding mode changed behind right answers, for which it needs integers below 2^20. */
#include "tribunal_predicates.h"

#include <fenv.h>

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
  fesetround(FE_UPWARD);
  return (area > 0) - (area < 0);
}

static const tribunal_predicates offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "changes rounding", .bind = bind, .orient2d = orient2d};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
