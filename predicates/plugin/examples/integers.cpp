// A plug-in with a domain: exact predicates over integers below 2^29 in size, by 128-bit arithmetic. Points
// outside are refused in bind, so that `tribunal try` finds it refusing, and never wrong.
#include "tribunal_predicates.h"

#include <cmath>

namespace {

__extension__ using Wide = __int128;

constexpr double bound = 0x1p29;

// Differences are below 2^30 in size, and the determinants below: orient2d 2 * 2^60; orient3d 6 * 2^90;
// incircle 6 * 2^121 < 2^124 (three products of a squared length, at most 2^61, and a minor, at most 2^61).
Wide difference(const double* p, const double* q, int axis) {
  return static_cast<Wide>(p[axis]) - static_cast<Wide>(q[axis]);
}

int sign(Wide value) { return (value > 0) - (value < 0); }

void* bind(const double* points, size_t n, int dimension, size_t* refused) {
  const size_t numbers = n * static_cast<size_t>(dimension);
  for (size_t i = 0; i < numbers; ++i)
    if (std::trunc(points[i]) != points[i] || !(std::fabs(points[i]) < bound)) {
      *refused = i / static_cast<size_t>(dimension);
      return nullptr;
    }
  return nullptr;  // nothing to remember
}

int orient2d(const void*, const double* a, const double* b, const double* c) {
  return sign(difference(b, a, 0) * difference(c, a, 1) - difference(b, a, 1) * difference(c, a, 0));
}

int incircle(const void*, const double* a, const double* b, const double* c, const double* d) {
  const Wide ax = difference(a, d, 0), ay = difference(a, d, 1);
  const Wide bx = difference(b, d, 0), by = difference(b, d, 1);
  const Wide cx = difference(c, d, 0), cy = difference(c, d, 1);
  return sign((ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
              (cx * cx + cy * cy) * (ax * by - ay * bx));
}

int orient3d(const void*, const double* a, const double* b, const double* c, const double* d) {
  const Wide bx = difference(b, a, 0), by = difference(b, a, 1), bz = difference(b, a, 2);
  const Wide cx = difference(c, a, 0), cy = difference(c, a, 1), cz = difference(c, a, 2);
  const Wide dx = difference(d, a, 0), dy = difference(d, a, 1), dz = difference(d, a, 2);
  return sign(bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx));
}

const tribunal_predicates* offer() {
  static const tribunal_predicates offered = [] {
    tribunal_predicates all{};
    all.version = TRIBUNAL_PLUGIN_VERSION;
    all.name = "integers";
    all.cites = "common practice";
    all.summary = "128-bit arithmetic over integers below 2^29";
    all.bind = bind;
    all.orient2d = orient2d;
    all.incircle = incircle;
    all.orient3d = orient3d;
    return all;
  }();
  return &offered;
}

}  // namespace

extern "C" const tribunal_predicates* tribunal_predicates_entry() { return offer(); }
