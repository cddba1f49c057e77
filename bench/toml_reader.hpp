// Typed access to TOML values, with errors that name file, line and column.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tribunal::bench {

/// All members throw BadInput.
class TomlReader {
 public:
  explicit TomlReader(std::string filename) : filename_(std::move(filename)) {}

  [[noreturn]] void fail(const toml::source_region& where, const std::string& reason) const;
  [[noreturn]] void fail(const toml::node& where, const std::string& reason) const {
    fail(where.source(), reason);
  }

  /// Fails at the first key of the table that is none of `known`.
  void allow_only(const toml::table& table, std::vector<std::string_view> known) const;

  /// The values of a key: of an array its elements (at least one), else the one value.
  std::vector<const toml::node*> values(const toml::node& node) const;

  const toml::table& table(const toml::node& node, std::string_view name) const;
  std::string text(const toml::node& node, std::string_view name) const;
  /// A whole number of [least, most].
  std::uint64_t whole(const toml::node& node, std::string_view name, std::uint64_t least,
                      std::uint64_t most) const;
  /// A number, whole or not, of [least, most].
  double number(const toml::node& node, std::string_view name, double least, double most) const;
  /// A whole number as it stands, or all of an inclusive range "first..last" of at most `most` numbers.
  std::vector<std::uint64_t> range(const toml::node& node, std::string_view name, std::uint64_t most) const;

 private:
  std::string filename_;
};

}  // namespace tribunal::bench
