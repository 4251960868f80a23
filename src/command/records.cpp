// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/records.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "command/program.hpp"

namespace magicmass::command {
namespace {

constexpr std::size_t widest_table = 80;

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char character : text)
    quoted += character == '"' ? std::string("\"\"") : std::string(1, character);
  return quoted + "\"";
}

std::string shown(const Cell& cell) { return cell.text.empty() ? "-" : cell.text; }

/// One record, a line for each of its values.
std::string text_block(const std::vector<std::string>& columns, const std::vector<Cell>& cells) {
  std::size_t width = 0;
  for (const std::string& column : columns) width = std::max(width, column.size() + 2);
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i)
    text += fmt::format("{:<{}}{}\n", columns[i], width, shown(cells[i]));
  return text;
}

/// A line for each record; where that is too wide to be read, a block.
std::string text_table(const std::vector<std::string>& columns,
                       const std::vector<std::vector<Cell>>& records) {
  std::vector<std::size_t> widths;
  std::size_t all = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::size_t width = columns[i].size();
    for (const std::vector<Cell>& cells : records) width = std::max(width, shown(cells[i]).size());
    widths.push_back(width + 2);
    all += width + 2;
  }
  std::string text;
  if (all - 2 > widest_table && !records.empty()) {
    for (const std::vector<Cell>& cells : records)
      text += (text.empty() ? "" : "\n") + text_block(columns, cells);
    return text;
  }
  const auto line = [&](const auto& text_at) {
    std::string row;
    for (std::size_t i = 0; i < columns.size(); ++i)
      row += fmt::format("{:<{}}", text_at(i), widths[i]);
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  };
  line([&](std::size_t i) { return columns[i]; });
  for (const std::vector<Cell>& cells : records)
    line([&](std::size_t i) { return shown(cells[i]); });
  return text;
}

}  // namespace

void add_output_options(CLI::App& command, OutputOptions& options,
                        const std::vector<std::string>& formats) {
  CLI::Option& format =
      *command.add_option("--format", options.format, fmt::format("{}", fmt::join(formats, ", ")))
           ->type_name("FORMAT")
           ->check([formats](const std::string& name) {
             const bool known = std::find(formats.begin(), formats.end(), name) != formats.end();
             return known ? std::string()
                          : fmt::format("unknown format \"{}\"; allowed: {}", name,
                                        fmt::join(formats, ", "));
           });
  offer(format, formats);
  command
      .add_option("-o,--output", options.path, "write to FILE, whole or not at all; - is stdout")
      ->type_name("FILE");
}

Cell text_cell(std::string text) { return {std::move(text), true}; }

Cell number_cell(double value) {
  if (!std::isfinite(value)) return missing_cell();
  return {fmt::format("{}", value == 0 ? 0.0 : value), false};  // a product's -0 is shown as 0
}

Cell number_cell(long double value) {
  if (!std::isfinite(value)) return missing_cell();
  std::array<char, 64>
      text{};  // to_chars: fmt takes a hundred times as long where exponents are large
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0L : value).ptr;
  return {std::string(text.data(), end), false};
}

Cell number_cell(std::int64_t value) { return {std::to_string(value), false}; }

Cell digits_cell(std::string digits) { return {std::move(digits), false}; }

Cell missing_cell() { return {}; }

namespace {

/// What is not UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text) {
  const nlohmann::json json = text;
  const auto replace = nlohmann::json::error_handler_t::replace;
  return nlohmann::json::parse(json.dump(-1, ' ', false, replace)).get<std::string>();
}

}  // namespace

bool is_utf8(std::string_view text) { return valid_utf8(text) == text; }

std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  const bool is_ascii =
      std::all_of(text.begin(), text.end(), [](char c) { return (c & 0x80) == 0; });
  for (const char character : is_ascii ? std::string(text) : valid_utf8(text)) {
    if (character == '"' || character == '\\')
      quoted += {'\\', character};
    else if (static_cast<unsigned char>(character) < 0x20)
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(character));
    else
      quoted += character;
  }
  return quoted + "\"";
}

std::string json_array(const std::vector<std::string>& texts) {
  std::string array;
  for (const std::string& text : texts) array += (array.empty() ? "" : ", ") + json_string(text);
  return "[" + array + "]";
}

std::string json_value(const Cell& cell) {
  if (cell.quoted) return json_string(cell.text);
  return cell.text.empty() ? "null" : cell.text;
}

std::string json_object(const std::vector<std::string>& names, const std::vector<Cell>& cells) {
  std::string object;
  for (std::size_t i = 0; i < names.size(); ++i)
    object += (i == 0 ? "" : ", ") + json_string(names[i]) + ": " + json_value(cells[i]);
  return "{" + object + "}";
}

std::string csv_line(const std::vector<Cell>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i == 0 ? "" : ",") + csv_field(cells[i].text);
  return line + "\n";
}

RecordWriter::RecordWriter(Destination& output, std::string format,
                           std::vector<std::string> columns, bool single)
    : output_(output), format_(std::move(format)), columns_(std::move(columns)), single_(single) {
  std::vector<Cell> header;
  header.reserve(columns_.size());
  for (const std::string& column : columns_) header.push_back(text_cell(column));
  if (format_ == "csv") output_.write(csv_line(header));
}

void RecordWriter::write(const std::vector<Cell>& cells) {
  if (format_ == "csv") {
    output_.write(csv_line(cells));
  } else if (format_ == "json") {
    if (!single_) output_.write(written_ == 0 ? "[\n" : ",\n");
    output_.write(json_object(columns_, cells));
  } else if (single_) {
    output_.write(text_block(columns_, cells));
  } else {
    kept_.push_back(cells);
  }
  ++written_;
}

void RecordWriter::finish() {
  if (format_ == "text" && !single_) output_.write(text_table(columns_, kept_));
  if (format_ != "json") return;
  if (!single_) output_.write(written_ == 0 ? "[]" : "\n]");
  output_.write("\n");
}

}  // namespace magicmass::command
