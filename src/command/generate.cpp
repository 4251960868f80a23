#include <filesystem>

#include "answers/motion.hpp"
#include "command/files.hpp"
#include "generate/quantities.hpp"
#include "learn/exercise.hpp"
#include "magicmass/scenes/trio.hpp"

namespace command {
namespace {

using namespace magicmass::scenes;
using answers::InvalidInput;
using Names = std::set<std::string>;

std::string one_header(const std::string& form, const Names& outputs, const Names& quantities = {},
                       const std::string& more = "") {
  return answers::given_by_user("generate: form " + form + ": ", [&] {
    return generate::selected(form, outputs, quantities, more);
  });
}

/// The forms of three bodies that are needed, and a function that calls them for the scene.
std::string motion_header(const Scene& scene, const Trios& trios) {
  const Trio& trio = *trios.alone();
  const auto N = trio.count();
  const answers::Row numbers = answers::rounded([&] {
    const auto [V, W, d_A, d_B] = trio.start();
    const Trio::Shape s = trio.shape();
    const Ball place = ball_of(trio.from().place), drift = ball_of(trio.from().drift);
    return answers::Balls{s.A, s.per_B, s.e, s.q_e, V, W, d_A, d_B, place, drift};
  });
  const std::string q_e = numbers[3].text, minus = trios.last() == 0 ? "-" : "";
  const bool is_below = q_e[0] == '-', is_above = !is_below && q_e != "0";
  const bool collapses = !N && !trio.is_endless(), has_events = scene.wants("events");
  const bool has_velocities = has_events || (scene.wants("terminal") && !collapses);
  codegen::Words given{"M_C(1)"}, fields, values;
  for (const char* name : {"M_A", "w_B", "e", "q_e", "V", "W", "d_A", "d_B", "place", "drift"})
    given.push_back(name + ("(" + numbers[given.size() - 1].text + ")"));
  Names used;
  std::string lines;
  const auto call = [&](bool is_wanted, const std::string& result, const std::string& quantity,
                        const std::string& inputs) {
    if (!is_wanted) return;
    used.insert(quantity);
    lines += "  const auto " + result + " = " + quantity + "_restitution(M_A, w_B, M_C, e, " +
             inputs + ");\n";
  };
  const auto give = [&](const std::string& field, const std::string& value, bool is_moved = true) {
    fields.push_back(field);
    values.push_back(is_moved ? minus + "(" + value + ")" : value);
  };
  call(is_above, "[h_e, step_sine]", "angle", "q_e");
  call(is_above && scene.wants("counts"), "all", "count", "q_e, h_e, step_sine, V, W");
  if (used.contains("count")) give("N", "all.N_any", false);
  call(collapses, "end", "collapse", "q_e, V, W, d_A, d_B");
  call(is_below && !collapses, "end", "collapse", "q_e, Number(1), Number(0), d_A, d_B");
  if (collapses) {
    give("end_time", "end.t_any", false);
    give("end_position", "place + drift * end.t_any + end.x_any");
    give("end_velocity", "drift + end.v_any");
  }
  if (has_velocities) {
    const char* unit = is_above ? "step_sine" : is_below ? "pow(end.y_e, Number(j))" : "Number(1)";
    lines += "  const Number unit = " + std::string(unit) +
             ", per_unit = pow(e, Number(j) / Number(2)) / unit, turn(j % 2 == 0 ? 1 : -1);\n";
    call(is_above, "[now, last]", "sines", "q_e, h_e, step_sine, j");
    call(is_below, "[last, now]", "rise", "q_e, end.y_e, j, unit");
    call(!is_above && !is_below, "[last, now]", "even", "q_e, unit, j");
    const std::string at = "unit, j, now, last, per_unit, V, W, ";
    call(true, "v", "at", at + "Number(0), Number(0), Number(1), turn");
    for (std::size_t i = 0; i < trio.bodies(); ++i) {
      const char body = "ACB"[minus.empty() ? i : trio.bodies() - 1 - i];
      give("v_" + body_name(scene, i), std::string("drift + v.") + body + "_at");
    }
    if (has_events) {
      call(true, "[reach, moment]", "time", "unit, j, now, last, V, W, d_A, d_B");
      call(true, "x", "at", at + "d_A, d_B, moment, turn");
      give("time", "moment", false);
      give("position", "place + drift * moment + x.C_at");
    }
  }
  const std::string how_many = N ? std::to_string(*N) : collapses ? "infinitely many" : "endless";
  return one_header(
      "restitution", {}, used,
      "template <class Number> struct Scene { Number " + codegen::joined(fields, ", ") +
          "; };\n/// " + answers::shown_text(scene.source) + ", collisions: " + how_many +
          "; N is computed with rounding; v_A and the like hold after collision j (from 0); "
          "time and position are its own; end_time and the like are of the collapse.\n"
          "template <class Number>\nScene<Number> scene([[maybe_unused]] std::int64_t j) {\n"
          "  using std::pow;\n  [[maybe_unused]] const Number " +
          codegen::joined(given, ", ") + ";\n" + lines + "  return {" +
          codegen::joined(values, ", ") + "};\n}\n");
}

/// What a scene's outputs are computed from: forms of the paper's three bodies, or of any.
std::string scene_header(const std::string& file, std::string form) {
  static const std::map<std::string, Names> all{{"counts", {"N_A", "N_B"}},
                                                {"terminal", {"a_t", "b_t", "c_t", "rho"}},
                                                {"events", {"a", "b", "c", "c_prime"}}};
  const Scene scene = read_scene(file);
  const auto trio = Trio::of(scene);
  const auto* block = scene.masses[0].exact();
  const bool is_paper = scene.kind == Kind::three_body && trio && trio->is_at_rest() &&
                        block != nullptr && scene.masses[2].is(*block) && scene.restitution.is(1);
  if (form.empty()) form = is_paper && !scene.wants("events") ? "tangent" : "restitution";
  const auto trios = Trios::of(scene);
  const bool is_any = trios && trios->alone() && trios->thrown() == 0 && form == "restitution";
  if (scene.kind == Kind::chain || !(is_paper || is_any))
    refuse_key(scene, form == "restitution" || scene.restitution.is(1) ? "kind" : "restitution",
               "no evaluators of form " + form,
               "three bodies, or two and a wall, where the ball is met first "
               "(other forms than restitution: equal blocks, A moves, restitution 1)");
  for (const char* const key : {"until", "max_events", "every"})
    if (scene.has(key))
      refuse_key(scene, key, "evaluators cover all collisions", "a scene without it");
  Names names;
  for (const std::string& output : scene.outputs) {
    const auto found = all.find(output);
    if (found == all.end())
      refuse_key(scene, "outputs", "no evaluators for " + output, "counts, terminal, events");
    names.insert(found->second.begin(), found->second.end());
  }
  if (form == "restitution") return motion_header(scene, *trios);
  return answers::with_place<InvalidInput>(scene.source + ": outputs: ",
                                           [&] { return one_header(form, names); });
}

std::string header(const answers::Request& request) {
  const bool is_scene = request.has("scene");
  if (request.has("out") || request.has("check") || (is_scene && request.has("quantity")))
    throw InvalidInput(
        "generate: --quantity or --scene is one header; allowed with it: --form, -o FILE");
  const std::string form = request.text("form");
  if (is_scene) return scene_header(request.text("scene"), form);
  const learn::Texts listed = learn::fields(request.text("quantity"), ',');
  return one_header(form.empty() ? "tangent" : form, {listed.begin(), listed.end()});
}

}  // namespace

answers::Answer write_folder(const std::string& option, const std::string& folder,
                             const std::function<generate::Texts()>& texts) {
  const auto refuse = [&](const std::string& why) {
    throw InvalidInput(option + " " + answers::shown_text(folder) + ": " + why +
                       "; allowed: a folder to write to");
  };
  std::error_code error;
  const bool is_new = std::filesystem::create_directories(folder, error);
  if (error) refuse(error.message());
  if (is_new) std::filesystem::remove(folder, error);  // lest it stays where time is up
  const generate::Texts files = texts();
  std::filesystem::create_directories(folder, error);
  try {
    generate::write(folder, files);
  } catch (const std::runtime_error& problem) {
    if (is_new) std::filesystem::remove(folder, error);
    refuse(problem.what());
  }
  return {{}, std::to_string(files.size()) + " files written to " + folder + "\n"};
}

answers::Answer generate_files(const answers::Request& request) {
  if (request.has("quantity") || request.has("scene")) return {{}, header(request)};
  for (const std::string option : {"form", "output"})
    if (request.has(option) && (option == "form" || !request.has("check")))
      throw InvalidInput("generate: --" + option +
                         " is of one header; allowed: with --quantity or --scene");
  const std::string folder = request.has("out") ? request.text("out") : "generated";
  if (!request.has("check")) return write_folder("generate: --out", folder, generate::generated);
  const generate::Texts texts = generate::generated();
  const std::vector<std::string> stale = generate::differences(folder, texts);
  const std::string files = std::to_string(texts.size()) + " files";
  if (stale.empty()) return {{}, folder + " is what the theorems give: " + files + "\n"};
  std::string said;
  for (const std::string& line : stale) said += folder + "/" + line + "\n";
  const auto is_extra = [](const auto& line) { return line.ends_with(": is not generated"); };
  const auto extra = std::ranges::count_if(stale, is_extra);
  if (extra != 0) said += "remove what is not generated\n";
  if (extra != std::ssize(stale)) said += "run: magicmass generate --out " + folder + "\n";
  return {{}, said, true};
}

}  // namespace command
