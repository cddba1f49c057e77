// The whole Gulf of Mexico, 98-80 W, 18-31 N, between its shores as GSHHG has them (Wessel and Smith 1996),
// at four resolutions: the sea as a domain, in the coordinates of `gulf`, islands as holes.
#include "datasets/external/external.hpp"
#include "datasets/external/shore.hpp"
#include "datasets/files/files.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#ifndef TRIBUNAL_GSHHG_FOLDER
#error "TRIBUNAL_GSHHG_FOLDER: where the files of GSHHG are, given by CMakeLists.txt"
#endif

namespace tribunal {
namespace {
using shores::Place;

struct Resolution {
  std::string_view name, file, package, summary;
  std::uint64_t size;    ///< points of the domain
  std::uint64_t digest;  ///< of the file in version 2.3.7, FNV-1a
};

constexpr Resolution low{.name = "gulf-low",
                         .file = "binned_GSHHS_l.nc",
                         .package = "gmt-gshhg-low",
                         .summary = "the whole Gulf of Mexico as a domain, from GSHHG: shores to 5 km",
                         .size = 1021,
                         .digest = 0xE20D9C82860E0A28};
constexpr Resolution intermediate{
    .name = "gulf-intermediate",
    .file = "binned_GSHHS_i.nc",
    .package = "gmt-gshhg-low",
    .summary = "the whole Gulf of Mexico as a domain, from GSHHG: shores to 1 km",
    .size = 7735,
    .digest = 0xA0E2B0C8436DB284};
constexpr Resolution high{.name = "gulf-high",
                          .file = "binned_GSHHS_h.nc",
                          .package = "gmt-gshhg-high",
                          .summary = "the whole Gulf of Mexico as a domain, from GSHHG: shores to 0.2 km",
                          .size = 38833,
                          .digest = 0x2E2000C376BAF29B};
constexpr Resolution full{
    .name = "gulf-full",
    .file = "binned_GSHHS_f.nc",
    .package = "gmt-gshhg-full",
    .summary = "the whole Gulf of Mexico as a domain, from GSHHG: the finest shores it has",
    .size = 254605,
    .digest = 0x6F8A23FDC0F3EC34};

std::filesystem::path path_of(const Resolution& resolution) {
  const char* folder = std::getenv("TRIBUNAL_GSHHG");
  return std::filesystem::path(folder != nullptr ? folder : TRIBUNAL_GSHHG_FOLDER) / resolution.file;
}

std::string missing(const Resolution& resolution) {
  if (!shores::reads_binned_shores())
    return "this program was built without libnetcdf: install libnetcdf-dev and " +
           std::string(resolution.package) + ", and build it again";
  const std::filesystem::path path = path_of(resolution);
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return "";
  return "there is no " + path.string() + ": install the package " + std::string(resolution.package);
}

/// Where `gulf` has its origin, and its scale to less than a step of its lattice, in binary fractions: every
/// place is exact, in 50 bits.
Point2 in_gulf(const Place& place) {
  constexpr double finer = 0x1p-33;  // 2^13 steps of the lattice between points of GSHHG, 2^20 of the factors
  constexpr Place origin{std::int64_t{17171308} << 13, std::int64_t{3213169} << 12};
  return {{static_cast<double>((place.x - origin.x) * 17831) * finer,
           static_cast<double>((place.y - origin.y) * 18625) * finer}};
}

/// Outlines as segments; what touches in a vertex shares it.
class Domain {
 public:
  void add(const std::vector<Place>& outline) {
    std::uint32_t before = index(outline.back());
    for (const Place& place : outline) {
      const std::uint32_t here = index(place);
      graph_.segments.push_back({before, here});
      before = here;
    }
  }
  void add_hole(const std::vector<Place>& island) {
    add(island);
    Point2 middle{{0, 0}};
    for (const Place& place : shores::around_inner_point(island)) {
      const Point2 p = in_gulf(place);
      middle = {{middle[0] + p[0] / 4, middle[1] + p[1] / 4}};
    }
    graph_.holes.push_back(middle);
  }
  DatasetGraph take() { return std::move(graph_); }

 private:
  std::uint32_t index(const Place& place) {
    const auto [found, fresh] = index_.emplace(place, static_cast<std::uint32_t>(graph_.points.size()));
    if (fresh) graph_.points.push_back(in_gulf(place));
    return found->second;
  }

  DatasetGraph graph_;
  std::map<Place, std::uint32_t> index_;
};

/// Another file would give other bytes for the same name, and a damaged one can bring libhdf5 down.
void require_digest(const std::filesystem::path& path, std::uint64_t expected) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> bytes(1 << 16);
  std::uint64_t digest = 0xCBF29CE484222325;
  while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), file.gcount() > 0)
    for (std::streamsize i = 0; i < file.gcount(); ++i)
      digest = (digest ^ static_cast<unsigned char>(bytes[i])) * 0x100000001B3;
  if (digest != expected) throw BadInput(path.string() + ": is not the file of that name in GSHHG 2.3.7");
}

DatasetGraph sea(const std::filesystem::path& path) {
  const shores::BinnedShores binned = shores::read_binned_shores(path);
  const shores::Window window = shores::window_of_degrees(360 - 98, 360 - 80, 18, 31);
  std::vector<shores::Shore> seen = cut(assemble(binned, window), window);
  remove_meeting_islands(seen);
  Domain domain;
  for (const auto& outline : close_along_border(seen, window)) domain.add(outline);
  for (const shores::Shore& shore : seen)
    if (shore.closed) domain.add_hole(shore.places);
  return domain.take();
}

template <const Resolution& resolution>
DatasetGraph graph(std::uint64_t, std::uint64_t) {
  if (const std::string reason = missing(resolution); !reason.empty())
    throw BadInput(std::string(resolution.name) + ": " + reason);
  const std::filesystem::path path = path_of(resolution);
  require_digest(path, resolution.digest);
  return sea(path);
}

template <const Resolution& resolution>
constexpr ExternalDataset entry() {
  return {
      .dataset = {.about = {.name = resolution.name,
                            .cites = "GSHHG 2.3.7, Wessel and Smith 1996; read from this system, not shipped",
                            .summary = resolution.summary,
                            .fixed_size = resolution.size,
                            .integer = false},
                  .generate =
                      [](std::uint64_t n, std::uint64_t seed) {
                        std::vector<Point2> points = graph<resolution>(n, seed).points;
                        points.resize(std::min<std::size_t>(n, points.size()));
                        return points;
                      },
                  .graph = graph<resolution>},
      .missing = [] { return missing(resolution); }};
}

constinit const ExternalDataset all[]{entry<low>(), entry<intermediate>(), entry<high>(), entry<full>()};

}  // namespace

std::span<const ExternalDataset> external_datasets() { return all; }

std::string missing_for(std::string_view dataset) {
  for (const ExternalDataset& external : external_datasets())
    if (external.dataset.about.name == dataset) return external.missing();
  return "";
}

}  // namespace tribunal
