// Shores cut at bins come together again, and the sea that they bound is what is not land.
#include "datasets/external/shore.hpp"
#include "datasets/files/files.hpp"
#include "datasets/random.hpp"
#include "tests/datasets/support.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#ifdef TRIBUNAL_NETCDF
#include <netcdf.h>
#endif

namespace tribunal::shores {
namespace {

constexpr std::int64_t side = 65535;  // of a bin, in its own points
constexpr std::int64_t degrees = 10;  // of a bin
constexpr std::int64_t step =
    degrees * steps_per_degree / side;  // of a bin's points, on the lattice of places

/// A world of bins of ten degrees, to which polygons are added: what a maker of such files does, in one's own
/// words. Points are counted from (0 E, 90 S); edges cross the borders of bins at right angles.
class World {
 public:
  World() {
    binned_.bin_degrees = degrees;
    in_bin_.resize(36 * 18);
  }

  /// Counter-clockwise, land inside.
  void add(std::vector<std::array<std::int64_t, 2>> polygon) {
    const auto with_borders = split(polygon);
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < with_borders.size(); ++i)
      if (on_border(with_borders[i])) starts.push_back(i);
    if (starts.empty()) {
      auto closed = with_borders;
      closed.push_back(closed.front());
      put(closed, 4, 4);
    }
    for (std::size_t s = 0; s < starts.size(); ++s) {
      std::vector<std::array<std::int64_t, 2>> piece;
      const std::size_t last = starts[(s + 1) % starts.size()];
      for (std::size_t i = starts[s];; i = (i + 1) % with_borders.size()) {
        piece.push_back(with_borders[i]);
        if (i == last && piece.size() > 1) break;
      }
      put(piece, side_of(piece[0], piece[1]), side_of(piece.back(), piece[piece.size() - 2]));
    }
    ++polygon_;
  }

  BinnedShores binned(std::uint32_t level = 1) const {
    BinnedShores all = binned_;
    for (const auto& pieces : in_bin_) {
      all.bins.push_back(
          {static_cast<std::int32_t>(all.pieces.size()), static_cast<std::int32_t>(pieces.size())});
      for (const auto& [polygon, entry, exit, points] : pieces) {
        all.pieces.push_back({static_cast<std::uint32_t>(points.size() << 9) | level << 6 | entry << 3 | exit,
                              static_cast<std::int32_t>(all.east.size()), polygon});
        for (const auto& [x, y] : points) {
          all.east.push_back(static_cast<std::uint16_t>(x));
          all.north.push_back(static_cast<std::uint16_t>(y));
        }
      }
    }
    return all;
  }

 private:
  using Point = std::array<std::int64_t, 2>;
  struct Put {
    std::int32_t polygon;
    std::uint32_t entry, exit;
    std::vector<Point> points;
  };

  static bool on_border(const Point& p) { return p[0] % side == 0 || p[1] % side == 0; }

  static std::vector<Point> split(const std::vector<Point>& polygon) {
    std::vector<Point> all;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point p = polygon[i], q = polygon[(i + 1) % polygon.size()];
      all.push_back(p);
      for (const int axis : {0, 1}) {
        if (p[1 - axis] != q[1 - axis]) continue;
        const std::int64_t sign = p[axis] < q[axis] ? 1 : -1;
        for (std::int64_t c = p[axis] + sign; c != q[axis]; c += sign) {
          if (c % side != 0) continue;
          Point crossing = p;
          crossing[axis] = c;
          all.push_back(crossing);
        }
      }
    }
    return all;
  }

  /// South, east, north or west: where `end` lies on the border of the bin that `next` is in.
  static std::uint32_t side_of(const Point& end, const Point& next) {
    if (end[1] == next[1]) return end[0] < next[0] ? 3 : 1;
    return end[1] < next[1] ? 0 : 2;
  }

  void put(std::vector<Point> points, std::uint32_t entry, std::uint32_t exit) {
    // Twice the middle of the first edge is in the bin.
    const std::int64_t column = (points[0][0] + points[1][0]) / (2 * side),
                       row = (points[0][1] + points[1][1]) / (2 * side);
    for (Point& p : points) p = {p[0] - column * side, p[1] - row * side};
    in_bin_[static_cast<std::size_t>((17 - row) * 36 + column)].push_back({polygon_, entry, exit, points});
  }

  BinnedShores binned_;
  std::vector<std::vector<Put>> in_bin_;
  std::int32_t polygon_ = 0;
};

