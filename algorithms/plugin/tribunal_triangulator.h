/* A planar Delaunay triangulator as a plug-in: what a shared library offers so that `tribunal try --plugin`
 * can put it on trial. Copy this header; nothing else is needed.
 *
 * The library defines one function with C linkage,
 *
 *     const tribunal_triangulator* tribunal_triangulator_entry(void);
 *
 * which returns a structure that lives as long as the library. A library may also define
 * tribunal_predicates_entry (tribunal_predicates.h) and tribunal_mesher_entry (tribunal_mesher.h).
 *
 * Asked for is a Delaunay triangulation of the convex hull: every position is a corner of a triangle, and no
 * triangle has a position strictly inside its circle. Of cocircular points any triangulation will do. Points
 * that all lie on one line have no triangles. Repeated points are legal: use any copy.
 */
#ifndef TRIBUNAL_TRIANGULATOR_H
#define TRIBUNAL_TRIANGULATOR_H

#include <stddef.h>
#include <stdint.h>

/* One number for all headers of plug-ins; it changes when any declaration in one of them does. */
#ifndef TRIBUNAL_PLUGIN_VERSION
#define TRIBUNAL_PLUGIN_VERSION 1
#elif TRIBUNAL_PLUGIN_VERSION != 1
#error "the headers of plug-ins are of different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifndef TRIBUNAL_ENDINGS
#define TRIBUNAL_ENDINGS
/* How a triangulation ended. */
enum {
  TRIBUNAL_DONE = 0,    /* all triangles were given */
  TRIBUNAL_REFUSED = 1, /* the points are outside the library's domain; triangles given are ignored */
  TRIBUNAL_FAILED = 2   /* the library gave up; so does any other number say */
};
#endif

/* Takes one triangle: indices of its corners, in either orientation. `sink` is what triangulate was given. */
typedef void (*tribunal_emit)(void* sink, uint32_t a, uint32_t b, uint32_t c);

typedef struct tribunal_triangulator {
  uint32_t version;    /* TRIBUNAL_PLUGIN_VERSION */
  const char* name;    /* short, as in a table: "quad-edge" */
  const char* cites;   /* author and year, or the library and its version; may be NULL */
  const char* summary; /* one line; may be NULL */

  /* Triangulates n >= 1 points x0, y0, x1, y1, ... with finite coordinates: calls emit once for each triangle
   * and returns how it ended. Must not write to the points, and leaves the floating-point environment as it
   * was. */
  int (*triangulate)(const double* points, size_t n, tribunal_emit emit, void* sink);
} tribunal_triangulator;

/* What the library defines. */
const tribunal_triangulator* tribunal_triangulator_entry(void);

#ifdef __cplusplus
}
#endif

#endif
