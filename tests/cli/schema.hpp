// Validation against the part of JSON Schema that our schemas use.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace tribunal::cli {

/// Where and how `value` breaks `schema`; empty when it does not. Knows type, enum, const, anyOf, minimum,
/// items, required, properties and additionalProperties; any other keyword is itself a fault, so that none is
/// ignored.
std::string schema_fault(const nlohmann::json& schema, const nlohmann::json& value,
                         const std::string& path = "$");

}  // namespace tribunal::cli
