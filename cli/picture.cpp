#include "cli/picture.hpp"

#include "algorithms/data_dependent/optimize.hpp"
#include "algorithms/data_dependent/parameters.hpp"
#include "cli/console.hpp"
#include "cli/mesh_input.hpp"
#include "cli/numbers.hpp"
#include "datasets/pictures/picture.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace tribunal::cli {
namespace {

Colouring colouring_named(const std::string& name) {
  if (name == "plain") return Colouring::plain;
  if (name == "angle") return Colouring::largest_angle;
  if (name == "smallest-angle") return Colouring::smallest_angle;
  if (name == "field") return Colouring::field;
  throw BadUsage("--colour " + name + ": there are plain, angle, smallest-angle and field");
}

std::optional<std::array<Point2, 2>> window_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  std::vector<double> numbers;
  try {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t comma = std::min(text.find(',', from), text.size());
      numbers.push_back(parse_number(text.substr(from, comma - from)));
      from = comma + 1;
    }
  } catch (const BadUsage& bad) {
    throw BadUsage("--window " + text + ": " + bad.what());
  }
  if (numbers.size() != 4 || !(numbers[0] < numbers[2] && numbers[1] < numbers[3]))
    throw BadUsage("--window " + text + ": its corners are x0,y0,x1,y1 with x0 < x1 and y0 < y1");
  return {{Point2{numbers[0], numbers[1]}, Point2{numbers[2], numbers[3]}}};
}

bool shows_field(const PictureOptions& options) {
  return !options.file.empty() && (options.colour == "field" || options.contours > 0);
}

std::vector<Edge> edges_of(std::span<const Triangle> triangles) {
  std::vector<Edge> edges;
  for (const auto& [a, b, c] : triangles)
    for (const auto& [from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}})
      edges.push_back({std::min(from, to), std::max(from, to)});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Values by point of what the options name, of what the algorithm reads, or of the third column.
std::vector<double> field_of(const PictureOptions& options, const std::string& file, const PointFile& points,
                             const Settings& settings) {
  Settings chosen;
  if (!options.field.empty())
    chosen["data"] = options.field;
  else if (const auto data = settings.find("data"); data != settings.end())
    chosen["data"] = data->second;
  const std::string name = choice(chosen, data_parameter);
  if (name == third_column && points.values.empty())
    throw BadInput(file +
                   ": the picture shows the third column, and there is none (--field F1 takes a function)");
  std::vector<double> field = chosen_data(points.points, points.values, chosen);
  const auto stray =
      std::find_if(field.begin(), field.end(), [](double value) { return !std::isfinite(value); });
  if (stray != field.end())
    throw BadInput(file + ": " + name + " has no finite value at point " +
                   std::to_string(stray - field.begin()));
  return field;
}

}  // namespace

void check_picture(const PictureOptions& options) {
  if (!options.file.empty()) require_picture_ending(options.file);
  colouring_named(options.colour);
  window_of(options.window);
  const bool styled = options.colour != "plain" || options.contours > 0 || !options.field.empty() ||
                      !options.window.empty() || !options.against.empty();
  if (options.file.empty() && styled)
    throw BadUsage("--colour, --field, --contours, --window and --against are about a --picture FILE");
  if (!options.field.empty()) {
    if (const std::string reason = refuse(data_parameter, options.field); !reason.empty())
      throw BadUsage("--field: " + reason);
    if (!shows_field(options)) throw BadUsage("--field is shown by --colour field or by --contours");
  }
}

Picture::Picture(const PictureOptions& options, const std::string& file, const PointFile& points,
                 const Settings& settings)
    : options_(options) {
  if (shows_field(options)) field_ = field_of(options, file, points, settings);
  if (!options.against.empty()) others_ = edges_of(read_mesh_over(file, points, options.against).triangles);
}

void Picture::draw(std::span<const Point2> points, std::span<const Triangle> triangles,
                   std::span<const Edge> marked) const {
  if (options_.file.empty()) return;
  std::vector<Edge> outstanding(marked.begin(), marked.end());
  if (!options_.against.empty()) {
    const std::vector<Edge> edges = edges_of(triangles);
    std::set_difference(edges.begin(), edges.end(), others_.begin(), others_.end(),
                        std::back_inserter(outstanding));
  }
  write_picture(options_.file, points, triangles, outstanding,
                {colouring_named(options_.colour), field_, options_.contours, window_of(options_.window)});
}

}  // namespace tribunal::cli
