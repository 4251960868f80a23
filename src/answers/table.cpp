// Writing is ours since counts are integers of any size, which JSON libraries do not hold.
#include "answers/table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace answers {
namespace {

constexpr std::size_t widest_text = 80;
constexpr std::size_t between_columns = 2;

std::string json_string(std::string_view text) {
  constexpr std::string_view hex = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20)
      quoted += std::string("\\u00") + hex[byte / 16U] + hex[byte % 16U];
    else
      quoted.append(byte == '"' || byte == '\\' ? "\\" : "").append(1, character);
  }
  return quoted + "\"";
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char character : text) quoted.append(character == '"' ? 2 : 1, character);
  return quoted + "\"";
}

std::string shown(const Cell& cell) { return cell.text.empty() ? "-" : cell.text; }

/// Characters, where bytes 10xxxxxx go on with one.
std::size_t width(std::string_view text) {
  return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Adds blanks to what the text has from there on, two at least.
void pad(std::string& text, std::size_t from, std::size_t to) {
  const std::size_t has = width(std::string_view(text).substr(from));
  text.append(std::max(has, to) - has + between_columns, ' ');
}

/// The width of each column, or none where they do not fit together.
std::vector<std::size_t> widths_of(const Names& columns, std::span<const Row> rows) {
  std::vector<std::size_t> widths;
  std::size_t all = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::size_t widest = width(columns[i]);
    for (const Row& row : rows) widest = std::max(widest, width(shown(row.at(i))));
    widths.push_back(widest);
    all += widest + between_columns;
  }
  return all > widest_text + between_columns ? std::vector<std::size_t>() : widths;
}

/// In the fewest digits that read back as it; -0 as 0.
void append_number(std::string& text, auto value) {
  constexpr std::size_t longest = 32;
  text.resize(text.size() + longest);
  char* const end = text.data() + text.size();
  text.resize(std::size_t(std::to_chars(end - longest, end, value + 0).ptr - text.data()));
}

/// Broken at commas, or else blanks, where it would be too wide; lines below the first indented.
std::string wrapped_cell(const std::string& text, std::size_t indent) {
  const std::size_t room = widest_text - indent;
  std::string lines;
  std::string_view rest = text;
  for (std::size_t left = width(text); left > room;) {
    const std::string_view line = rest.substr(0, room + 1);
    const std::size_t comma = line.rfind(", ");
    const bool is_late = comma != line.npos && comma > line.size() * 2 / 3;
    const std::size_t blank = is_late ? comma + 1 : line.rfind(' ');
    if (blank == line.npos) break;
    left -= width(rest.substr(0, blank + 1));
    lines.append(rest.substr(0, blank)).append("\n").append(indent, ' ');
    rest.remove_prefix(blank + 1);
  }
  return lines.append(rest);
}

}  // namespace

Format format_of(const std::string& name) {
  return name == "json"    ? Format::json
         : name == "csv"   ? Format::csv
         : name == "jsonl" ? Format::json_lines
                           : Format::text;
}

std::string formatted(const std::string& format, double value) {
  std::array<char, 400> text{};  // any double fits, with dozens of decimals
  std::snprintf(text.data(), text.size(), format.c_str(), value);
  return text.data();
}

Cell text_cell(std::string_view text) { return {std::string(text), json_string(text)}; }

Cell real_cell(double value) {
  if (!std::isfinite(value)) return missing_cell();
  std::string text;
  append_number(text, value);
  return {text, text};
}

Row real_cells(const std::vector<double>& values) {
  Row row;
  for (const double value : values) row.push_back(real_cell(value));
  return row;
}

Row concatenated(std::initializer_list<Row> parts) {
  Row row;
  for (const Row& part : parts) row.insert(row.end(), part.begin(), part.end());
  return row;
}

Cell whole_cell(const std::string& digits) { return {digits, digits}; }
Cell missing_cell() { return {"", "null"}; }
Cell endless_cell() { return {"infinitely many", "null", "inf"}; }

Cell list_cell(const std::vector<std::string>& texts) {
  return {joined(texts, "; "), "[" + joined(texts_of(texts, json_string)) + "]"};
}

Cell object_cell(const Fields& fields) {
  const auto text = [](const auto& field) { return field.first + " " + field.second.text; };
  std::string json = written(one_row(fields), Format::json);
  json.pop_back();  // the line's end
  return {joined(texts_of(fields, text)), json};
}

Table one_row(const Fields& fields) {
  Table table{{}, {{}}, false};
  for (const auto& [name, cell] : fields) {
    table.columns.push_back(name);
    table.rows[0].push_back(cell);
  }
  return table;
}

