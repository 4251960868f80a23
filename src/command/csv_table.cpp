// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/csv_table.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include <fmt/format.h>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

std::string read_all(std::istream& stream, const std::string& source) {
  constexpr std::size_t longest = 100'000'000;
  std::string text;
  std::vector<char> buffer(1U << 16U);
  do {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > longest) throw InvalidInput(source + ": larger than 100 megabytes");
  } while (stream);
  return text;
}

std::string read_all(const std::string& path, const std::string& source) {
  if (path == "-") return read_all(std::cin, source);
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  if (!file.is_open() || std::filesystem::is_directory(path, error))
    throw InvalidInput(source + ": cannot be read; allowed: a CSV file");
  return read_all(file, source);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t begin = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(line);
    begin = end + 1;
  }
  while (!lines.empty() && lines.back().find_first_not_of(" \t") == std::string::npos)
    lines.pop_back();
  return lines;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// The fields of one line; quotes as in RFC 4180, but a quoted field ends in its own line.
std::vector<std::string> fields_of(const std::string& line, const std::string& place) {
  std::vector<std::string> fields;
  std::size_t at = 0;
  for (;;) {
    const std::size_t first = line.find_first_not_of(" \t", at);
    if (first == std::string::npos || line[first] != '"') {
      const std::size_t end = std::min(line.find(',', at), line.size());
      fields.push_back(trimmed(line.substr(at, end - at)));
      at = end;
    } else {
      std::string field;
      at = first + 1;
      for (;; ++at) {
        if (at >= line.size()) throw InvalidInput(place + "a quoted field has no closing quote");
        if (line[at] == '"' && line.substr(at, 2) != "\"\"") break;
        if (line[at] == '"') ++at;
        field += line[at];
      }
      fields.push_back(field);
      at = std::min(line.find_first_not_of(" \t", at + 1), line.size());
      if (at < line.size() && line[at] != ',')
        throw InvalidInput(place +
                           "something follows a quoted field; allowed: a comma or the line's end");
    }
    if (at >= line.size()) return fields;
    ++at;
  }
}

}  // namespace

CsvTable parse_csv(const std::string& text, const std::string& source,
                   const std::vector<std::string>& headers) {
  CsvTable table{source, "", {}};
  const std::vector<std::string> lines = lines_of(text);
  const auto place = [&](std::size_t i) { return fmt::format("{}:{}: ", table.source, i + 1); };
  const std::vector<std::string> names =
      lines.empty() ? std::vector<std::string>{} : fields_of(lines.front(), place(0));
  table.header = fmt::format("{}", fmt::join(names, ","));
  for (const std::string& name : names)
    if (name.find(',') != std::string::npos)
      throw InvalidInput(fmt::format("{}the column \"{}\" has a comma in its name; allowed: {}",
                                     place(0), shown_text(name), fmt::join(headers, " or ")));
  if (std::find(headers.begin(), headers.end(), table.header) == headers.end())
    throw InvalidInput(fmt::format("{}the first line must name the columns, got {}; allowed: {}",
                                   place(0), shown_text(table.header), fmt::join(headers, " or ")));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> fields = fields_of(lines[i], place(i));
    if (fields.size() > names.size())
      throw InvalidInput(fmt::format("{}{} fields where the header names {}: column {} is too many",
                                     place(i), fields.size(), names.size(), names.size() + 1));
    if (fields.size() < names.size())
      throw InvalidInput(fmt::format("{}{}: missing; allowed: {} fields a line, as in the header",
                                     place(i), names[fields.size()], names.size()));
    for (std::size_t column = 0; column < fields.size(); ++column)
      if (fields[column].empty())
        throw InvalidInput(
            fmt::format("{}{}: empty; allowed: a number in every field", place(i), names[column]));
    table.rows.push_back({static_cast<unsigned>(i + 1), fields});
  }
  return table;
}

CsvTable read_csv(const std::string& path, const std::vector<std::string>& headers) {
  const std::string source = path == "-" ? "stdin" : shown_text(path, 200);
  return parse_csv(read_all(path, source), source, headers);
}

}  // namespace magicmass::command
