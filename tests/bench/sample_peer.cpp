// A plug-in for the tests of the micro benchmark: every orientation in the plane is "positive", and it
// refuses points right of x = 1.
#include "predicates/plugin/tribunal_predicates.h"

namespace {

int positive(const void*, const double*, const double*, const double*) { return 1; }

void all_positive(const void*, const double*, size_t count, int8_t* signs) {
  for (size_t i = 0; i < count; ++i) signs[i] = 1;
}

void* bind(const double* points, size_t n, int dimension, size_t* refused) {
  for (size_t i = 0; i < n; ++i)
    if (points[i * static_cast<size_t>(dimension)] > 1) {
      *refused = i;
      break;
    }
  return nullptr;
}

}  // namespace

extern "C" const tribunal_predicates* tribunal_predicates_entry(void) {
  static tribunal_predicates offer;
  offer.version = TRIBUNAL_PLUGIN_VERSION;
  offer.name = "optimist";
  offer.bind = bind;
  offer.orient2d = positive;
  offer.orient2d_batch = all_positive;
  return &offer;
}
