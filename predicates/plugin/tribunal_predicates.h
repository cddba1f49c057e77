/* Geometric predicates as a plug-in: what a shared library offers so that `tribunal try --plugin` can put it
 * on trial. Copy this header; nothing else is needed.
 *
 * The library defines one function with C linkage,
 *
 *     const tribunal_predicates* tribunal_predicates_entry(void);
 *
 * which returns a structure that lives as long as the library. Members that are not offered are NULL; at
 * least one of the four predicates must be there. A library may also define tribunal_triangulator_entry
 * (tribunal_triangulator.h).
 *
 * A predicate returns the sign of a determinant: any positive number, any negative number or zero. For points
 * a = (a[0], a[1]) or (a[0], a[1], a[2]):
 *
 *   orient2d(a, b, c): det(b-a, c-a). Positive when a, b, c turn counter-clockwise.
 *
 *   incircle(a, b, c, d): positive when d is strictly inside the circle through the counter-clockwise
 *   a, b, c; exchanging two of a, b, c changes the sign.
 *
 *   orient3d(a, b, c, d): det(b-a, c-a, d-a). Positive for (0,0,0), (1,0,0), (0,1,0), (0,0,1). The sign of
 *   CGAL::orientation; the opposite of Shewchuk's orient3d.
 *
 *   insphere(a, b, c, d, e): positive when e is strictly inside the sphere through a, b, c, d with
 *   orient3d > 0; exchanging two of a, b, c, d changes the sign. The sign of
 *   CGAL::side_of_oriented_sphere, and of Shewchuk's insphere times -1.
 *
 * Coordinates are finite doubles of any magnitude unless bind says otherwise. Functions are called in the
 * default floating-point environment (rounding to nearest, subnormals on) and must leave it so. They must not
 * write to the points, print, or call back; several threads may be in them at once.
 */
#ifndef TRIBUNAL_PREDICATES_H
#define TRIBUNAL_PREDICATES_H

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

typedef struct tribunal_predicates {
  uint32_t version;    /* TRIBUNAL_PLUGIN_VERSION */
  const char* name;    /* short, as in a table: "adaptive" */
  const char* cites;   /* author and year, or the library and its version; may be NULL */
  const char* summary; /* one line; may be NULL */

  /* Optional. Called before the predicates with all the points they will be asked about: n points of
   * `dimension` (2 or 3) coordinates each, one after the other, which live until bind returns. Returns a
   * context that is handed to every query, NULL included. To refuse the points, sets *refused, which is n
   * when bind is called, to the index of the first point outside its domain; the value returned is then
   * ignored. Without bind all finite points are accepted and the context is NULL. */
  void* (*bind)(const double* points, size_t n, int dimension, size_t* refused);
  /* Optional: frees what bind returned. */
  void (*release)(void* context);

  int (*orient2d)(const void* context, const double* a, const double* b, const double* c);
  int (*incircle)(const void* context, const double* a, const double* b, const double* c, const double* d);
  int (*orient3d)(const void* context, const double* a, const double* b, const double* c, const double* d);
  int (*insphere)(const void* context, const double* a, const double* b, const double* c, const double* d,
                  const double* e);

  /* Optional: the signs of `count` queries in one call, as -1, 0 or 1, the same as one by one. The
   * coordinates of a query's points stand one after the other, and so do the queries. Only where the
   * predicate itself is offered. */
  void (*orient2d_batch)(const void* context, const double* coordinates, size_t count, int8_t* signs);
  void (*incircle_batch)(const void* context, const double* coordinates, size_t count, int8_t* signs);
  void (*orient3d_batch)(const void* context, const double* coordinates, size_t count, int8_t* signs);
  void (*insphere_batch)(const void* context, const double* coordinates, size_t count, int8_t* signs);
} tribunal_predicates;

/* What the library defines. */
const tribunal_predicates* tribunal_predicates_entry(void);

#ifdef __cplusplus
}
#endif

#endif
