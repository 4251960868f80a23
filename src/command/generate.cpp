// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>

#include "command/files.hpp"
#include "generate/quantities.hpp"
#include "learn/exercise.hpp"
#include "magicmass/scenes/trio.hpp"

namespace command {
namespace {

using answers::InvalidInput;
using Names = std::set<std::string>;

/// What a scene's outputs are computed from. The evaluators are of the paper's three bodies.
Names needed(const std::string& file) {
  using namespace magicmass::scenes;
  static const std::map<std::string, Names> all{{"counts", {"N_A", "N_B"}},
                                                {"terminal", {"a_t", "b_t", "c_t", "rho"}},
                                                {"events", {"a", "b", "c", "c_prime"}}};
  const Scene scene = read_scene(file);
  const auto trio = Trio::of(scene);
  const auto* block = scene.masses[0].exact();
  if (scene.kind != Kind::three_body || !trio || !trio->is_at_rest() || block == nullptr ||
      !scene.masses[2].is(*block) || !scene.restitution.is(1)) {
    throw InvalidInput(
        scene.source +
        ": no evaluators for this scene; allowed: blocks A and B of equal mass, B at "
        "rest beside the ball C, A on its way to them, restitution 1");
  }
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
  return names;
}

std::string header(const answers::Request& request) {
  const bool is_scene = request.has("scene");
  if (request.has("out") || request.has("check") || (is_scene && request.has("quantity")))
    throw InvalidInput(
        "generate: --quantity or --scene is one header; allowed with it: --form, -o FILE");
  const std::string form = request.has("form") ? request.text("form") : "tangent";
  const learn::Texts listed = learn::fields(request.text("quantity"), ',');
  const Names names =
      is_scene ? needed(request.text("scene")) : Names(listed.begin(), listed.end());
  return answers::given_by_user("generate: form " + form + ": ",
                                [&] { return generate::selected(form, names); });
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
  try {
    const generate::Texts files = texts();
    try {
      generate::write(folder, files);
    } catch (const std::runtime_error& problem) {
      refuse(problem.what());
    }
    return {{}, std::to_string(files.size()) + " files written to " + folder + "\n"};
  } catch (...) {
    if (is_new) std::filesystem::remove(folder, error);
    throw;
  }
}

answers::Answer generate_files(const answers::Request& request) {
  if (request.has("quantity") || request.has("scene")) return {{}, header(request)};
  for (const std::string option : {"form", "output"})
    if (request.has(option) && (option == "form" || !request.has("check")))
      throw InvalidInput("generate: --" + option +
                         " is of one header; allowed: with --quantity or --scene");
  const std::string folder = request.has("out") ? request.text("out") : "generated";
  const generate::Texts texts = generate::generated();
  if (!request.has("check")) return write_folder("generate: --out", folder, [&] { return texts; });
  const std::vector<std::string> stale = generate::differences(folder, texts);
  const std::string files = std::to_string(texts.size()) + " files";
  if (stale.empty()) return {{}, folder + " is what the theorems give: " + files + "\n"};
  std::string said;
  for (const std::string& line : stale) said += folder + "/" + line + "\n";
  const auto extra = std::count_if(stale.begin(), stale.end(), [](const std::string& line) {
    return line.ends_with(": is not generated");
  });
  if (extra != 0) said += "remove what is not generated\n";
  if (extra != std::ssize(stale)) said += "run: magicmass generate --out " + folder + "\n";
  return {{}, said, true};
}

}  // namespace command
