// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/content_table.hpp"

#include <set>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "command/learn/exercise.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/nearest_key.hpp"
#include "magicmass/scenes/scene_keys.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {

struct ContentTable::Data {
  std::string file;
  std::shared_ptr<const toml::table> root;  // a copy of a node would not know its line
  const toml::table* table = nullptr;
  unsigned line = 1;
  std::set<std::string> asked = {};
};

namespace {

[[noreturn]] void refuse_at_line(const std::string& file, unsigned line, const std::string& key,
                                 const std::string& what, const std::string& allowed) {
  throw InvalidInput(
      fmt::format("{}: line {}: {}: {}; allowed: {}", file, line, key, what, allowed));
}

/// A scalar as one would type it.
std::string scalar(const toml::node& node, const std::string& file, const std::string& key) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  refuse_at_line(file, node.source().begin.line, key, "not a text or number",
                 "\"a text\" or a number");
}

std::map<std::string, std::string> pairs_of(const toml::node& node, const std::string& file,
                                            const std::string& key) {
  const toml::table* table = node.as_table();
  if (table == nullptr)
    refuse_at_line(file, node.source().begin.line, key, "not a table", "{ name = \"text\", ... }");
  std::map<std::string, std::string> pairs;
  for (const auto& [name, value] : *table)
    pairs[std::string(name.str())] = scalar(value, file, key + "." + std::string(name.str()));
  return pairs;
}

}  // namespace

ContentTable::ContentTable(const std::filesystem::path& file) : data_(std::make_unique<Data>()) {
  data_->file = file.string();
  const std::string text = text_of(file);
  if (has_endless_key(text))
    throw InvalidInput(data_->file +
                       ": a key of more than 1000 parts; allowed: lines like id = \"x\"");
  try {
    data_->root = std::make_shared<const toml::table>(toml::parse(text));
    data_->table = data_->root.get();
  } catch (const toml::parse_error& error) {
    throw InvalidInput(
        fmt::format("{}: line {}: not valid TOML: {}; allowed: lines like id = \"x\"", data_->file,
                    error.source().begin.line, shown_text(error.description(), 200)));
  }
}

ContentTable::ContentTable(std::unique_ptr<Data> data) : data_(std::move(data)) {}
ContentTable::ContentTable(ContentTable&&) noexcept = default;
ContentTable::~ContentTable() = default;

void ContentTable::refuse(const std::string& key, const std::string& what,
                          const std::string& allowed) const {
  constexpr std::size_t slips = 2;
  if (what == "missing")  // or misspelt
    for (const auto& [name, value] : *data_->table)
      if (!data_->asked.contains(std::string(name.str())) &&
          edit_distance(name.str(), key) <= slips)
        refuse_at_line(data_->file, value.source().begin.line, shown_text(std::string(name.str())),
                       "unknown key; did you mean " + key + "?", allowed);
  const toml::node* node = data_->table->get(key);
  refuse_at_line(data_->file, node == nullptr ? data_->line : node->source().begin.line, key, what,
                 allowed);
}

bool ContentTable::has(const std::string& key) {
  data_->asked.insert(key);
  return data_->table->contains(key);
}

std::string ContentTable::text(const std::string& key) {
  if (!has(key)) refuse(key, "missing", "a line like " + key + " = \"...\"");
  return scalar(*data_->table->get(key), data_->file, key);
}

std::string ContentTable::text(const std::string& key, const std::string& otherwise) {
  return has(key) ? text(key) : otherwise;
}

double ContentTable::number(const std::string& key, double otherwise) {
  if (!has(key)) return otherwise;
  const auto value = data_->table->get(key)->value<double>();
  if (!value || !(*value >= 0)) refuse(key, "not a number", "a number that is not negative");
  return *value;
}

long ContentTable::whole(const std::string& key, long least, long most) {
  const std::string allowed = fmt::format("a whole number from {} to {}", least, most);
  if (!has(key)) refuse(key, "missing", allowed);
  const auto* value = data_->table->get(key)->as_integer();
  if (value == nullptr || value->get() < least || value->get() > most)
    refuse(key, "got " + shown_text(scalar(*data_->table->get(key), data_->file, key)), allowed);
  return static_cast<long>(value->get());
}

std::vector<std::string> ContentTable::texts(const std::string& key) {
  if (!has(key)) return {};
  const toml::array* array = data_->table->get(key)->as_array();
  if (array == nullptr) refuse(key, "not a list", "[\"a text\", ...]");
  std::vector<std::string> texts;
  for (const toml::node& node : *array) texts.push_back(scalar(node, data_->file, key));
  return texts;
}

std::vector<std::vector<std::string>> ContentTable::rows(const std::string& key) {
  if (!has(key)) return {};
  const toml::array* array = data_->table->get(key)->as_array();
  std::vector<std::vector<std::string>> rows;
  if (array == nullptr) refuse(key, "not a list", "[[1, 2], [3, 4]]");
  for (const toml::node& node : *array) {
    const toml::array* row = node.as_array();
    if (row == nullptr) refuse(key, "not a list of lists", "[[1, 2], [3, 4]]");
    rows.emplace_back();
    for (const toml::node& cell : *row) rows.back().push_back(scalar(cell, data_->file, key));
  }
  return rows;
}

std::map<std::string, std::string> ContentTable::pairs(const std::string& key) {
  if (!has(key)) return {};
  return pairs_of(*data_->table->get(key), data_->file, key);
}

std::vector<std::map<std::string, std::string>> ContentTable::records(const std::string& key) {
  if (!has(key)) return {};
  const toml::array* array = data_->table->get(key)->as_array();
  if (array == nullptr) refuse(key, "not a list", "[{ k = 1 }, { k = 2 }]");
  std::vector<std::map<std::string, std::string>> records;
  for (const toml::node& node : *array) records.push_back(pairs_of(node, data_->file, key));
  return records;
}

ContentTable ContentTable::table(const std::string& key) {
  if (!has(key)) refuse(key, "missing", "a section [" + key + "]");
  const toml::table* inner = data_->table->get(key)->as_table();
  if (inner == nullptr) refuse(key, "not a table", "a section [" + key + "]");
  auto data = std::make_unique<Data>();
  data->file = data_->file;
  data->root = data_->root;
  data->table = inner;
  data->line = data_->table->get(key)->source().begin.line;
  return ContentTable(std::move(data));
}

std::vector<ContentTable> ContentTable::tables(const std::string& key) {
  std::vector<ContentTable> tables;
  if (!has(key)) return tables;
  const toml::array* array = data_->table->get(key)->as_array();
  if (array == nullptr) refuse(key, "not a list of tables", "sections [[" + key + "]]");
  for (const toml::node& node : *array) {
    if (!node.is_table()) refuse(key, "not a list of tables", "sections [[" + key + "]]");
    auto data = std::make_unique<Data>();
    data->file = data_->file;
    data->root = data_->root;
    data->table = node.as_table();
    data->line = node.source().begin.line;
    tables.push_back(ContentTable(std::move(data)));
  }
  return tables;
}

void ContentTable::finish() const {
  std::string allowed;
  for (const std::string& key : data_->asked) allowed += (allowed.empty() ? "" : ", ") + key;
  const std::vector<std::string_view> keys(data_->asked.begin(), data_->asked.end());
  for (const auto& [key, value] : *data_->table)
    if (!data_->asked.contains(std::string(key.str()))) {
      const auto nearest = nearest_key(key.str(), keys);
      refuse(std::string(key.str()),
             nearest ? fmt::format("unknown key; did you mean {}?", *nearest) : "unknown key",
             allowed);
    }
}

}  // namespace magicmass::command
