#include "datasets/queries/families.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace tribunal {

std::span<const QueryFamily> query_families() {
  static const std::array all{
#define QUERY_FAMILY(name) queries::name,
#include "datasets/queries/list.def"
#undef QUERY_FAMILY
  };
  return all;
}

const QueryFamily* find_query_family(std::string_view name) {
  const auto all = query_families();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const QueryFamily& f) { return f.name == name; });
  return found == all.end() ? nullptr : &*found;
}

namespace {
template <int D>
std::vector<Point<D>> draw_queries(void (*draw)(Predicate, Random&, std::span<Point<D>>), Predicate predicate,
                                   std::size_t count, std::uint64_t seed) {
  assert(dimension_of(predicate) == D);
  const auto points_each = static_cast<std::size_t>(points_of(predicate));
  Random random(seed);
  std::vector<Point<D>> points(count * points_each);
  for (std::size_t i = 0; i < count; ++i)
    draw(predicate, random, std::span(points).subspan(i * points_each, points_each));
  return points;
}
}  // namespace

std::vector<Point2> draw_queries2(const QueryFamily& family, Predicate predicate, std::size_t count,
                                  std::uint64_t seed) {
  return draw_queries<2>(family.draw2, predicate, count, seed);
}

std::vector<Point3> draw_queries3(const QueryFamily& family, Predicate predicate, std::size_t count,
                                  std::uint64_t seed) {
  return draw_queries<3>(family.draw3, predicate, count, seed);
}

}  // namespace tribunal
