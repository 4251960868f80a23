// SPDX-License-Identifier: GPL-2.0-or-later
// Reading by bytes: what a file holds decides, not its locale.
#include "command/rows.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"

namespace command {
namespace {

using answers::shown_text;

constexpr std::size_t longest_line = std::size_t{1} << 16U;

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t") == std::string::npos;
}

std::string trimmed(const std::string& text) {
  if (is_blank(text)) return "";
  const std::size_t begin = text.find_first_not_of(" \t");
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

}  // namespace

CsvReader::CsvReader(const std::string& path, std::vector<std::string> wanted)
    : source_(path == "-" ? "stdin" : shown_text(path, 200)),
      file_(path == "-" ? stdin : std::fopen(path.c_str(), "rb")) {
  if (!file_) {
    throw answers::InvalidInput("cannot read " + source_ + ": " +
                                std::generic_category().message(errno));
  }
  const std::string allowed = answers::joined(wanted);
  std::string header = next_line().value_or("");
  if (header.starts_with("\xEF\xBB\xBF")) header.erase(0, 3);
  for (const std::string& name : fields_of(header)) {
    const bool is_wanted = std::count(wanted.begin(), wanted.end(), name) != 0;
    if (is_wanted && std::count(names_.begin(), names_.end(), name) != 0)
      refuse(name + ": a column of that name was there before");
    names_.push_back(is_wanted ? name : "");
    if (is_wanted) columns_.push_back(name);
  }
  if (columns_.empty()) {
    refuse("the first line must name a column, got " + shown_text(header) +
           "; allowed: " + allowed);
  }
}

void CsvReader::refuse(const std::string& what) const {
  throw answers::InvalidInput(place() + what);
}

std::string CsvReader::place() const { return source_ + ":" + std::to_string(line_) + ": "; }

std::optional<std::string> CsvReader::next_line() {
  std::string line;
  ++line_;
  int byte = std::getc(file_.get());
  if (byte == EOF && std::ferror(file_.get()) == 0) return std::nullopt;
  for (; byte != EOF && byte != '\n'; byte = std::getc(file_.get())) {
    if (byte == 0) refuse("a zero byte; allowed: text");
    if (line.size() == longest_line)
      refuse("a line of more than " + std::to_string(longest_line) + " bytes");
    line += static_cast<char>(byte);
  }
  if (std::ferror(file_.get()) != 0) {
    throw answers::InvalidInput("cannot read " + source_ + ": " +
                                std::generic_category().message(errno));
  }
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

std::vector<std::string> CsvReader::fields_of(const std::string& line) const {
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
      for (at = first + 1; at < line.size(); ++at) {
        if (line[at] == '"' && line.compare(at, 2, "\"\"") != 0) break;
        at += line[at] == '"' ? 1 : 0;
        field += line[at];
      }
      if (at >= line.size()) refuse("a quoted field has no closing quote");
      fields.push_back(field);
      at = std::min(line.find_first_not_of(" \t", at + 1), line.size());
      if (at < line.size() && line[at] != ',')
        refuse("something follows a quoted field; allowed: a comma or the line's end");
    }
    if (at >= line.size()) return fields;
    ++at;
  }
}

std::optional<std::map<std::string, std::string>> CsvReader::next() {
  std::optional<std::string> line = next_line();
  const std::int64_t first = line_;
  bool is_end = true;
  while (line && is_blank(*line)) {
    is_end = false;
    line = next_line();
  }
  if (!line) return std::nullopt;
  if (!is_end) {
    line_ = first;
    refuse("an empty line; allowed: at the end");
  }
  const std::vector<std::string> fields = fields_of(*line);
  if (fields.size() != names_.size()) {
    refuse(std::to_string(fields.size()) + " fields where the header names " +
           std::to_string(names_.size()));
  }
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (names_[i].empty()) continue;
    if (fields[i].empty()) refuse(names_[i] + ": empty; allowed: a value in every field");
    row[names_[i]] = fields[i];
  }
  return row;
}

}  // namespace command
