// Whole files in and out of memory.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace tribunal {

/// The name of a path in messages: as the user gave it, "stdin" for "-".
std::string name_of(const std::filesystem::path& path);

/// The bytes of a text file; "-" is standard input. Throws BadInput with the system's reason, or where a zero
/// byte tells that it is no text.
std::string read_text(const std::filesystem::path& path);

/// Replaces a file's content at once: the text goes to a temporary file beside it, which is then renamed, so
/// that a failure leaves the old content. "-" is standard output; what is no regular file (a device, a pipe)
/// is written directly. Throws BadInput with the system's reason.
void write_text(const std::filesystem::path& path, std::string_view text);

/// Several files that belong together: all are complete before the first one is renamed.
struct TextFile {
  std::filesystem::path path;
  std::string_view text;
};
void write_texts(std::span<const TextFile> files);

}  // namespace tribunal
