// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <cstdlib>
#include <sstream>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/scene_keys.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass {
namespace {

std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// Numbers go through the same reader as text, so a scene, the command line and a CSV cell mean the same.
std::string written(const toml::node& node, const Place& place) {
  if (const auto* string = node.as_string()) return string->get();
  if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  place.refuse("expected a number, got a TOML " + type_name(node), allowed_values);
}

/// What an error says, without what it allows.
std::string complaint(const InvalidInput& error) {
  const std::string what = error.what();
  return what.substr(0, what.rfind("; allowed: "));
}

}  // namespace

void Place::refuse(const std::string& what, std::string_view allowed) const {
  throw InvalidInput(std::string(source) + ":" + std::to_string(line) + ": " + shown_text(key) +
                     ": " + what + "; allowed: " + std::string(allowed));
}

bool has_endless_key(std::string_view text) {
  int parts = 1;
  for (const char c : text) {
    if (c == '.' && ++parts > 1000) return true;
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{') parts = 1;
  }
  return false;
}

std::string type_name(const toml::node& node) {
  std::ostringstream name;
  name << node.type();
  return name.str();
}

std::string text_of(const toml::node& node, const Place& place, std::string_view allowed) {
  if (const auto* text = node.as_string()) return text->get();
  place.refuse("expected a string, got a TOML " + type_name(node), allowed);
}

Value value_of(const toml::node& node, const Place& place) {
  constexpr std::int64_t exact_in_double = std::int64_t{1} << 53U;
  if (const auto* integer = node.as_integer())
    if (-exact_in_double <= integer->get() && integer->get() <= exact_in_double)
      return static_cast<double>(integer->get());
  try {
    if (const auto* number = node.as_floating_point()) {
      const std::string text = shortest(number->get());
      return parse_value(text.find_first_of(".en") == std::string::npos ? text + ".0" : text);
    }
    return parse_value(written(node, place));
  } catch (const InvalidInput& error) {
    if (!node.is_string() && !node.is_number()) throw;
    place.refuse(complaint(error), allowed_values);
  }
}

std::vector<Value> values_of(const toml::node& node, const Place& place) {
  const toml::array* elements = node.as_array();
  if (elements == nullptr)
    place.refuse("expected an array, got a TOML " + type_name(node), "an array of values");
  std::vector<Value> values;
  values.reserve(elements->size());
  for (const toml::node& element : *elements)
    values.push_back(value_of(element, {place.source, place.key, element.source().begin.line}));
  return values;
}

std::int64_t whole_of(const toml::node& node, const Place& place, std::int64_t least,
                      std::int64_t most) {
  const std::string allowed =
      "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  const auto* integer = node.as_integer();
  if (integer == nullptr) place.refuse("got a TOML " + type_name(node), allowed);
  if (integer->get() < least || integer->get() > most)
    place.refuse("got " + std::to_string(integer->get()), allowed);
  return integer->get();
}

Value ratio_of(const toml::node& node, const Place& place) {
  const std::string text = written(node, place);
  if (text.find_first_of("(*^+") != std::string::npos) return value_of(node, place);
  try {
    const MassRatio ratio = parse_mass_ratio(text);
    if (const auto* fraction = std::get_if<Fraction>(&ratio))
      return Expression{fraction->numerator + "/" + fraction->denominator};
    if (const auto* magic = std::get_if<Magic>(&ratio)) return *magic;
    if (const auto* deficient = std::get_if<Deficient>(&ratio)) return *deficient;
    return std::get<double>(ratio);
  } catch (const InvalidInput& error) {
    place.refuse(complaint(error), allowed_values);
  }
}

}  // namespace magicmass
