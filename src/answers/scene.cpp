// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/scene.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "magicmass/numbers/errors.hpp"
#include "magicmass/scenes/trajectory.hpp"

namespace answers {
namespace {

using namespace magicmass::scenes;

/// What was asked, and what came of it.
struct Asked {
  Scene scene;
  Result result;
};

Asked asked(const Request& request, const std::string& command) {
  if (request.words.size() != 1)
    throw InvalidInput(command + ": give one scene, a file; example: " + command + " wall.toml");
  try {
    Scene scene = read_scene(request.words.front());
    scene.is_exact = request.has("exact");
    if (const auto most = request.whole("max-events", 0, INT64_MAX)) scene.max_events = most;
    Result result = run(scene);
    return {std::move(scene), std::move(result)};
  } catch (const Undecided& error) {
    throw Undecided(command + ": " + error.what());
  }
}

/// A double, or an exact number where those are asked for.
Cell number_cell(const Number& number, bool exact) {
  const auto* value = std::get_if<Quadratic>(&number);
  if (exact && value != nullptr) return exact_cell(value->text());
  const auto rounded = double_of(number);
  return rounded ? real_cell(*rounded) : missing_cell();
}

/// What fits a table of 80 columns: 8 digits.
Cell short_cell(const Number& number, bool exact) {
  const Cell cell = number_cell(number, exact);
  if (exact || cell.text.size() < 11) return cell;
  std::array<char, 32> digits{};
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), *double_of(number),
                                  std::chars_format::general, 8)
                        .ptr;
  return {std::string(digits.data(), end), cell.json};
}

/// Columns and their cells; together the one row of a table.
using Fields = std::vector<std::pair<Column, Cell>>;

Table table_of(const Fields& fields) {
  Table table{{}, {{}}, false};
  for (const auto& [column, cell] : fields) {
    table.columns.push_back(column);
    table.rows[0].push_back(cell);
  }
  return table;
}

/// "A 0, C 0.5" and {"A": 0, "C": 0.5}
Cell object_cell(const std::vector<std::pair<std::string, Cell>>& members) {
  std::vector<std::string> texts, pairs;
  for (const auto& [name, cell] : members) {
    texts.push_back(name + " " + cell.text);
    pairs.push_back(text_cell(name).json + ": " + cell.json);
  }
  return {joined(texts), "{" + joined(pairs) + "}"};
}

Fields plan_fields(const Result& result) {
  return {{{"model", Type::text, "", "theorem, transfers: counted; events: collision by collision"},
           text_cell(result.plan.model)},
          {{"reason", Type::text, "", "why that one"}, text_cell(result.plan.reason)},
          {{"events", Type::whole, "", "collisions; none where they never end"},
           result.status == Status::collapse ? missing_cell() : whole_cell(result.events)}};
}

Cell counts_cell(const Scene& scene, const Result& result) {
  const bool never_end = result.status == Status::collapse;
  std::vector<std::pair<std::string, Cell>> counts;
  for (std::size_t gap = 0; gap < result.counts.size(); ++gap) {
    const bool is_open =
        (gap == 0 && !scene.left_wall) || (gap + 1 == result.counts.size() && !scene.right_wall);
    if (is_open) continue;
    counts.emplace_back(gap_name(scene, gap), never_end ? Cell{"infinitely many", "null"}
                                                        : whole_cell(result.counts[gap]));
  }
  return object_cell(counts);
}

Cell terminal_cell(const Scene& scene, const Result& result, bool exact) {
  std::vector<std::pair<std::string, Cell>> terminal;
  for (std::size_t i = 0; i < result.terminal.size(); ++i)
    terminal.emplace_back(body_name(scene, i), number_cell(result.terminal[i], exact));
  if (scene.kind == Kind::three_body)
    terminal.emplace_back("rho", number_cell(result.transmitted, exact));
  return object_cell(terminal);
}

/// What stands before the collisions.
Fields head_fields(const Asked& asked) {
  const Result& result = asked.result;
  const Scene& scene = asked.scene;
  const bool exact = asked.scene.is_exact;
  Cell plan{result.plan.model + ": " + result.plan.reason,
            written(table_of(plan_fields(result)), Format::json)};
  plan.json.pop_back();  // a line feed
  Fields fields;
  const auto add = [&](const char* name, Type type, const char* words, const Cell& cell) {
    fields.push_back({{name, type, "", words}, cell});
  };
  const auto shown = [&](const Number& number) { return number_cell(number, exact); };
  add("status", Type::text, "complete, limited or collapse", text_cell(status_name(result.status)));
  if (!result.why.empty()) add("why", Type::text, "it is limited", text_cell(result.why));
  add("plan", Type::text, "model, reason, number of collisions", plan);
  if (result.collapse_time)
    add("collapse", Type::real, "when and where collisions come to an end",
        object_cell({{"time", shown(*result.collapse_time)},
                     {"position", shown(*result.collapse_position)}}));
  if (scene.wants("counts")) add("counts", Type::whole, "collisions", counts_cell(scene, result));
  if (scene.wants("terminal"))
    add("terminal", Type::real, "velocities at the end; rho: B's part of energy",
        terminal_cell(scene, result, exact));
  if (scene.wants("energy"))
    add("energy", Type::real, "kinetic",
        object_cell({{"before", shown(result.energy_before)}, {"after", shown(result.energy)}}));
  return fields;
}