std::vector<std::array<std::int64_t, 2>> box(std::int64_t west, std::int64_t east, std::int64_t south,
                                             std::int64_t north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

Place place(std::int64_t x, std::int64_t y) { return {x * step, y * step - 90 * steps_per_degree}; }

Wide doubled_area(const std::vector<Place>& polygon) {
  Wide area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    area += Wide{p.x} * q.y - Wide{q.x} * p.y;
  }
  return area;
}

bool encloses(const std::vector<Place>& polygon, const Place& p) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Place a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (a.y > b.y) std::swap(a, b);
    odd ^= turn(a, b, p) > 0;
  }
  return odd;
}

std::string reason_of(const auto& run) {
  try {
    run();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

const Window everything = window_of_degrees(1, 359, -89, 89);

TEST(Shores, AnIslandAcrossBinsIsOneRing) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));           // two bins
  world.add(box(4 * side - 100, 4 * side + 100, 9 * side - 30, 9 * side + 30));  // four, around their corner
  world.add(box(7 * side - 9, 10 * side + 9, 8 * side - 9, 11 * side + 9));      // sixteen
  world.add(box(3 * side + 100, 3 * side + 200, 9 * side + 7, 9 * side + 50));   // one
  const auto shores = assemble(world.binned(), everything);
  ASSERT_EQ(shores.size(), 4U);
  std::map<std::int32_t, Wide> areas;
  for (const Shore& shore : shores) {
    EXPECT_TRUE(shore.closed);
    areas[shore.polygon] = doubled_area(shore.places) / (Wide{2} * step * step);
  }
  EXPECT_TRUE(areas[0] == 300 * 43 && areas[1] == 200 * 60 && areas[3] == 100 * 43);
  EXPECT_TRUE(areas[2] == Wide{3 * side + 18} * (3 * side + 18));
}

TEST(Shores, OnlyThoseOfTheSeaCount) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  EXPECT_TRUE(assemble(world.binned(2), everything).empty());
}

TEST(Shores, ARingOfTwoPointsIsNoIsland) {
  World world;
  world.add({{100, 100}, {200, 100}});
  EXPECT_TRUE(assemble(world.binned(), everything).empty());
}

/// Random boxes that keep apart, seen through a window that cuts many: the outlines and islands enclose, by
/// even and odd, just what no box covers.
TEST(Shores, WhatTheyEncloseIsTheSea) {
  Random random(5);
  std::size_t cuts = 0;
  for (int round = 0; round < 60; ++round) {
    World world;
    std::vector<std::vector<Place>> lands;
    std::vector<std::array<std::int64_t, 4>> boxes;
    for (int attempt = 0; attempt < 60; ++attempt) {
      const auto coordinate = [&](std::int64_t from, std::uint64_t range) {
        const std::int64_t c = from + static_cast<std::int64_t>(random.below(range));
        return c % side == 0 ? c + 1 : c;
      };
      const std::int64_t west = coordinate(5 * side, 6 * side), south = coordinate(5 * side, 6 * side),
                         east = coordinate(west + 2, 2 * side), north = coordinate(south + 2, 2 * side);
      const bool free = std::ranges::none_of(boxes, [&](const auto& b) {
        return west <= b[1] && b[0] <= east && south <= b[3] && b[2] <= north;
      });
      if (!free) continue;
      boxes.push_back({west, east, south, north});
      world.add(box(west, east, south, north));
      lands.push_back({place(west, south), place(east, south), place(east, north), place(west, north)});
    }
    const Window window = window_of_degrees(65, 105, -25, 15);
    std::vector<Shore> seen = cut(assemble(world.binned(), window), window);
    EXPECT_EQ(remove_meeting_islands(seen), 0U);
    auto outlines = close_along_border(seen, window);
    for (const auto& outline : outlines) EXPECT_TRUE(doubled_area(outline) > 0);
    for (const Shore& shore : seen) {
      if (shore.closed) outlines.push_back(shore.places);
      cuts += !shore.closed;
    }
    for (int i = 0; i < 300; ++i) {
      const auto within = [&](std::int64_t low, std::int64_t high) {
        return low + 1 +
               2 * static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(high - low) / 2));
      };
      const Place p{within(window.low.x, window.high.x), within(window.low.y, window.high.y)};
      const auto holds = [&](const auto& polygon) { return encloses(polygon, p); };
      ASSERT_EQ(std::ranges::count_if(outlines, holds) % 2 == 1, std::ranges::none_of(lands, holds)) << round;
    }
  }
  EXPECT_GT(cuts, 300U);
}

