// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/generate.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "answers/errors.hpp"
#include "command/folder.hpp"
#include "generate/quantities.hpp"
#include "generate/tree.hpp"
#include "magicmass/scenes/scene.hpp"
#include "magicmass/scenes/trio.hpp"

namespace command {
namespace {

using answers::InvalidInput;
using Names = std::set<std::string>;

/// Names between commas.
Names listed(const std::string& text) {
  Names names;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) names.insert(word);
  return names;
}

/// Whether a scene is of the evaluators: the paper's three bodies, wherever they are.
bool is_of_paper(const magicmass::scenes::Scene& scene) {
  if (scene.kind != magicmass::scenes::Kind::three_body || !scene.restitution.is(1)) return false;
  const auto places = magicmass::scenes::exact_places(scene);
  const auto* block = scene.masses[0].exact();
  return places && magicmass::scenes::Trio::of(*places) && block && scene.masses[2].is(*block);
}

/// What a scene's outputs are computed from.
Names needed(const std::string& file) {
  static const std::map<std::string, Names> all{{"counts", {"N_A", "N_B"}},
                                                {"terminal", {"a_t", "b_t", "c_t", "rho"}},
                                                {"events", {"a", "b", "c", "c_prime"}}};
  const magicmass::scenes::Scene scene =
      magicmass::scenes::read_scene(file == "-" ? "/dev/stdin" : file);
  if (!is_of_paper(scene)) {
    throw InvalidInput(scene.source +
                       ": no evaluators for this scene; allowed: blocks A and B of one mass, B at "
                       "rest beside the ball C, A on its way to them, restitution 1");
  }
  Names names;
  for (const std::string& output : scene.outputs) {
    const auto found = all.find(output);
    if (found == all.end()) {
      magicmass::scenes::refuse_key(scene, "outputs", "no evaluators for " + output,
                                    "counts, terminal, events");
    }
    names.insert(found->second.begin(), found->second.end());
  }
  return names;
}

/// One header.
std::string header(const answers::Request& request) {
  const bool is_scene = request.has("scene");
  if (is_scene && request.has("quantity"))
    throw InvalidInput("generate: --scene or --quantity, not both");
  if (request.has("out") || request.has("check")) {
    throw InvalidInput(
        "generate: --out and --check are of all files; allowed with --scene and "
        "--quantity: --form, -o FILE");
  }
  const std::string form = request.has("form") ? request.text("form") : "tangent";
  const Names names = is_scene ? needed(request.text("scene")) : listed(request.text("quantity"));
  try {
    return generate::selected(form, names);
  } catch (const codegen::Refused& refused) {
    throw InvalidInput("generate: form " + form + ": " + refused.what());
  }
}

}  // namespace

answers::Answer generate_files(const answers::Request& request) {
  if (request.has("quantity") || request.has("scene")) return {{}, header(request)};
  if (request.has("form"))
    throw InvalidInput("generate: --form is of one header; allowed: with --quantity or --scene");
  const std::string folder = request.has("out") ? request.text("out") : "generated";
  const generate::Texts texts = generate::generated();
  if (!request.has("check")) {
    write_folder("generate: --out", folder, [&] { return texts; });
    return {{}, std::to_string(texts.size()) + " files written to " + folder + "\n"};
  }
  const std::vector<std::string> stale = generate::differences(folder, texts);
  if (stale.empty()) {
    return {{},
            folder + " is what the theorems give: " + std::to_string(texts.size()) + " files\n"};
  }
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
