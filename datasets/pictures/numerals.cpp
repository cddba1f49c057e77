#include "datasets/pictures/numerals.hpp"

namespace tribunal::pictures {
namespace {

/// Polylines over a grid of 5 x 7 places, each place a column and a row counted from the top; blanks part
/// them.
std::string_view glyph(char c) {
  switch (c) {
    case '0':
      return "103041453616050110";
    case '1':
      return "112026 1636";
    case '2':
      return "01103041420646";
    case '3':
      return "0110304142334445361605 1333";
    case '4':
      return "36300444";
    case '5':
      return "400002324345361605";
    case '6':
      return "413010010516364543321203";
    case '7':
      return "004016";
    case '8':
      return "103041423313020110 133344453616050413";
    case '9':
      return "051636454130100103143443";
    case '.':
      return "1616";
    case '-':
      return "0343";
    case '+':
      return "0343 2125";
    case 'e':
      return "044443321203051636";
    default:
      return "";
  }
}

}  // namespace

std::vector<Stroke> numeral(std::string_view text, Position lower_left, double height) {
  constexpr int advance = 6, top = 6;
  const double unit = height / top;
  std::vector<Stroke> strokes;
  for (const char c : text) {
    const std::string_view path = glyph(c);
    const auto place = [&](std::size_t i) -> Position {
      return {lower_left.x + (path[i] - '0') * unit, lower_left.y + (path[i + 1] - '0' - top) * unit};
    };
    for (std::size_t i = 0; i + 3 < path.size(); i += 2) {
      if (path[i + 2] == ' ')
        ++i;  // with the step of two: to the next polyline
      else
        strokes.push_back({place(i), place(i + 2)});
    }
    lower_left.x += advance * unit;
  }
  return strokes;
}

}  // namespace tribunal::pictures
