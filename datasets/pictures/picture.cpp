#include "datasets/pictures/picture.hpp"

#include "datasets/files/files.hpp"
#include "datasets/files/text.hpp"
#include "datasets/pictures/mesh_drawing.hpp"

#include <string>

namespace tribunal {
namespace {
bool is_svg(const std::string& ending) { return ending == ".svg" || ending == ".SVG"; }
bool is_png(const std::string& ending) { return ending == ".png" || ending == ".PNG"; }
}  // namespace

void require_picture_ending(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (!is_svg(ending) && !is_png(ending))
    throw BadInput(path.string() + ": pictures are written as .svg or .png, not '" + ending + "'");
}

void write_picture(const std::filesystem::path& path, std::span<const Point2> points,
                   std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::span<const std::array<std::uint32_t, 2>> strokes, const PictureStyle& style) {
  require_picture_ending(path);
  const pictures::Drawing drawing = pictures::draw({points, triangles, strokes}, style);
  write_text(path, is_png(path.extension().string()) ? png(drawing) : svg(drawing));
}

}  // namespace tribunal
