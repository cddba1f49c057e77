#include "datasets/pictures/mesh_drawing.hpp"

#include "datasets/pictures/legend.hpp"
#include "datasets/pictures/palette.hpp"
#include "datasets/pictures/sheet.hpp"
#include "datasets/pictures/surface.hpp"
#include "datasets/pictures/triangle_angles.hpp"

#include <algorithm>
#include <cmath>

namespace tribunal::pictures {
namespace {

constexpr Colour faint{238, 243, 248}, blue{31, 78, 121}, grey{160, 170, 182}, ink{40, 40, 40},
    red{179, 38, 30};
constexpr std::size_t bands_without_contours = 16;

class MeshDrawing {
 public:
  MeshDrawing(const MeshView& mesh, const PictureStyle& style)
      : mesh_(mesh),
        style_(style),
        sheet_(style.window ? Box{(*style.window)[0], (*style.window)[1]} : box_of(mesh.points)),
        bands_(style.field, style.contours > 0 ? style.contours + 1 : bands_without_contours) {
    drawing_.width = sheet_.width();
    drawing_.height = sheet_.height();
  }

  Drawing finish() && {
    colour_triangles();
    const double spacing = spacing_of_points();
    // Thinner lines for denser meshes: a fixed share of the mean edge length, between a hair and a pencil.
    const double line = std::clamp(spacing * 0.04, 0.05, 1.5);
    draw_edges(line);
    draw_contours(std::clamp(spacing * 0.06, 0.5, 2.2));
    draw_marked(2.5 * line);
    if (mesh_.triangles.empty()) draw_points();
    return std::move(drawing_);
  }

 private:
  bool is_on_sheet(const Position& p) const {
    return p.x >= 0 && p.y >= 0 && p.x <= sheet_.width() && p.y <= sheet_.height();
  }

  /// As many units as points on the sheet are apart.
  double spacing_of_points() const {
    const auto shown = std::count_if(mesh_.points.begin(), mesh_.points.end(),
                                     [&](const Point2& p) { return is_on_sheet(sheet_.at(p)); });
    return Sheet::longest / std::sqrt(std::max(1.0, static_cast<double>(shown)));
  }

  std::array<Corner, 3> corners(const std::array<std::uint32_t, 3>& triangle) const {
    std::array<Corner, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = {sheet_.at(mesh_.points[triangle[k]]),
                   style_.field.empty() ? 0.0 : bands_.height(triangle[k])};
    return corner;
  }

  /// What a window leaves of a triangle.
  std::vector<Corner> shown(const std::array<Corner, 3>& triangle) const {
    std::vector<Corner> polygon(triangle.begin(), triangle.end());
    const auto on_sheet = [&](const Corner& c) { return is_on_sheet(c.at); };
    if (std::all_of(polygon.begin(), polygon.end(), on_sheet)) return polygon;
    return part_within(std::move(polygon), sheet_.width(), sheet_.height());
  }

  void add_area(std::size_t shade, const std::vector<Corner>& polygon) {
    if (polygon.size() < 3) return;
    auto& polygons = drawing_.areas[shade].polygons;
    polygons.emplace_back();
    for (const Corner& corner : polygon) polygons.back().push_back(corner.at);
  }

  void colour_triangles() {
    if (style_.colouring == Colouring::plain) {
      drawing_.areas.push_back({faint, {}});
      for (const auto& triangle : mesh_.triangles) add_area(0, shown(corners(triangle)));
    } else if (style_.colouring == Colouring::field) {
      drawing_.areas = shades(bands_.count());
      for (const auto& triangle : mesh_.triangles)
        bands_.split(shown(corners(triangle)), [&](std::size_t k, const auto& part) { add_area(k, part); });
      add_legend(drawing_, scale_of(bands_));
    } else {
      colour_by_angle();
    }
  }

  void colour_by_angle() {
    const bool largest = style_.colouring == Colouring::largest_angle;
    const AngleScale scale = largest ? largest_angles : smallest_angles;
    drawing_.areas = shades(scale.bands);
    for (const auto& triangle : mesh_.triangles) {
      const std::array angles = angles_of(mesh_.points, triangle);
      add_area(scale.band(largest ? angles[2] : angles[0]), shown(corners(triangle)));
    }
    add_legend(drawing_, scale_of(scale));
  }

  void add_stroke(std::vector<Stroke>& strokes, Stroke stroke) const {
    if (clip(stroke, sheet_.width(), sheet_.height())) strokes.push_back(stroke);
  }

  void draw_edges(double width) {
    std::vector<std::array<std::uint32_t, 2>> edges;
    edges.reserve(3 * mesh_.triangles.size());
    for (const auto& [a, b, c] : mesh_.triangles)
      for (const auto& [from, to] : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
        edges.push_back({std::min(from, to), std::max(from, to)});
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    Lines lines{style_.contours > 0 ? grey : style_.colouring == Colouring::plain ? blue : ink, width, {}};
    for (const auto& [a, b] : edges)
      add_stroke(lines.strokes, {sheet_.at(mesh_.points[a]), sheet_.at(mesh_.points[b])});
    drawing_.lines.push_back(std::move(lines));
  }

  void draw_contours(double width) {
    if (style_.contours == 0) return;
    Lines lines{ink, width, {}};
    for (const auto& triangle : mesh_.triangles)
      for (const Stroke& stroke : bands_.contours(corners(triangle))) add_stroke(lines.strokes, stroke);
    drawing_.lines.push_back(std::move(lines));
  }

  void draw_marked(double width) {
    Lines lines{red, width, {}};
    for (const auto& [a, b] : mesh_.marked)
      add_stroke(lines.strokes, {sheet_.at(mesh_.points[a]), sheet_.at(mesh_.points[b])});
    drawing_.lines.push_back(std::move(lines));
  }

  void draw_points() {
    Lines dots{blue, 6, {}};
    for (const Point2& point : mesh_.points)
      if (const Position p = sheet_.at(point); is_on_sheet(p)) dots.strokes.push_back({p, p});
    drawing_.lines.push_back(std::move(dots));
  }

  const MeshView& mesh_;
  const PictureStyle& style_;
  Sheet sheet_;
  Bands bands_;
  Drawing drawing_;
};

}  // namespace

Drawing draw(const MeshView& mesh, const PictureStyle& style) { return MeshDrawing(mesh, style).finish(); }

}  // namespace tribunal::pictures
