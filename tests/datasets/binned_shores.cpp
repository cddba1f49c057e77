// Files of binned shores are read back as they were written; what contradicts itself is refused.
#include "tests/datasets/shore_world.hpp"
#include "tests/datasets/support.hpp"

#ifdef TRIBUNAL_NETCDF
#include "datasets/random.hpp"

#include <netcdf.h>
#endif

namespace tribunal::shores {
namespace {

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
