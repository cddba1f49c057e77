#include "tests/cli/schema.hpp"

#include <algorithm>
#include <set>

namespace tribunal::cli {
namespace {
using nlohmann::json;

/// `type` is a name or a list of names.
bool has_type(const json& value, const json& type) {
  if (type.is_array())
    return std::any_of(type.begin(), type.end(), [&](const json& one) { return has_type(value, one); });
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "number") return value.is_number();
  return type == "integer" && value.is_number_integer();
}

std::string object_fault(const json& schema, const json& value, const std::string& path) {
  for (const json& key : schema.value("required", json::array()))
    if (!value.contains(key.get<std::string>())) return path + " lacks " + key.get<std::string>();
  const json properties = schema.value("properties", json::object());
  const json others = schema.value("additionalProperties", json(true));
  for (const auto& [key, member] : value.items()) {
    const std::string place = path + "." + key;
    if (properties.contains(key)) {
      if (std::string fault = schema_fault(properties.at(key), member, place); !fault.empty()) return fault;
    } else if (others == false) {
      return place + " is not in the schema";
    } else if (others.is_object()) {
      if (std::string fault = schema_fault(others, member, place); !fault.empty()) return fault;
    }
  }
  return {};
}

}  // namespace

std::string schema_fault(const json& schema, const json& value, const std::string& path) {
  static const std::set<std::string> known{"$schema",
                                           "title",
                                           "type",
                                           "enum",
                                           "const",
                                           "anyOf",
                                           "minimum",
                                           "items",
                                           "required",
                                           "properties",
                                           "additionalProperties"};
  for (const auto& [keyword, rule] : schema.items())
    if (!known.count(keyword)) return path + ": the schema uses the unknown keyword " + keyword;
  if (schema.contains("anyOf")) {
    std::string faults;
    for (const json& choice : schema.at("anyOf")) {
      const std::string fault = schema_fault(choice, value, path);
      if (fault.empty()) return {};
      faults += fault + "; ";
    }
    return path + " is none of: " + faults;
  }
  if (schema.contains("type") && !has_type(value, schema.at("type")))
    return path + " is no " + schema.at("type").dump();
  if (schema.contains("const") && value != schema.at("const"))
    return path + " is not " + schema.at("const").dump();
  if (schema.contains("enum") && std::count(schema.at("enum").begin(), schema.at("enum").end(), value) == 0)
    return path + " is none of " + schema.at("enum").dump();
  if (schema.contains("minimum") && value < schema.at("minimum")) return path + " is too small";
  if (value.is_array() && schema.contains("items"))
    for (std::size_t i = 0; i < value.size(); ++i) {
      std::string fault = schema_fault(schema.at("items"), value[i], path + "[" + std::to_string(i) + "]");
      if (!fault.empty()) return fault;
    }
  return value.is_object() ? object_fault(schema, value, path) : std::string();
}

}  // namespace tribunal::cli
