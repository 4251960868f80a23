// SPDX-License-Identifier: GPL-2.0-or-later
// Answers as text, JSON or CSV: one record, or many with the same columns.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "command/destination.hpp"

namespace CLI {
class App;
}

namespace magicmass::command {

/// So many rows are kept until a run is over, where they are not written as they come: a gigabyte or so.
inline constexpr std::int64_t most_kept = 4'000'000;

/// --format and -o of a command.
struct OutputOptions {
  std::string format = "text";
  std::string path;
};

/// Adds --format, with these names allowed (text is the default), and -o.
void add_output_options(CLI::App& command, OutputOptions& options,
                        const std::vector<std::string>& formats = {"text", "json", "csv"});

/// One value as it is printed. JSON quotes it or not; a missing value is null there and empty in CSV.
struct Cell {
  std::string text;
  bool quoted = false;
};

Cell text_cell(std::string text);
Cell number_cell(double value);  ///< shortest decimal that reads back as the same double
Cell number_cell(long double value);
Cell number_cell(std::int64_t value);
Cell digits_cell(std::string digits);  ///< an integer of any size, written unquoted
Cell missing_cell();

bool is_utf8(std::string_view text);
std::string json_string(std::string_view text);  ///< what is not UTF-8 becomes U+FFFD
std::string json_array(const std::vector<std::string>& texts);
std::string json_value(const Cell& cell);
/// {"a": 1, "b": "2"}; names and cells of one length.
std::string json_object(const std::vector<std::string>& names, const std::vector<Cell>& cells);
std::string csv_line(const std::vector<Cell>& cells);

/// Writes records one by one, those of a text when all are there: its columns are as wide as they need to be. `single`
/// writes the only record as a JSON object, else they form an array.
class RecordWriter {
public:
  RecordWriter(Destination& output, std::string format, std::vector<std::string> columns,
               bool single);
  void write(const std::vector<Cell>& cells);
  void finish();

private:
  Destination& output_;
  std::string format_;
  std::vector<std::string> columns_;
  bool single_;
  std::vector<std::vector<Cell>> kept_;
  std::size_t written_ = 0;
};

}  // namespace magicmass::command