Writer::Writer(Format format, Names columns, bool is_list)
    : format_(format), columns_(std::move(columns)), is_list_(is_list) {
  for (const std::string& column : columns_) {
    before_.push_back(before_.empty() ? "" : format == Format::csv ? "," : ", ");
    if (format != Format::csv) before_.back() += json_string(column) + ": ";
  }
  if (format == Format::csv) opening_ = joined(columns_, ",") + "\n";
  if (format == Format::json && is_list) opening_ = "[";
}

bool Block::answers(std::size_t row) const {
  if (columns.empty()) return false;
  const auto* reals = std::get_if<std::vector<double>>(&columns.back());
  return reals ? !std::isnan((*reals)[row])
               : std::get<std::vector<std::int64_t>>(columns.back())[row] >= 0;
}

void Writer::open_text(std::span<const Row> block) {
  if (is_list_) widths_ = widths_of(columns_, block);
  before_.assign(columns_.size(), "");
  if (!widths_.empty()) return append_row(opening_, [&](auto i) { opening_ += columns_[i]; });
  std::size_t widest = 0;
  for (const std::string& column : columns_) widest = std::max(widest, width(column));
  for (std::size_t i = 0; i < columns_.size(); ++i)
    pad(before_[i] = (i == 0 ? "" : "\n") + columns_[i], i == 0 ? 0 : 1, widest);
}

void Writer::append_row(std::string& text, const auto& append_field) {
  const bool is_text = format_ == Format::text, is_table = !widths_.empty();
  const bool is_object = !is_text && format_ != Format::csv;
  if (format_ == Format::json && is_list_) text += is_first_ ? "\n" : ",\n";
  if (is_text && !is_table && !is_first_) text += '\n';
  if (is_object) text += '{';
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    text += before_[i];
    const std::size_t from = text.size();
    append_field(i);
    if (is_table) pad(text, from, widths_[i]);
  }
  if (is_table) text.erase(text.find_last_not_of(' ') + 1);
  text += !is_object ? "\n" : format_ == Format::json ? "}" : "}\n";
  is_first_ = false;
}

std::string Writer::rows(std::span<const Row> block) {
  if (format_ == Format::text && is_first_) open_text(block);
  std::string text = std::exchange(opening_, "");
  for (const Row& row : block) {
    append_row(text, [&](std::size_t i) {
      const Cell& cell = row.at(i);
      text += format_ == Format::csv    ? csv_field(cell.csv.empty() ? cell.text : cell.csv)
              : format_ != Format::text ? cell.json
              : widths_.empty()         ? wrapped_cell(shown(cell), width(before_[0]))
                                        : shown(cell);
    });
  }
  return text;
}

void Writer::append(std::string& text, const Block& block, std::size_t row) {
  if (!opening_.empty()) text += std::exchange(opening_, "");
  append_row(text, [&](std::size_t i) {
    if (const auto* cell = std::get_if<Cell>(&block.columns[i]))
      text += format_ == Format::csv || format_ == Format::text ? cell->text : cell->json;
    else if (const auto* wholes = std::get_if<std::vector<std::int64_t>>(&block.columns[i]))
      append_number(text, (*wholes)[row]);
    else
      append_number(text, std::get<std::vector<double>>(block.columns[i])[row]);
  });
}

std::string Writer::end() const {
  if (format_ != Format::json) return "";
  if (!is_list_) return "\n";
  return is_first_ ? "]\n" : "\n]\n";
}

std::string written(const Table& table, Format format) {
  Writer writer(format, table.columns, table.is_list);
  const std::string text = writer.rows(table.rows);
  return text + writer.end();
}

Table selected(const Table& table, const Names& names) {
  Table some{names, {}};
  for (const Row& row : table.rows) {
    some.rows.emplace_back();
    for (const std::string& name : names)
      some.rows.back().push_back(
          row.at(std::size_t(std::ranges::find(table.columns, name) - table.columns.begin())));
  }
  return some;
}

std::string section(const std::string& heading, const Table& table, bool is_markdown) {
  if (table.rows.empty()) return "";
  if (!is_markdown) return "\n" + heading + "\n\n" + written(table, Format::text);
  std::string text = "\n## " + heading + "\n\n| " + joined(table.columns, " | ") + " |\n|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += "---|";
  for (const Row& row : table.rows) {
    text += "\n|";
    for (const Cell& cell : row) text += " " + shown(cell) + " |";
  }
  return text + "\n";
}

}  // namespace answers
