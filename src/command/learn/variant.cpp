// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/variant.hpp"

#include <array>
#include <cstdlib>

namespace magicmass::command {
namespace {

/// FNV-1a, the same on every machine.
std::uint64_t mixed(std::uint64_t seed, const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](unsigned char byte) { hash = (hash ^ byte) * 1099511628211ULL; };
  for (unsigned shift = 0; shift < 64; shift += 8) add(static_cast<unsigned char>(seed >> shift));
  for (const char c : text) add(static_cast<unsigned char>(c));
  return hash >> 16U;
}

}  // namespace

Values variant_of(const Exercise& exercise, std::uint64_t seed) {
  Values values = exercise.variants[seed % exercise.variants.size()];
  for (const auto& [name, range] : exercise.ranges) {
    const auto count = static_cast<std::uint64_t>(range.second - range.first + 1);
    const std::uint64_t drawn = mixed(seed, exercise.id + "/" + name) % count;
    values[name] = std::to_string(range.first + static_cast<long>(drawn));
  }
  return values;
}

std::string filled(const std::string& text, const Values& values) {
  static const std::string ordinal_mark = "ordinal:";
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, 2, "{{") == 0) {  // a computed part of a text
      result += "{{";
      at += 2;
      continue;
    }
    const std::size_t close = text[at] == '{' ? text.find('}', at) : std::string::npos;
    if (close != std::string::npos) {
      std::string name = text.substr(at + 1, close - at - 1);
      const bool is_ordinal = name.starts_with(ordinal_mark);
      if (is_ordinal) name.erase(0, ordinal_mark.size());
      if (const auto found = values.find(name); found != values.end()) {
        result += is_ordinal ? ordinal(std::atol(found->second.c_str())) : found->second;
        at = close + 1;
        continue;
      }
    }
    result += text[at++];
  }
  return result;
}

Exercise filled(Exercise exercise, const Values& values) {
  const auto fill = [&](std::string& text) { text = filled(text, values); };
  const auto fill_all = [&](std::vector<std::string>& texts) {
    for (std::string& text : texts) fill(text);
  };
  const auto fill_pairs = [&](Values& pairs) {
    for (auto& [name, text] : pairs) fill(text);
  };
  fill_all(exercise.hints);
  fill_all(exercise.domain);
  fill_all(exercise.run);
  for (auto* answers : {&exercise.right, &exercise.wrong, &exercise.other_form}) fill_all(*answers);
  fill_pairs(exercise.where);
  fill_pairs(exercise.truth);
  fill_pairs(exercise.fields);
  fill(exercise.start);
  fill(exercise.within);
  fill(exercise.law);
  for (Choice& choice : exercise.choices) {
    fill(choice.text);
    fill(choice.when);
  }
  for (Misconception& one : exercise.misconceptions) {
    fill_all(one.answers);
    fill_pairs(one.replace);
    fill(one.feedback);
  }
  return exercise;
}

std::string shown_variant(const Values& values) {
  std::string shown;
  for (const auto& [name, value] : values)
    shown += (shown.empty() ? "" : ", ") + name + " = " + value;
  return shown;
}

std::string ordinal(long number) {
  static const std::array<const char*, 12> words{"first", "second", "third",    "fourth",
                                                 "fifth", "sixth",  "seventh",  "eighth",
                                                 "ninth", "tenth",  "eleventh", "twelfth"};
  if (number >= 1 && number <= 12) return words[static_cast<std::size_t>(number - 1)];
  const long last = number % 10;
  const bool is_teen = number / 10 % 10 == 1;
  return std::to_string(number) + (is_teen || last > 3 || last < 1 ? "th"
                                   : last == 1                     ? "st"
                                   : last == 2                     ? "nd"
                                                                   : "rd");
}

}  // namespace magicmass::command
