// SPDX-License-Identifier: GPL-2.0-or-later
// A TOML file of an exercise, read key by key; what was not asked for is refused by name at the end.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace magicmass::command {

class ContentTable {
public:
  /// Throws InvalidInput: "FILE: line 3: not valid TOML: ...".
  explicit ContentTable(const std::filesystem::path& file);
  ~ContentTable();
  ContentTable(ContentTable&&) noexcept;
  ContentTable(const ContentTable&) = delete;
  ContentTable& operator=(const ContentTable&) = delete;
  ContentTable& operator=(ContentTable&&) = delete;

  bool has(const std::string& key);
  std::string text(const std::string& key);  ///< required
  std::string text(const std::string& key, const std::string& otherwise);
  double number(const std::string& key, double otherwise);
  long whole(const std::string& key, long least, long most);  ///< required
  std::vector<std::string> texts(const std::string& key);
  std::vector<std::vector<std::string>> rows(const std::string& key);  ///< an array of arrays
  std::map<std::string, std::string> pairs(const std::string& key);    ///< a table of texts
  std::vector<std::map<std::string, std::string>> records(const std::string& key);
  std::vector<ContentTable> tables(const std::string& key);  ///< an array of tables
  ContentTable table(const std::string& key);

  /// "FILE: line 3: KEY: WHAT; allowed: ALLOWED".
  [[noreturn]] void refuse(const std::string& key, const std::string& what,
                           const std::string& allowed) const;
  /// Every key must have been asked for.
  void finish() const;

private:
  struct Data;
  explicit ContentTable(std::unique_ptr<Data> data);
  std::unique_ptr<Data> data_;
};

}  // namespace magicmass::command
