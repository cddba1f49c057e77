#include "datasets/external/binned_shores.hpp"

#include "datasets/files/files.hpp"

#ifdef TRIBUNAL_NETCDF
#include <netcdf.h>
#endif

namespace tribunal::shores {

std::string contradiction(const BinnedShores& shores) {
  const std::int64_t degrees = shores.bin_degrees;
  if (degrees < 1 || 180 % degrees != 0) return "its bins are not a whole part of 180 degrees";
  if (static_cast<std::int64_t>(shores.bins.size()) != (360 / degrees) * (180 / degrees))
    return "its bins do not cover the world";
  const auto lie_in = [](std::int64_t first, std::int64_t count, std::size_t size) {
    return first >= 0 && count >= 0 && first + count <= static_cast<std::int64_t>(size);
  };
  for (const auto& [first, count] : shores.bins)
    if (count != 0 && !lie_in(first, count, shores.pieces.size()))
      return "a bin has pieces that the file has not";
  if (shores.east.size() != shores.north.size()) return "longitudes and latitudes differ in number";
  for (const BinnedShores::Piece& piece : shores.pieces) {
    if (piece.size() == 0) return "a piece has no points";
    if (!lie_in(piece.first_point, piece.size(), shores.east.size()))
      return "a piece has points that the file has not";
    if (piece.entry() > 4 || piece.exit() > 4 || (piece.entry() == 4) != (piece.exit() == 4))
      return "a piece enters or leaves a bin by no side";
  }
  return "";
}

#ifdef TRIBUNAL_NETCDF
namespace {

constexpr std::size_t most_values = 1U << 24;  // of a variable; the largest has eleven million

/// An open file of NetCDF, for as long as it lives.
class NetCdf {
 public:
  explicit NetCdf(const std::filesystem::path& path) : path_(path.string()) {
    check(nc_open(path_.c_str(), NC_NOWRITE, &id_), "");
  }
  ~NetCdf() { nc_close(id_); }
  NetCdf(const NetCdf&) = delete;
  NetCdf& operator=(const NetCdf&) = delete;

  [[noreturn]] void fail(const std::string& reason) const { throw BadInput(path_ + ": " + reason); }

  std::vector<int> integers(const char* name) const { return values<int>(name, nc_get_var_int); }
  std::vector<short> shorts(const char* name) const { return values<short>(name, nc_get_var_short); }

 private:
  void check(int status, const std::string& name) const {
    if (status != NC_NOERR) fail((name.empty() ? name : name + ": ") + nc_strerror(status));
  }
  template <class T>
  std::vector<T> values(const char* name, int (*get)(int, int, T*)) const {
    int variable = 0, dimensions = 0, dimension = 0;
    std::size_t size = 0;
    check(nc_inq_varid(id_, name, &variable), name);
    check(nc_inq_varndims(id_, variable, &dimensions), name);
    if (dimensions != 1) fail(std::string(name) + " is not a list");
    check(nc_inq_vardimid(id_, variable, &dimension), name);
    check(nc_inq_dimlen(id_, dimension, &size), name);
    if (size > most_values) fail(std::string(name) + " is too long");
    std::vector<T> values(size);
    if (size > 0) check(get(id_, variable, values.data()), name);
    return values;
  }

  std::string path_;
  int id_ = 0;
};

std::vector<std::uint16_t> unsigned_shorts(const NetCdf& file, const char* name) {
  const std::vector<short> values = file.shorts(name);
  return {values.begin(), values.end()};
}

void read_bins(const NetCdf& file, BinnedShores& shores) {
  const std::vector<int> minutes = file.integers("Bin_size_in_minutes");
  if (minutes.size() != 1 || minutes[0] % 60 != 0) file.fail("its bins are not of whole degrees");
  shores.bin_degrees = minutes[0] / 60;
  const auto first = file.integers("Id_of_first_segment_in_a_bin");
  const auto count = file.shorts("N_segments_in_a_bin");
  if (first.size() != count.size()) file.fail("its lists of bins differ in length");
  for (std::size_t i = 0; i < first.size(); ++i)
    shores.bins.push_back({first[i], static_cast<std::uint16_t>(count[i])});
}

void read_pieces(const NetCdf& file, BinnedShores& shores) {
  const auto codes = file.integers("Embedded_npts_levels_exit_entry_for_a_segment");
  const auto first = file.integers("Id_of_first_point_in_a_segment");
  const auto polygons = file.integers("Id_of_GSHHS_ID");
  if (codes.size() != first.size() || codes.size() != polygons.size())
    file.fail("its lists of segments differ in length");
  for (std::size_t i = 0; i < codes.size(); ++i)
    shores.pieces.push_back({static_cast<std::uint32_t>(codes[i]), first[i], polygons[i]});
}

}  // namespace

bool reads_binned_shores() { return true; }

BinnedShores read_binned_shores(const std::filesystem::path& path) {
  const NetCdf file(path);
  BinnedShores shores;
  read_bins(file, shores);
  read_pieces(file, shores);
  shores.east = unsigned_shorts(file, "Relative_longitude_from_SW_corner_of_bin");
  shores.north = unsigned_shorts(file, "Relative_latitude_from_SW_corner_of_bin");
  if (const std::string wrong = contradiction(shores); !wrong.empty()) file.fail(wrong);
  return shores;
}

#else

bool reads_binned_shores() { return false; }

BinnedShores read_binned_shores(const std::filesystem::path& path) {
  throw BadInput(path.string() + ": this program was built without libnetcdf, which reads it");
}

#endif

}  // namespace tribunal::shores
