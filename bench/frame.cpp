#include "bench/frame.hpp"

#include "bench/hash.hpp"

#include <array>
#include <cstring>

namespace tribunal::bench {
namespace {
constexpr std::uint64_t magic = 0x1f6c616e75626972;
using Header = std::array<std::uint64_t, 3>;  // magic, length of the body, checksum of the body
}  // namespace

std::string encode_frame(Message kind, std::string_view text) {
  std::string bytes(sizeof(Header) + 1, static_cast<char>(kind));
  bytes += text;
  const std::string_view body = std::string_view(bytes).substr(sizeof(Header));
  const Header header{magic, body.size(), Hash{}.add(body).value()};
  std::memcpy(bytes.data(), header.data(), sizeof(Header));
  return bytes;
}

std::optional<Frame> decode_frame(std::string_view bytes) {
  if (bytes.size() <= sizeof(Header)) return std::nullopt;
  Header header;
  std::memcpy(header.data(), bytes.data(), sizeof(Header));
  const std::string_view body = bytes.substr(sizeof(Header));
  if (header != Header{magic, body.size(), Hash{}.add(body).value()}) return std::nullopt;
  return Frame{static_cast<Message>(body[0]), std::string(body.substr(1))};
}

}  // namespace tribunal::bench
