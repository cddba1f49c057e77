/* Broken: one product of the determinant is fused into the difference, as a compiler does that contracts. */
#include "tribunal_predicates.h"

#include <math.h>

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double area = fma(b[0] - a[0], c[1] - a[1], -right);
  (void)context;
  return (area > 0) - (area < 0);
}

static const tribunal_predicates offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "contracted", .orient2d = orient2d};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
