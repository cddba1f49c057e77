// What `tribunal fuzz` prints.
#pragma once

#include "bench/fuzz/hunt.hpp"
#include "cli/console.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace tribunal::cli {

/// As cli/schemas/fuzz.schema.json says; the counterexamples stand in the order of the tallies. `replay_of`
/// gives the command that repeats a wrong answer.
nlohmann::json hunt_document(std::uint64_t seed, const bench::fuzz::HuntReport& report,
                             const std::function<std::string(const bench::fuzz::Counterexample&)>& replay_of);

/// The document, or as a table of who was asked what and below it the counterexamples.
void print_hunt(Console& console, const nlohmann::json& document);

}  // namespace tribunal::cli
