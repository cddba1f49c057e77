#include "bench/plan.hpp"

#include "bench/hash.hpp"
#include "bench/toml_reader.hpp"
#include "datasets/files/text.hpp"
namespace tribunal::bench {
namespace {

Limits read_limits(const TomlReader& reader, const toml::table& table) {
  reader.allow_only(table, {"seconds", "memory_mib"});
  Limits limits;
  if (const toml::node* seconds = table.get("seconds"))
    limits.seconds = reader.number(*seconds, "seconds", 0.001, 604'800);
  if (const toml::node* memory = table.get("memory_mib"))
    limits.memory_mib = reader.whole(*memory, "memory_mib", 16, std::uint64_t{1} << 24);
  return limits;
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
  const std::string text = read_text(path);
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
