#include "bench/row.hpp"

#include "algorithms/outcome.hpp"
#include "bench/hash.hpp"

#include <nlohmann/json.hpp>

#include <string_view>

namespace tribunal::bench {
namespace {

constexpr std::string_view measure_name(Measure measure) {
  return measure == Measure::time ? "time" : "counts";
}

// As nlohmann's own errors, so that readers of cells and rows meet one kind.
[[noreturn]] void fail(const std::string& reason) {
  throw nlohmann::json::other_error::create(501, reason, nullptr);
}

Measure parse_measure(const std::string& name) {
  if (name == "counts") return Measure::counts;
  if (name == "time") return Measure::time;
  fail("measure is \"counts\" or \"time\", not \"" + name + "\"");
}

}  // namespace

std::string cell_key(const Cell& cell) {
  // Objects of nlohmann::json are sorted by name and doubles do not occur: the text is canonical.
  return hash_hex(nlohmann::json(cell).dump());
}

void to_json(nlohmann::json& json, const Cell& cell) {
  json = {{"task", cell.task},
          {"backend", cell.backend},
          {"dataset", cell.dataset},
          {"n", cell.n},
          {"bits", cell.bits},
          {"seed", cell.seed},
          {"order_seed", cell.order_seed},
          {"order", cell.order},
          {"measure", measure_name(cell.measure)},
          {"repeats", cell.repeats},
          {"parameters", cell.parameters}};
}

void from_json(const nlohmann::json& json, Cell& cell) {
  const Cell standard;
  cell.task = json.at("task").get<std::string>();
  cell.backend = json.value("backend", standard.backend);
  cell.dataset = json.value("dataset", standard.dataset);
  cell.n = json.value("n", standard.n);
  cell.bits = json.value("bits", standard.bits);
  cell.seed = json.value("seed", standard.seed);
  cell.order_seed = json.value("order_seed", standard.order_seed);
  cell.order = json.value("order", standard.order);
  cell.measure = parse_measure(json.value("measure", std::string(measure_name(standard.measure))));
  cell.repeats = json.value("repeats", standard.repeats);
  cell.parameters = json.value("parameters", standard.parameters);
  // The library converts silently (-1 to a large number, 1.5 to 1) and passes over names it is not asked for.
  const nlohmann::json understood = cell;
  for (const auto& [name, value] : json.items())
    if (!understood.contains(name) || understood.at(name).dump() != value.dump())
      fail("a cell has no " + name + " = " + value.dump());
}

void to_json(nlohmann::json& json, const Row& row) {
  json = {{"schema", row.schema},   {"key", row.key},       {"cell", row.cell},
          {"outcome", row.outcome}, {"reason", row.reason}, {"counters", row.counters},
          {"seconds", row.seconds}, {"digest", row.digest}, {"peak_bytes", row.peak_bytes},
          {"command", row.command}};
  if (!row.texts.empty()) json["texts"] = row.texts;
}

void from_json(const nlohmann::json& json, Row& row) {
  json.at("schema").get_to(row.schema);
  if (row.schema != row_schema)
    fail("row schema " + std::to_string(row.schema) + ", this program reads " + std::to_string(row_schema));
  json.at("key").get_to(row.key);
  json.at("cell").get_to(row.cell);
  json.at("outcome").get_to(row.outcome);
  if (!parse_outcome(row.outcome)) fail("there is no outcome '" + row.outcome + "'");
  json.at("reason").get_to(row.reason);
  json.at("counters").get_to(row.counters);
  row.texts = json.value("texts", decltype(row.texts){});
  json.at("seconds").get_to(row.seconds);
  json.at("peak_bytes").get_to(row.peak_bytes);
  json.at("digest").get_to(row.digest);
  json.at("command").get_to(row.command);
}

}  // namespace tribunal::bench
