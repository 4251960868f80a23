// Answers are tables that know their columns; they are written as text, JSON or CSV. What an answer
// throws instead: one line, fit to be shown.
#pragma once

#include <functional>
#include <initializer_list>
#include <span>
#include <utility>
#include <variant>

#include "kernel/expr.hpp"
#include "magicmass/numbers/errors.hpp"

namespace answers {

using magicmass::InvalidInput;  ///< exit code 2
using magicmass::Undecided;     ///< exit code 3

/// What it gives; what it throws as Thrown is thrown as Instead, after `before`.
template <class Thrown, class Instead = Thrown>
auto with_place(const std::string& before, const auto& action) try {
  return action();
} catch (const std::bad_alloc&) {
  throw;  // no place is to blame
} catch (const Thrown& error) {
  throw Instead(before + error.what());
}
/// The same of what a user gave.
auto given_by_user(const std::string& before, const auto& action) {
  return with_place<kernel::Refused, InvalidInput>(before, action);
}

/// Printable ASCII, Greek letters and signs of formulas as they are, other bytes as \xHH, so that
/// no terminal obeys them; cut with "..." after so many bytes; "(nothing)" where there are none.
std::string shown_text(std::string_view text, std::size_t longest = 60);

/// A text of each: texts_of(figures, &Figure::name).
std::vector<std::string> texts_of(const auto& all, const auto& of) {
  std::vector<std::string> texts;
  for (const auto& one : all) texts.push_back(std::invoke(of, one));
  return texts;
}
std::string joined(const std::vector<std::string>& texts, std::string_view between = ", ");

using Names = std::vector<std::string>;

/// A value as text and CSV write it, and as JSON does; as CSV does where that differs from text.
struct Cell {
  std::string text;
  std::string json;
  std::string csv = {};
};

/// As printf prints it: "%.4g".
std::string formatted(const std::string& format, double value);
/// Text in UTF-8, what others typed after shown_text(); "p/q" and digits too long for JSON, too.
Cell text_cell(std::string_view text);
/// The shortest decimal that reads back as the same double; 0 for -0; missing where not finite.
Cell real_cell(double value);
/// A whole number of any size from its decimal digits: a number in JSON, too.
Cell whole_cell(const std::string& digits);
Cell whole_cell(std::integral auto value) { return whole_cell(std::to_string(value)); }
/// Several texts: "a; b" and ["a", "b"].
Cell list_cell(const std::vector<std::string>& texts);
using Fields = std::vector<std::pair<std::string, Cell>>;
/// "A 0, C 0.5" and {"A": 0, "C": 0.5}
Cell object_cell(const Fields& fields);
/// There is none: "-" in text, nothing in CSV, null in JSON.
Cell missing_cell();
/// No number: in CSV inf, which programs read as one, null in JSON.
Cell endless_cell();

using Row = std::vector<Cell>;  ///< as long as there are columns
Row real_cells(const std::vector<double>& values);
/// The cells of one row after those of the other.
Row concatenated(std::initializer_list<Row> parts);

/// Many rows as columns of numbers, which are written without a cell for each.
struct Block {
  /// A cell is the same in each row.
  using Numbers = std::variant<std::vector<double>, std::vector<std::int64_t>, Cell>;
  Names names;
  std::vector<Numbers> columns = {};

  /// A row without an answer ends in NaN or -1; without columns none has one.
  bool answers(std::size_t row) const;
};

struct Table {
  Names columns;
  std::vector<Row> rows;
  bool is_list = true;  ///< else the one row is the answer: a JSON object, a block of text
};
/// The one row of an answer, its cells with their columns' names.
Table one_row(const Fields& fields);

enum class Format { text, json, json_lines, csv };  // JSON Lines: an object a line
/// Of --format; text where it is none of tables.
Format format_of(const std::string& name);

/// Writes rows as they come, a block at a time. Text has 80 columns: a table that the first block
/// shows to be wider becomes a block of lines a row, and later blocks keep the first one's widths.
class Writer {
public:
  Writer(Format format, Names columns, bool is_list);
  /// What follows for these rows; the first call of this or the next writes the header too.
  std::string rows(std::span<const Row> block);
  /// Appends a row of the block to the text; in the format text never the first row.
  void append(std::string& text, const Block& block, std::size_t row);
  /// What ends the whole, after one call of rows() at least.
  std::string end() const;

private:
  Format format_;
  Names columns_;
  bool is_list_;
  std::string opening_;              // not yet written
  bool is_first_ = true;             // no row is written
  std::vector<std::string> before_;  // each field, such as its name in JSON
  std::vector<std::size_t> widths_;  // empty: a block of lines a row

  /// As wide as these rows need.
  void open_text(std::span<const Row> block);
  void append_row(std::string& text, const auto& append_field);
};

std::string written(const Table& table, Format format);
Table selected(const Table& table, const Names& names);
/// A heading above the table, in text or Markdown; nothing where that has no rows.
std::string section(const std::string& heading, const Table& table, bool is_markdown);

}  // namespace answers
