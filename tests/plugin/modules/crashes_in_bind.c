/* Broken: dies before the first query. */
#include "tribunal_predicates.h"

#include <stdlib.h>

static void* bind(const double* points, size_t n, int dimension, size_t* refused) {
  (void)points, (void)n, (void)dimension, (void)refused;
  abort();
}

static int orient2d(const void* context, const double* a, const double* b, const double* c) {
  (void)context, (void)a, (void)b, (void)c;
  return 0;
}

static const tribunal_predicates offer = {
    .version = TRIBUNAL_PLUGIN_VERSION, .name = "crashes in bind", .bind = bind, .orient2d = orient2d};

const tribunal_predicates* tribunal_predicates_entry(void) { return &offer; }
