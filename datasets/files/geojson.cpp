// .geojson (RFC 7946): points, lines and polygons of a geometry, a feature or a collection of either.
// Properties and whatever else there is are passed over; of the positions the first two numbers are taken.
#include "datasets/files/format.hpp"
#include "datasets/files/numerals.hpp"
#include "datasets/files/rings.hpp"
#include "datasets/files/text.hpp"

#include <optional>

namespace tribunal::files {
namespace {

class GeoJsonReader {
 public:
  GeoJsonReader(const std::filesystem::path& path, std::string_view text) : cursor_(name_of(path), text) {}

  PslgFile read() {
    object(0);
    if (!cursor_.at_end()) cursor_.refuse("nothing may follow the one object of the file");
    return rings_.take();
  }

 private:
  static constexpr int deepest = 64;  // nesting of collections; RFC 7946 advises against any

  /// A geometry, a feature or a collection. Its members may come in any order, so "coordinates" waits for
  /// "type".
  void object(int depth) {
    const Scanner::Place where = cursor_.place();
    if (depth > deepest) cursor_.refuse("collections nested too deeply");
    std::string_view type;
    std::optional<Cursor::Mark> coordinates_at;
    each('{', '}', [&] {
      const std::string_view key = cursor_.quoted();
      cursor_.expect(':');
      if (key == "type") {
        type = cursor_.quoted();
      } else if (key == "coordinates") {
        coordinates_at = cursor_.mark();
        skip_value();
      } else if (key == "geometry") {
        if (cursor_.peek() == '{')
          object(depth + 1);
        else
          skip_value();  // null: a feature without a place
      } else if (key == "features" || key == "geometries") {
        each('[', ']', [&] { object(depth + 1); });
      } else {
        skip_value();
      }
    });
    if (type.empty()) cursor_.refuse_at(where, "\"type\" is missing");
    if (!coordinates_at) return;
    const Cursor::Mark behind = cursor_.mark();
    cursor_.return_to(*coordinates_at);
    read_coordinates(type);
    cursor_.return_to(behind);
  }

  void read_coordinates(std::string_view type) {
    const auto list = [this](auto item) { each('[', ']', item); };
    const auto point = [this] {
      const Scanner::Place where = cursor_.place();
      rings_.add_alone(position(), where);
    };
    if (type == "Point")
      point();
    else if (type == "MultiPoint")
      list(point);
    else if (type == "LineString")
      line();
    else if (type == "MultiLineString")
      list([this] { line(); });
    else if (type == "Polygon")
      polygon();
    else if (type == "MultiPolygon")
      list([this] { polygon(); });
    else
      cursor_.refuse(in_quotes(type) + " is no geometry of GeoJSON");
  }

  /// `item` for each element between `open` and `close`.
  template <class Item>
  void each(char open, char close, Item item) {
    cursor_.expect(open);
    if (cursor_.take(close)) return;
    do item();
    while (cursor_.take(','));
    cursor_.expect(close);
  }

  Point2 position() {
    cursor_.expect('[');
    const double x = cursor_.number("x");
    cursor_.expect(',');
    const double y = cursor_.number("y");
    while (cursor_.take(',')) (void)cursor_.number("a further coordinate");
    cursor_.expect(']');
    return {{x, y}};
  }
  void add_position() {
    const Scanner::Place where = cursor_.place();
    rings_.add(position(), where);
  }
  void line() {
    const Scanner::Place where = cursor_.place();
    rings_.begin_chain();
    each('[', ']', [this] { add_position(); });
    rings_.end_chain(where);
  }
  void polygon() {
    rings_.begin_polygon();
    each('[', ']', [this] {
      const Scanner::Place where = cursor_.place();
      rings_.begin_chain();
      each('[', ']', [this] { add_position(); });
      rings_.end_ring(where);
    });
  }

  /// Passes over any value: brackets are counted, strings read whole, the rest is not looked at.
  void skip_value() {
    std::uint64_t open = 0;
    do {
      const char c = cursor_.peek();
      if (c == '"') {
        (void)cursor_.quoted();
      } else if (c == '[' || c == '{') {
        cursor_.take(c);
        ++open;
      } else if ((c == ']' || c == '}') && open > 0) {
        cursor_.take(c);
        --open;
      } else if (c == ',' || c == ':') {
        if (open == 0) cursor_.refuse("a value is missing");
        cursor_.take(c);
      } else if (cursor_.bare().empty()) {
        cursor_.refuse("a value is missing");
      }
    } while (open > 0);
  }

  Cursor cursor_;
  Rings rings_{cursor_};
};

PslgFile read_pslg(const std::filesystem::path& path, std::string_view text) {
  return GeoJsonReader(path, text).read();
}

std::string write_points(std::span<const Point2> points) {
  std::string text = R"({"type":"MultiPoint","coordinates":[)";
  for (const Point2& point : points) {
    text += &point == points.data() ? "\n[" : ",\n[";
    append_number(text, point[0]);
    text += ',';
    append_number(text, point[1]);
    text += ']';
  }
  return text + "]}\n";
}

}  // namespace

constinit const Format geojson{
    .about = {".geojson", "points, segments", "GeoJSON: polygons with holes, lines and points"},
    .write_points = write_points,
    .read_pslg = read_pslg,
};

}  // namespace tribunal::files
