#include "bench/plan.hpp"

#include "bench/hash.hpp"
#include "bench/toml_reader.hpp"
#include "datasets/files/files.hpp"

#include <fstream>
#include <iterator>

namespace tribunal::bench {
namespace {

constexpr std::uintmax_t largest_file = 16 << 20;

Limits read_limits(const TomlReader& reader, const toml::table& table) {
  reader.allow_only(table, {"seconds", "memory_mib"});
  Limits limits;
  if (const toml::node* seconds = table.get("seconds"))
    limits.seconds = reader.number(*seconds, "seconds", 0.001, 604'800);
  if (const toml::node* memory = table.get("memory_mib"))
    limits.memory_mib = reader.whole(*memory, "memory_mib", 16, std::uint64_t{1} << 24);
  return limits;
}

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  const bool regular = std::filesystem::is_regular_file(path, error);
  if (regular && std::filesystem::file_size(path, error) > largest_file)
    throw BadInput(path.string() + ": too long for a campaign");
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, error)) throw BadInput(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Plan read_plan(const toml::table& table, const std::string& filename) {
  const TomlReader reader(filename);
  reader.allow_only(table, {"name", "limits", "cells"});
  Plan plan;
  plan.name = std::filesystem::path(filename).stem().string();
  if (const toml::node* name = table.get("name")) plan.name = reader.text(*name, "name");
  if (const toml::node* limits = table.get("limits"))
    plan.limits = read_limits(reader, reader.table(*limits, "limits"));
  plan.cells = expand(table, filename);
  return plan;
}

Plan parse_plan(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  toml::table table;
  try {
    table = toml::parse(text, path.string());
  } catch (const toml::parse_error& error) {
    TomlReader(path.string()).fail(error.source(), std::string(error.description()));
  }
  Plan plan = read_plan(table, path.string());
  plan.input_digest = hash_hex(text);
  return plan;
}

}  // namespace tribunal::bench
