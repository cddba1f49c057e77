#include "reports/figures/sign_map.hpp"

#include <png.h>

#include <charconv>
#include <cstring>
#include <stdexcept>

namespace tribunal::reports {
namespace {

constexpr std::size_t most_pixels = std::size_t{1} << 22;

/// The signs one by one; empty where the text is malformed or absurdly long.
std::vector<char> decode(std::string_view text) {
  std::vector<char> signs;
  while (!text.empty()) {
    const char sign = text[0];
    if ((sign != '+' && sign != '-' && sign != '0') || text.size() < 2 || text[1] != '[') return {};
    std::size_t run = 0;
    const auto result = std::from_chars(text.data() + 2, text.data() + text.size(), run);
    if (result.ec != std::errc{} || result.ptr == text.data() + text.size() || *result.ptr != ']') return {};
    if (run == 0 || run > most_pixels - signs.size()) return {};
    signs.insert(signs.end(), run, sign);
    text.remove_prefix(static_cast<std::size_t>(result.ptr - text.data()) + 1);
  }
  return signs;
}

Pixel compare(char sign, char exact) {
  if (sign == exact) return sign == '+' ? Pixel::positive : sign == '-' ? Pixel::negative : Pixel::zero;
  if (sign == '0') return Pixel::false_zero;
  return exact == '0' ? Pixel::false_nonzero : Pixel::inverted;
}

[[noreturn]] void fail(png_structp /*png*/, png_const_charp message) { throw std::runtime_error(message); }
void ignore(png_structp /*png*/, png_const_charp /*message*/) {}

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}
void flush(png_structp /*png*/) {}

/// libpng's two handles, let go together.
struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png_create_info_struct(png);

  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

}  // namespace

std::optional<SignMap> sign_map(std::string_view signs, std::string_view exact) {
  const std::vector<char> got = decode(signs);
  const std::vector<char> wanted = decode(exact);
  std::size_t side = 0;
  while (side * side < got.size()) ++side;
  if (got.empty() || got.size() != wanted.size() || side * side != got.size()) return std::nullopt;
  SignMap map{side, {}};
  for (std::size_t i = 0; i < got.size(); ++i) map.pixels.push_back(compare(got[i], wanted[i]));
  return map;
}

std::string png(const SignMap& map) {
  const Writer writer;
  std::string bytes;
  png_set_write_fn(writer.png, &bytes, append, flush);
  const auto side = static_cast<png_uint_32>(map.side);
  png_set_IHDR(writer.png, writer.info, side, side, 8, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::array<png_color, pixel_kinds> palette{};
  for (std::size_t i = 0; i < pixel_kinds; ++i)
    palette[i] = {pixel_colours[i][0], pixel_colours[i][1], pixel_colours[i][2]};
  png_set_PLTE(writer.png, writer.info, palette.data(), static_cast<int>(pixel_kinds));
  png_write_info(writer.png, writer.info);
  std::vector<png_byte> row(map.side);
  for (std::size_t y = map.side; y-- > 0;) {
    std::memcpy(row.data(), map.pixels.data() + y * map.side, map.side);
    png_write_row(writer.png, row.data());
  }
  png_write_end(writer.png, nullptr);
  return bytes;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < have ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= have ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace tribunal::reports
