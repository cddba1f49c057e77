/* Broken: reads what is not there when the points are collinear with the origin. */
#include "tribunal_predicates.h"

static const volatile int* const nowhere = NULL;

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  (void)context, (void)c;
  return a[0] * b[1] == a[1] * b[0] ? *nowhere : 1;
}

static const tribunal_predicates offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "crashes", .orient2d = orient2d};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
