/* The smallest plug-in: two predicates in plain double precision. `tribunal try` finds it wrong near zero. */
#include "tribunal_predicates.h"

static int sign(double x) { return (x > 0) - (x < 0); }

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  (void)context;
  return sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

static int incircle(const void* context, const double* a, const double* b, const double* c, const double* d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1];
  const double bx = b[0] - d[0], by = b[1] - d[1];
  const double cx = c[0] - d[0], cy = c[1] - d[1];
  (void)context;
  return sign((ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
              (cx * cx + cy * cy) * (ax * by - ay * bx));
}

static const tribunal_predicates offer = {
    .version = TRIBUNAL_PLUGIN_VERSION,
    .name = "naive",
    .cites = "common practice",
    .summary = "the determinants as written, rounded",
    .orient2d = orient2d,
    .incircle = incircle,
};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
