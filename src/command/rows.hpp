// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of CSV, one after the other: never more than a line of them in memory.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace command {

/// A header line names the columns. Fields may be quoted as in RFC 4180 (within their line) or have
/// blanks around them; lines end with LF or CRLF; a byte-order mark is skipped, and empty lines at
/// the end. Throws answers::InvalidInput, "FILE:LINE: what", for anything else.
class CsvReader {
public:
  /// Opens a file, or stdin for "-", and reads its header; columns that are not wanted are skipped.
  CsvReader(const std::string& path, std::vector<std::string> wanted);

  /// The wanted columns that are there.
  const std::vector<std::string>& columns() const { return columns_; }
  /// The fields of the next row by column, none of them empty; nothing after the last.
  std::optional<std::map<std::string, std::string>> next();
  /// "FILE:LINE: " of the last row.
  std::string place() const;

private:
  struct Close {
    void operator()(std::FILE* file) const {
      if (file != stdin) std::fclose(file);
    }
  };
  std::string source_;
  std::unique_ptr<std::FILE, Close> file_;
  std::int64_t line_ = 0;
  std::vector<std::string> names_;  // of all columns, "" for one that is not wanted
  std::vector<std::string> columns_;

  std::optional<std::string> next_line();
  std::vector<std::string> fields_of(const std::string& line) const;
  [[noreturn]] void refuse(const std::string& what) const;
};

}  // namespace command
