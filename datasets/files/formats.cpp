#include "datasets/files/format.hpp"
#include "datasets/files/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace tribunal {
namespace {
using files::Format;
using Member = bool (*)(const Format&);

const std::array all{&files::xy,  &files::xyz,  &files::csv,     &files::node, &files::ele,
                     &files::off, &files::poly, &files::geojson, &files::wkt};

/// The format of the path's ending; refuses when there is none or it does not hold such things.
const Format& format_of(const std::filesystem::path& path, const Format& piped, std::string_view things,
                        Member holds) {
  if (path == "-") return piped;
  const std::string ending = ending_of(path);
  std::string known;
  for (const Format* format : all) {
    if (!holds(*format)) continue;
    if (format->about.name == ending) return *format;
    known.append(" ").append(format->about.name);
  }
  throw BadInput(name_of(path) + ": no format for " + std::string(things) + " has the ending " +
                 in_quotes(ending) + ", there are" + known);
}

const Format& mesh_format(const std::filesystem::path& path) {
  return format_of(path, files::off, "meshes", [](const Format& f) { return f.write_mesh != nullptr; });
}

/// A mesh and, where its points are a file beside it, those and the boundary, if there is one.
void write_with_beside(const std::filesystem::path& path, std::span<const Point2> points,
                       std::span<const files::Triangle> triangles, const PolyBoundary* boundary) {
  const Format& format = mesh_format(path);
  const std::string mesh = format.write_mesh(points, triangles);
  if (format.points_beside == nullptr) return write_text(path, mesh);
  const std::string sites = format.points_beside->write_points(points),
                    poly = boundary != nullptr ? files::poly_text(*boundary) : "";
  std::vector<TextFile> together{{mesh_files(path)[1], sites}, {path, mesh}};
  if (boundary != nullptr) together.push_back({poly_beside(path), poly});
  write_texts(together);
}
}  // namespace

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

PointFile read_points(const std::filesystem::path& path) {
  const Format& format = format_of(path, files::xy, "points", [](const Format& f) {
    return f.read_points != nullptr || f.read_pslg != nullptr;
  });
  const std::string text = read_text(path);
  if (format.read_pslg != nullptr) return format.read_pslg(path, text).sites;
  Scanner scanner(name_of(path), text, format.separator);
  return format.read_points(scanner);
}

std::optional<PslgFile> read_pslg(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  const auto format = std::ranges::find_if(
      all, [&](const Format* f) { return f->read_pslg != nullptr && f->about.name == ending; });
  if (path == "-" || format == all.end()) return std::nullopt;
  return (*format)->read_pslg(path, read_text(path));
}

MeshFile read_mesh(const std::filesystem::path& path, std::uint64_t sites) {
  const Format& format =
      format_of(path, files::off, "meshes", [](const Format& f) { return f.read_mesh != nullptr; });
  const std::string text = read_text(path);
  Scanner scanner(name_of(path), text, format.separator);
  return format.read_mesh(scanner, sites);
}

void write_points(const std::filesystem::path& path, std::span<const Point2> points) {
  const Format& format =
      format_of(path, files::xy, "points", [](const Format& f) { return f.write_points != nullptr; });
  write_text(path, format.write_points(points));
}

std::vector<std::filesystem::path> mesh_files(const std::filesystem::path& path) {
  std::vector<std::filesystem::path> files{path};
  if (const Format* beside = mesh_format(path).points_beside)
    files.push_back(std::filesystem::path(path).replace_extension(beside->about.name));
  return files;
}

void write_mesh(const std::filesystem::path& path, std::span<const Point2> points,
                std::span<const std::array<std::uint32_t, 3>> triangles) {
  write_with_beside(path, points, triangles, nullptr);
}

void write_poly(const std::filesystem::path& path, std::span<const Point2> points,
                const PolyBoundary& boundary) {
  const std::string sites = files::node.write_points(points), text = files::poly_text(boundary);
  const auto node = std::filesystem::path(path).replace_extension(files::node.about.name);
  write_texts(std::array{TextFile{node, sites}, TextFile{path, text}});
}

std::filesystem::path poly_beside(const std::filesystem::path& mesh) {
  return std::filesystem::path(mesh).replace_extension(files::poly.about.name);
}

void write_bounded_mesh(const std::filesystem::path& path, std::span<const Point2> points,
                        std::span<const std::array<std::uint32_t, 3>> triangles,
                        const PolyBoundary& boundary) {
  write_with_beside(path, points, triangles, &boundary);
}

std::span<const FormatAbout> formats() {
  static const auto abouts = [] {
    std::array<FormatAbout, all.size()> about{};
    std::ranges::transform(all, about.begin(), [](const Format* format) { return format->about; });
    return about;
  }();
  return abouts;
}

}  // namespace tribunal