TEST(Shores, SlantingCutsLieOnTheBorderAndBesideTheEdge) {
  const Window window = window_of_degrees(10, 20, 0, 10);
  // A triangle that covers the corner in the south-west, in thirds that no lattice has.
  const std::int64_t d = steps_per_degree;
  const Shore land{0, true, {{9 * d, -d}, {17 * d, -d}, {9 * d, 2 * d}}};
  const auto seen = cut({land}, window);
  ASSERT_EQ(seen.size(), 1U);
  ASSERT_EQ(seen[0].places.size(), 2U);
  const auto [enters, leaves] = std::array{seen[0].places[0], seen[0].places[1]};
  EXPECT_EQ(enters.y, window.low.y);
  EXPECT_EQ(leaves.x, window.low.x);
  // Half a step off at most: twice the distance along the border times the other side.
  const auto off = [&](const Place& p) {
    const Wide twice = Wide{-8 * d} * (p.y + d) - Wide{3 * d} * (p.x - 17 * d);
    return twice < 0 ? -twice : twice;
  };
  EXPECT_TRUE(2 * off(enters) <= Wide{3 * d} && 2 * off(leaves) <= Wide{8 * d});
  const auto outlines = close_along_border(seen, window);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(outlines[0].size(), 5U);
  EXPECT_TRUE(doubled_area(outlines[0]) > 0);
}

TEST(Shores, AnEdgeMayCrossTheWholeWindow) {
  const Window window = window_of_degrees(10, 20, 0, 10);
  const std::int64_t d = steps_per_degree;
  const auto seen =
      cut({{0, true, {{12 * d, -d}, {14 * d, -d}, {14 * d, 11 * d}, {12 * d, 11 * d}}}}, window);
  EXPECT_EQ(seen.size(), 2U);
  EXPECT_EQ(close_along_border(seen, window).size(), 2U);
}

TEST(Shores, OneThatEndsInTheSeaIsRefused) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  BinnedShores binned = world.binned();
  for (BinnedShores::Piece& piece : binned.pieces)
    if (piece.entry() == 3) piece.code += 1 << 6;  // to another level
  EXPECT_EQ(reason_of([&] { cut(assemble(binned, everything), everything); }),
            "a shore ends in the sea at 10 degrees east, 0 north");
}

TEST(Shores, ThoseThatBeginInOnePlaceAreRefused) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  BinnedShores binned = world.binned();
  binned.pieces[0].polygon = binned.pieces[1].polygon;
  binned.pieces.push_back(binned.pieces[0]);
  for (auto& bin : binned.bins)
    if (bin.pieces > 0) bin = {0, static_cast<std::int32_t>(binned.pieces.size())};
  EXPECT_NE(reason_of([&] { assemble(binned, everything); }).find("in one place"), std::string::npos);
}

Shore island(std::int32_t polygon, std::vector<Place> places) { return {polygon, true, std::move(places)}; }

