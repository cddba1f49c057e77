// .wkt, well-known text (OGC 06-103r4): POINT, LINESTRING, POLYGON, their MULTI forms and GEOMETRYCOLLECTION,
// as many as there are, a semicolon or nothing between. Of Z and M only the first two coordinates are taken.
#include "datasets/files/format.hpp"
#include "datasets/files/numerals.hpp"
#include "datasets/files/rings.hpp"
#include "datasets/files/text.hpp"

#include <algorithm>
#include <cctype>

namespace tribunal::files {
namespace {

class WktReader {
 public:
  WktReader(const std::filesystem::path& path, std::string_view text) : cursor_(name_of(path), text) {}

  PslgFile read() {
    while (!cursor_.at_end()) {
      if (cursor_.take(';')) continue;
      if (geometry()) continue;
      // Collections are read flat: their geometries follow one another, and a parenthesis ends one.
      while (open_collections_ > 0 && !cursor_.take(',')) {
        cursor_.expect(')');
        --open_collections_;
      }
    }
    if (open_collections_ > 0) cursor_.expect(')');
    return rings_.take();
  }

 private:
  /// Reads one geometry, or opens a collection: true.
  bool geometry() {
    const Scanner::Place where = cursor_.place();
    std::string kind = upper_word();
    if (kind == "SRID") {
      cursor_.expect('=');
      (void)cursor_.number("the SRID");
      return false;
    }
    const bool multi = kind.starts_with("MULTI");
    const std::string single = multi ? kind.substr(5) : kind;
    skip_dimensions();
    if (is_empty()) return false;
    if (kind == "GEOMETRYCOLLECTION") {
      cursor_.expect('(');
      ++open_collections_;
      return true;
    }
    if (single == "POINT")
      multi ? each([this] { lone_point(); }) : lone_point();
    else if (single == "LINESTRING")
      multi ? each([this] { line(); }) : line();
    else if (single == "POLYGON")
      multi ? each([this] { polygon(); }) : polygon();
    else
      cursor_.refuse_at(where, kind.empty() ? "a geometry is missing"
                                            : in_quotes(kind) + " is no geometry that is read here");
    return false;
  }

  std::string upper_word() {
    std::string word(cursor_.word());
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return word;
  }
  void skip_dimensions() {
    const Cursor::Mark before = cursor_.mark();
    const std::string word = upper_word();
    if (word != "Z" && word != "M" && word != "ZM") cursor_.return_to(before);
  }
  bool is_empty() {
    const Cursor::Mark before = cursor_.mark();
    if (upper_word() == "EMPTY") return true;
    cursor_.return_to(before);
    return false;
  }

  /// "( item, item )"
  template <class Item>
  void each(Item item) {
    cursor_.expect('(');
    do {
      if (!is_empty()) item();
    } while (cursor_.take(','));
    cursor_.expect(')');
  }

  Point2 coordinates() {
    const double x = cursor_.number("x");
    const double y = cursor_.number("y");
    while (cursor_.number_follows()) (void)cursor_.number("a further coordinate");
    return {{x, y}};
  }
  void add_point() {
    const Scanner::Place where = cursor_.place();
    rings_.add(coordinates(), where);
  }
  void lone_point() {
    const bool enclosed = cursor_.take('(');  // MULTIPOINT may do without
    const Scanner::Place where = cursor_.place();
    rings_.add_alone(coordinates(), where);
    if (enclosed) cursor_.expect(')');
  }
  void line() {
    const Scanner::Place where = cursor_.place();
    rings_.begin_chain();
    each([this] { add_point(); });
    rings_.end_chain(where);
  }
  void polygon() {
    rings_.begin_polygon();
    each([this] {
      const Scanner::Place where = cursor_.place();
      rings_.begin_chain();
      each([this] { add_point(); });
      rings_.end_ring(where);
    });
  }

  Cursor cursor_;
  Rings rings_{cursor_};
  std::uint64_t open_collections_ = 0;
};

PslgFile read_pslg(const std::filesystem::path& path, std::string_view text) {
  return WktReader(path, text).read();
}

std::string write_points(std::span<const Point2> points) {
  std::string text = "MULTIPOINT(";
  for (const Point2& point : points) {
    text += &point == points.data() ? "(" : ",\n(";
    append_number(text, point[0]);
    text += ' ';
    append_number(text, point[1]);
    text += ')';
  }
  return text + ")\n";
}

}  // namespace

constinit const Format wkt{
    .about = {".wkt", "points, segments", "well-known text: polygons with holes, lines and points"},
    .write_points = write_points,
    .read_pslg = read_pslg,
};

}  // namespace tribunal::files
