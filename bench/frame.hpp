// One message through a pipe, recognisable as whole or not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tribunal::bench {

/// What a sandboxed child has to say.
enum class Message : char { result = 'r', exception = 'x' };

struct Frame {
  Message kind;
  std::string text;
};

/// Magic, length, checksum, kind and text, in the byte order of this machine.
std::string encode_frame(Message kind, std::string_view text);

/// The frame that `bytes` are, exactly: nothing when they are cut short, followed by more, or garbage.
std::optional<Frame> decode_frame(std::string_view bytes);

}  // namespace tribunal::bench
