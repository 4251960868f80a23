// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/generate.hpp"

#include <set>
#include <sstream>

#include "answers/errors.hpp"
#include "generate/quantities.hpp"
#include "generate/tree.hpp"

namespace command {

namespace {

/// Names between commas.
std::set<std::string> listed(const std::string& text) {
  std::set<std::string> names;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) names.insert(word);
  return names;
}

}  // namespace

answers::Answer generate_files(const answers::Request& request) {
  if (request.has("quantity")) {
    const std::string form = request.has("form") ? request.text("form") : "tangent";
    try {
      return {{}, generate::selected(form, listed(request.text("quantity")))};
    } catch (const codegen::Refused& refused) {
      throw answers::InvalidInput("generate: " + std::string(refused.what()));
    }
  }
  const std::string folder = request.has("out") ? request.text("out") : "generated";
  const generate::Texts texts = generate::generated();
  if (!request.has("check")) {
    generate::write(folder, texts);
    return {{}, std::to_string(texts.size()) + " files written to " + folder + "\n"};
  }
  const std::vector<std::string> stale = generate::differences(folder, texts);
  if (stale.empty()) {
    return {{},
            folder + " is what the theorems give: " + std::to_string(texts.size()) + " files\n"};
  }
  std::string said;
  for (const std::string& line : stale) said += folder + "/" + line + "\n";
  return {{}, said + "run: magicmass generate --out " + folder + "\n", true};
}

}  // namespace command