TEST(MeetingIslands, GoTheSmallerFirst) {
  const Shore large = island(1, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const std::vector<std::pair<std::vector<Place>, std::size_t>> cases{
      {{{10, 5}, {15, 3}, {15, 8}}, 1},             // a vertex on an edge
      {{{5, 5}, {15, 3}, {15, 8}}, 1},              // crossing
      {{{10, 2}, {15, 2}, {15, 8}, {10, 8}}, 1},    // an edge along an edge
      {{{10, 0}, {15, 0}, {10, 10}}, 1},            // the same edge
      {{{10, 10}, {15, 10}, {15, 15}}, 0},          // one vertex
      {{{11, 0}, {15, 0}, {11, 10}}, 0},            // near
      {{{20, 0}, {30, 0}, {20, 10}, {30, 10}}, 1},  // itself
      {{{20, 0}, {30, 0}, {25, 0}, {25, 9}}, 1},    // itself, by a spike
  };
  for (const auto& [places, removed] : cases) {
    std::vector<Shore> shores{island(2, places), large};
    EXPECT_EQ(remove_meeting_islands(shores), removed);
    ASSERT_EQ(shores.size(), 2 - removed);
    EXPECT_EQ(shores.back().polygon, 1);
  }
}

TEST(MeetingIslands, SparesWhatGoesThroughTheWindow) {
  const Shore main{9, false, {{0, 0}, {10, 0}, {20, 0}}};
  std::vector<Shore> shores{main, island(3, {{5, -5}, {6, -5}, {6, 5}})};
  EXPECT_EQ(remove_meeting_islands(shores), 1U);
  EXPECT_EQ(shores[0].polygon, 9);
  std::vector<Shore> both{main, {8, false, {{5, -5}, {5, 5}}}};
  EXPECT_NE(reason_of([&] { remove_meeting_islands(both); }), "");
}

TEST(InnerPoints, AreInside) {
  Random random(11);
  int tried = 0;
  for (int round = 0; round < 400; ++round) {
    // A comb: x grows along the teeth and comes back along a line below them all.
    std::vector<Place> polygon;
    const auto teeth = static_cast<std::int64_t>(1 + random.below(9));
    for (std::int64_t x = 0; x < 3 * teeth; ++x)
      polygon.push_back({x + static_cast<std::int64_t>(random.below(2)) * (x % 3 == 1),
                         static_cast<std::int64_t>(random.below(60))});
    polygon.push_back({3 * teeth, -1});
    polygon.push_back(
        {-static_cast<std::int64_t>(random.below(3)), -1 - static_cast<std::int64_t>(random.below(3))});
    std::vector<Shore> simple{island(1, polygon)};
    if (remove_meeting_islands(simple) != 0) continue;
    ++tried;
    for (const bool mirrored : {false, true}) {
      std::vector<Place> turned = polygon;
      if (mirrored)
        for (Place& p : turned) p = {-p.y, -p.x};
      Place middle{0, 0};
      for (const Place& p : around_inner_point(turned)) middle = {middle.x + p.x, middle.y + p.y};
      for (Place& p : turned) p = {4 * p.x, 4 * p.y};
      ASSERT_TRUE(encloses(turned, middle)) << round;
      for (std::size_t i = 0; i < turned.size(); ++i) {
        const Place &a = turned[i], &b = turned[(i + 1) % turned.size()];
        ASSERT_FALSE(turn(a, b, middle) == 0 && std::min(a, b) <= middle && middle <= std::max(a, b))
            << round;
      }
    }
  }
  EXPECT_GT(tried, 100);
}

TEST(BinnedShores, ContradictionsAreFound) {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  const BinnedShores good = world.binned();
  EXPECT_EQ(contradiction(good), "");
  const auto wrong = [&](auto change) {
    BinnedShores bad = good;
    change(bad);
    return contradiction(bad);
  };
  EXPECT_NE(wrong([](auto& b) { b.bin_degrees = 7; }), "");
  EXPECT_NE(wrong([](auto& b) { b.bins.pop_back(); }), "");
  EXPECT_NE(wrong([](auto& b) { b.bins[0] = {2, 1}; }), "");
  EXPECT_NE(wrong([](auto& b) { b.bins[0] = {-1, 1}; }), "");
  EXPECT_NE(wrong([](auto& b) { b.north.pop_back(); }), "");
  EXPECT_NE(wrong([](auto& b) { b.pieces[0].first_point = -1; }), "");
  EXPECT_NE(wrong([](auto& b) { b.pieces[0].first_point = 1 << 30; }), "");
  EXPECT_NE(wrong([](auto& b) { b.pieces[0].code &= 511; }), "");
  EXPECT_NE(wrong([](auto& b) { b.pieces[0].code |= 7; }), "");
  EXPECT_NE(wrong([](auto& b) { b.pieces[0].code = (b.pieces[0].code & ~63U) | 4; }), "");
}

#ifdef TRIBUNAL_NETCDF

/// Writes them as the Generic Mapping Tools would, but for what is not read.
void write(const BinnedShores& shores, const std::filesystem::path& path) {
  int file = 0;
  const auto check = [](int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
  };
  check(nc_create(path.c_str(), NC_CLOBBER, &file));
  const auto define = [&](const char* name, nc_type type, std::size_t size) {
    int dimension = 0, variable = 0;
    check(nc_def_dim(file, (std::string("of_") + name).c_str(), size, &dimension));
    check(nc_def_var(file, name, type, 1, &dimension, &variable));
    return variable;
  };
  std::vector<int> first, codes, starts, polygons;
  std::vector<short> counts;
  for (const auto& bin : shores.bins)
    first.push_back(bin.first_piece), counts.push_back(static_cast<short>(bin.pieces));
  for (const auto& piece : shores.pieces)
    codes.push_back(static_cast<int>(piece.code)), starts.push_back(piece.first_point),
        polygons.push_back(piece.polygon);
  const std::vector<short> east(shores.east.begin(), shores.east.end()),
      north(shores.north.begin(), shores.north.end());
  const int minutes = 60 * shores.bin_degrees;
  const std::array variables{define("Bin_size_in_minutes", NC_INT, 1),
                             define("Id_of_first_segment_in_a_bin", NC_INT, first.size()),
                             define("N_segments_in_a_bin", NC_SHORT, counts.size()),
                             define("Embedded_npts_levels_exit_entry_for_a_segment", NC_INT, codes.size()),
                             define("Id_of_first_point_in_a_segment", NC_INT, starts.size()),
                             define("Id_of_GSHHS_ID", NC_INT, polygons.size()),
                             define("Relative_longitude_from_SW_corner_of_bin", NC_SHORT, east.size()),
                             define("Relative_latitude_from_SW_corner_of_bin", NC_SHORT, north.size())};
  check(nc_enddef(file));
  check(nc_put_var_int(file, variables[0], &minutes));
  check(nc_put_var_int(file, variables[1], first.data()));
  check(nc_put_var_short(file, variables[2], counts.data()));
  check(nc_put_var_int(file, variables[3], codes.data()));
  check(nc_put_var_int(file, variables[4], starts.data()));
  check(nc_put_var_int(file, variables[5], polygons.data()));
  check(nc_put_var_short(file, variables[6], east.data()));
  check(nc_put_var_short(file, variables[7], north.data()));
  check(nc_close(file));
}

BinnedShores two_islands() {
  World world;
  world.add(box(side - 100, side + 200, 9 * side + 7, 9 * side + 50));
  world.add(box(3 * side + 40000, 3 * side + 65000, 9 * side + 7, 9 * side + 50000));  // beyond 15 bits
  return world.binned();
}

TEST(NetCdf, IslandsAreReadBackAndJoined) {
  const test::Folder folder;
  write(two_islands(), folder / "a.nc");
  const BinnedShores read = read_binned_shores(folder / "a.nc");
  const auto written = assemble(two_islands(), everything), found = assemble(read, everything);
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(found[i].closed);
    EXPECT_EQ(found[i].places, written[i].places);
  }
}

