// SPDX-License-Identifier: GPL-2.0-or-later
#include "json_schema.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace {

using nlohmann::json;

class Validation {
public:
  explicit Validation(const json& root) : root_(root) {}

  std::vector<std::string> complaints;

  void look(const json& schema, const json& value, const std::string& place) {
    for (const auto& [keyword, rule] : schema.items()) {
      if (keyword == "type") {
        if (!is_of(rule, value)) complain(place, "is not of type " + rule.dump());
      } else if (keyword == "enum") {
        if (std::find(rule.begin(), rule.end(), value) == rule.end())
          complain(place, value.dump() + " is none of " + rule.dump());
      } else if (keyword == "minimum") {
        if (value.is_number() && value < rule) complain(place, "is less than " + rule.dump());
      } else if (keyword == "properties") {
        look_at_properties(rule, value, place);
      } else if (keyword == "required") {
        for (const json& name : rule)
          if (value.is_object() && !value.contains(name))
            complain(place, name.dump() + " is missing");
      } else if (keyword == "additionalProperties") {
        look_at_others(schema, rule, value, place);
      } else if (keyword == "items") {
        if (value.is_array())
          for (std::size_t i = 0; i < value.size(); ++i)
            look(rule, value[i], place + "/" + std::to_string(i));
      } else if (keyword == "anyOf") {
        look_at_any(rule, value, place);
      } else if (keyword == "$ref") {
        look(root_.at(json::json_pointer(rule.get<std::string>().substr(1))), value, place);
      } else if (keyword != "$schema" && keyword != "$defs" && keyword != "title") {
        throw std::invalid_argument("the schema's keyword " + keyword + " is not known here");
      }
    }
  }

private:
  const json& root_;

  void complain(const std::string& place, const std::string& what) {
    complaints.push_back(place + ": " + what);
  }

  /// An integer is a number without a fraction: one too large for 64 bits is read as a double.
  static bool is_of(const json& type, const json& value) {
    if (type.is_array())
      return std::any_of(type.begin(), type.end(),
                         [&](const json& one) { return is_of(one, value); });
    if (type == "integer")
      return value.is_number() && std::trunc(value.get<double>()) == value.get<double>();
    if (type == "number") return value.is_number();
    static constexpr std::array<const char*, 5> names{"null", "boolean", "string", "array",
                                                      "object"};
    if (std::find(names.begin(), names.end(), type.get<std::string>()) == names.end())
      throw std::invalid_argument("no JSON type is called " + type.dump());
    return type == value.type_name();
  }

  void look_at_properties(const json& rules, const json& value, const std::string& place) {
    if (!value.is_object()) return;
    for (const auto& [name, rule] : rules.items())
      if (value.contains(name)) look(rule, value[name], place + "/" + name);
  }

  void look_at_others(const json& schema, const json& rule, const json& value,
                      const std::string& place) {
    if (!value.is_object()) return;
    for (const auto& [name, member] : value.items()) {
      if (schema.contains("properties") && schema["properties"].contains(name)) continue;
      if (rule == false)
        complain(place, "\"" + name + "\" is not allowed");
      else
        look(rule, member, place + "/" + name);
    }
  }

  void look_at_any(const json& rules, const json& value, const std::string& place) {
    std::string all;
    for (const json& rule : rules) {
      Validation one(root_);
      one.look(rule, value, place);
      if (one.complaints.empty()) return;
      all += (all.empty() ? "" : " or ") + one.complaints.front();
    }
    complain(place, "fits nothing of anyOf: " + all);
  }
};

}  // namespace

std::vector<std::string> complaints(const json& schema, const json& value) {
  Validation validation(schema);
  validation.look(schema, value, "");
  return validation.complaints;
}
