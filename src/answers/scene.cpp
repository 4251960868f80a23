
#include "answers/commands.hpp"
#include "magicmass/scenes/run.hpp"

namespace answers {
namespace {

using namespace magicmass::scenes;

/// What was asked, and what came of it.
struct AskedScene {
  Scene scene;
  Result result;
};

AskedScene asked(const Request& request, const std::string& command) {
  if (request.words.size() != 1)
    throw InvalidInput(command + ": give one scene, a file; example: " + command + " wall.toml");
  return with_place<Undecided>(command + ": ", [&]() -> AskedScene {
    Scene scene = read_scene(request.words.front());
    scene.is_exact = request.has("exact");
    if (const auto most = request.whole("max-events", 0, INT64_MAX)) scene.max_events = most;
    Result result = run(scene);
    return {std::move(scene), std::move(result)};
  });
}

/// A double, or an exact number where those are asked for.
Cell number_cell(const Number& number, bool exact) {
  const auto* value = std::get_if<Surd>(&number);
  if (exact && value != nullptr) return text_cell(value->text());
  const auto rounded = double_of(number);
  if (!rounded)
    throw Undecided(
        "a number of the answer does not fit a double; possible: --exact, "
        "other units of V and L, or fewer outputs");
  return real_cell(*rounded);
}

/// What fits a table of 80 columns: 8 digits.
Cell short_cell(const Number& number, bool exact) {
  const Cell cell = number_cell(number, exact);
  if (exact || cell.text.size() < 11) return cell;
  return {formatted("%.8g", *double_of(number)), cell.json};
}

/// Two digits, rounded up; it is finite.
Cell bound_cell(double bound) { return whole_cell(formatted("%.2g", 1.06 * bound)); }

Fields status_fields(const Result& result) {
  return {{"status", text_cell(status_name(result.status))},
          {"why", result.why.empty() ? missing_cell() : text_cell(result.why)}};
}

/// Text leaves out what is not there; all else has one shape for every model.
Table shown_in(Format format, Fields fields) {
  const auto is_missing = [](const auto& field) { return field.second.text.empty(); };
  if (format == Format::text) std::erase_if(fields, is_missing);
  return one_row(fields);
}

/// So many collisions, or infinitely many.
Cell count_cell(const Result& result, std::int64_t collisions) {
  return result.status == Status::collapse ? endless_cell() : whole_cell(collisions);
}

Fields plan_fields(const Result& result) {
  return {{"model", text_cell(result.plan.model)},
          {"reason", text_cell(result.plan.reason)},
          {"events", count_cell(result, result.events)}};
}

/// What stands before the collisions.
Fields head_fields(const AskedScene& asked) {
  const Scene& scene = asked.scene;
  const Result& result = asked.result;
  const auto shown = [&](const Number& number) { return number_cell(number, scene.is_exact); };
  const std::string plan = result.plan.model + ": " + result.plan.reason;
  Fields fields = status_fields(result);
  fields.emplace_back("plan", Cell{plan, object_cell(plan_fields(result)).json});
  const auto& end = result.collapse_time;
  fields.emplace_back(
      "collapse",
      end ? object_cell({{"time", shown(*end)}, {"position", shown(*result.collapse_position)}})
          : missing_cell());
  const auto& error = result.errors;
  fields.emplace_back("error", error ? object_cell({{"time", bound_cell(error->time)},
                                                    {"position", bound_cell(error->position)},
                                                    {"velocity", bound_cell(error->velocity)}})
                                     : missing_cell());
  if (scene.wants("counts")) {
    Fields counts;
    const std::size_t gaps = scene.masses.size() + (scene.right_wall ? 1 : 0);
    for (std::size_t gap = scene.left_wall ? 0 : 1; gap < gaps; ++gap)
      counts.emplace_back(gap_name(scene, gap), count_cell(result, result.counts[gap]));
    fields.emplace_back("counts", object_cell(counts));
  }
  if (scene.wants("terminal")) {
    Fields terminal;
    for (std::size_t i = 0; i < result.terminal.size(); ++i)
      terminal.emplace_back(body_name(scene, i), shown(result.terminal[i]));
    if (scene.kind == Kind::three_body && scene.receiver())
      terminal.emplace_back("rho", shown(result.transmitted));
    fields.emplace_back("terminal", object_cell(terminal));
  }
  if (scene.wants("energy")) {
    const bool is_cold = result.status == Status::limited && double_of(result.energy_before) &&
                         !double_of(result.energy);
    fields.emplace_back(
        "energy",
        object_cell({{"before", shown(result.energy_before)},
                     {"after", is_cold ? Cell{"below doubles", "null"} : shown(result.energy)}}));
  }
  return fields;
}

using Write = std::function<void(std::string_view)>;

/// The events or the trajectory of a scene, as they come, some thousand rows at a time.
void write_list(bool is_points, const AskedScene& asked, Format format, const Write& write) {
  const Scene& scene = asked.scene;
  const Names of_points{"time", "body", "position"};
  const Names of_events{"number", "left", "right", "time", "position", "v_left", "v_right"};
  Writer writer(format, is_points ? of_points : of_events, true);
  std::vector<Row> block;
  const auto flush = [&] {
    write(writer.rows(block));
    block.clear();
  };
  const auto add = [&](Row row) {
    block.push_back(std::move(row));
    if (block.size() == 4096) flush();
  };
  const auto shown = [&](const Number& number) {
    return (format == Format::text ? short_cell : number_cell)(number, scene.is_exact);
  };
  const auto name = [&](std::size_t body) {  // -1: the left wall
    return text_cell(body < scene.masses.size() ? body_name(scene, body) : "wall");
  };
  const auto add_event = [&](const auto& event) {
    add({whole_cell(event.number), name(event.gap - 1), name(event.gap), shown(event.time),
         shown(event.position), shown(event.v_left), shown(event.v_right)});
  };
  if (!is_points) stream(scene, asked.result.plan, add_event, scene.every);
  if (is_points)
    trajectory(scene, asked.result, [&](const Point& point) {
      add({shown(point.time), name(point.body), shown(point.position)});
    });
  flush();
  std::string end = writer.end();
  if (format == Format::json) end.pop_back();  // an object goes on
  write(end);
}

/// One list alone, without what stands before it.
bool is_list(Format format) { return format == Format::csv || format == Format::json_lines; }

void write_all(const AskedScene& asked, Format format, const Write& write) {
  const bool events = asked.scene.wants("events"), points = asked.scene.wants("trajectory");
  if (is_list(format)) {
    write_list(points && !events, asked, format, write);
    if (format == Format::json_lines && asked.result.status != Status::complete)
      write(written(one_row(status_fields(asked.result)), format));
    return;
  }
  std::string head = written(shown_in(format, head_fields(asked)), format);
  if (format == Format::json) head.erase(head.size() - 2);  // "}\n"
  write(head);
  for (const bool is_points : {false, true}) {
    if (!(is_points ? points : events)) continue;
    write(format == Format::text ? "\n" : is_points ? ", \"trajectory\": " : ", \"events\": ");
    write_list(is_points, asked, format, write);
  }
  if (format == Format::json) write("}\n");
}

}  // namespace

Answer plan(const Request& request) {
  const Result result = asked(request, "plan").result;
  Fields fields = plan_fields(result);
  fields.emplace_back("limited",
                      result.status == Status::limited ? text_cell(result.why) : missing_cell());
  return {.table = shown_in(format_of(request.format), fields),
          .is_undecided = result.is_undecided};
}

Answer simulate(const Request& request) {
  const AskedScene question = asked(request, "simulate");
  Answer answer;
  const Result& result = question.result;
  answer.is_undecided = result.is_undecided;
  const Format format = format_of(request.format);
  if (is_list(format) && result.status != Status::complete)
    answer.note = "simulate: " + status_name(result.status) + ": " + result.why;
  if (is_list(format) && question.scene.wants("events") && question.scene.wants("trajectory"))
    answer.note += (answer.note.empty() ? "simulate: " : "; ") + request.format +
                   " lists events alone; the trajectory is in text and json, or where no events "
                   "are asked for";
  answer.stream = [question, format](const Write& write) {
    with_place<Undecided>("simulate: ", [&] { write_all(question, format, write); });
  };
  return answer;
}

}  // namespace answers