TEST(NetCdf, OtherFilesAreRefusedInOneLine) {
  const test::Folder folder;
  const auto refused = [&](const std::filesystem::path& path) {
    const std::string text = reason_of([&] { read_binned_shores(path); });
    EXPECT_TRUE(text.starts_with(path.string() + ": ")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  };
  refused(folder / "none.nc");
  refused(folder.write("empty.nc", ""));
  refused(folder.write("text.nc", "0 0\n1 1\n"));
  refused(folder.write("hdf.nc", "\x89HDF\r\n\x1a\n and no more"));
  int file = 0;
  ASSERT_EQ(nc_create((folder / "bare.nc").c_str(), NC_CLOBBER, &file), NC_NOERR);
  ASSERT_EQ(nc_close(file), NC_NOERR);
  refused(folder / "bare.nc");
}

/// Cut short or with bytes changed, a file is refused or read as something that does not contradict itself.
TEST(NetCdf, DamagedFilesAreNoDanger) {
  const test::Folder folder;
  write(two_islands(), folder / "a.nc");
  const std::string whole = folder.read("a.nc");
  Random random(3);
  const std::size_t header = std::min<std::size_t>(whole.size(), 1200);
  std::size_t refused = 0;
  for (int round = 0; round < 100; ++round) {
    std::string bytes = whole;
    if (round % 4 == 0)
      bytes.resize(random.below(bytes.size()));
    else
      for (int change = 0; change < 1 + round % 3; ++change)
        bytes[random.below(round % 2 ? header : bytes.size())] = static_cast<char>(random.below(256));
    const auto path = folder.write("b.nc", bytes);
    const std::string text = reason_of([&] {
      const BinnedShores read = read_binned_shores(path);
      EXPECT_EQ(contradiction(read), "");
      std::vector<Shore> seen = cut(assemble(read, everything), everything);
      remove_meeting_islands(seen);
      close_along_border(seen, everything);
    });
    refused += !text.empty();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
  EXPECT_GT(refused, 25U);
}

TEST(NetCdf, IsReadHere) { EXPECT_TRUE(reads_binned_shores()); }

#else

TEST(NetCdf, IsMissedWhereItIsNotBuiltIn) {
  EXPECT_FALSE(reads_binned_shores());
  EXPECT_NE(reason_of([] { read_binned_shores("a.nc"); }).find("libnetcdf"), std::string::npos);
}

#endif

}  // namespace
}  // namespace tribunal::shores