using Write = std::function<void(std::string_view)>;

/// Rows as they come, written some thousand at a time.
class Rows {
public:
  Rows(Format format, const std::vector<Column>& columns, Write write)
      : writer_(format, columns, true),
        write_(std::move(write)),
        cell_(format == Format::text ? short_cell : number_cell) {}
  Cell number(const Number& value, bool exact) const { return cell_(value, exact); }
  void add(Row row) {
    constexpr std::size_t rows_at_once = 4096;
    block_.push_back(std::move(row));
    if (block_.size() == rows_at_once) flush();
  }
  void end() {
    if (is_first_ || !block_.empty()) flush();
    write_(writer_.end());
  }

private:
  Writer writer_;
  Write write_;
  Cell (*cell_)(const Number&, bool exact);
  std::vector<Row> block_;
  bool is_first_ = true;

  void flush() {
    write_(writer_.rows(block_));
    block_.clear();
    is_first_ = false;
  }
};

/// Of all collisions those that the scene wants to see.
void write_events(const Asked& asked, Rows rows) {
  const Scene& scene = asked.scene;
  const auto shown = [&](const Number& value) { return rows.number(value, asked.scene.is_exact); };
  stream(scene, asked.result.plan, [&](const auto& event) {
    if (event.number % scene.every != 0) return;
    const auto name = [&](std::size_t body, bool is_there) {
      return text_cell(is_there ? body_name(scene, body) : "wall");
    };
    rows.add({whole_cell(event.number), name(event.gap - 1, event.gap > 0),
              name(event.gap, event.gap < scene.masses.size()), shown(event.time),
              shown(event.position), shown(event.v_left), shown(event.v_right)});
  });
  rows.end();
}

void write_trajectory(const Asked& asked, Rows rows) {
  const auto shown = [&](const Number& value) { return rows.number(value, asked.scene.is_exact); };
  trajectory(asked.scene, asked.result, [&](const Point& point) {
    rows.add(
        {shown(point.time), text_cell(body_name(asked.scene, point.body)), shown(point.position)});
  });
  rows.end();
}

void write_all(const Asked& asked, const std::string& format, const Write& write) {
  struct List {
    const char* name;
    std::vector<Column> columns;
    void (*write)(const Asked&, Rows);
  };
  const List events{"events", simulate_columns(), write_events};
  const List points{"trajectory", trajectory_columns(), write_trajectory};
  if (format == "csv" || format == "jsonl") {
    const bool is_points = asked.scene.wants("trajectory") && !asked.scene.wants("events");
    const List& list = is_points ? points : events;
    const Format as = format == "csv" ? Format::csv : Format::json_lines;
    return list.write(asked, Rows(as, list.columns, write));
  }
  const Format as = format == "json" ? Format::json : Format::text;
  std::string head = written(table_of(head_fields(asked)), as);
  if (as == Format::json) head.erase(head.size() - 2);  // "}\n"
  write(head);
  for (const List& list : {events, points}) {
    if (!asked.scene.wants(list.name)) continue;
    write(as == Format::text ? "\n" : ", \"" + std::string(list.name) + "\": ");
    const auto without_end = [&](std::string_view text) {
      write(text == "\n]\n" || text == "]\n" ? text.substr(0, text.size() - 1) : text);
    };
    list.write(asked, Rows(as, list.columns, as == Format::text ? write : without_end));
  }
  if (as == Format::json) write("}\n");
}

}  // namespace

std::vector<Column> plan_columns() { return table_of(plan_fields({})).columns; }

std::vector<Column> simulate_columns() {
  return {{"number", Type::whole, "", "1 for the first collision"},
          {"left", Type::text, "", "name of the left body, or wall"},
          {"right", Type::text, "", "of the right one"},
          {"time", Type::real, "", "of the collision"},
          {"position", Type::real, "", "of the collision"},
          {"v_left", Type::real, "", "velocity of the left body after it"},
          {"v_right", Type::real, "", "of the right one"}};
}

std::vector<Column> trajectory_columns() {
  return {{"time", Type::real, "", ""},
          {"body", Type::text, "", "its name"},
          {"position", Type::real, "", "where it is then"}};
}

Answer plan(const Request& request) {
  return {table_of(plan_fields(asked(request, "plan").result)), ""};
}

Answer simulate(const Request& request) {
  Answer answer;
  answer.stream = [asked = asked(request, "simulate"), format = request.format](
                      const Write& write) { write_all(asked, format, write); };
  return answer;
}

}  // namespace answers
