/* Broken: takes what is small for zero. */
#include "tribunal_predicates.h"

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  const double epsilon = 1e-12;
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  (void)context;
  return (area > epsilon) - (area < -epsilon);
}

static const tribunal_predicates offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "epsilon", .orient2d = orient2d};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
