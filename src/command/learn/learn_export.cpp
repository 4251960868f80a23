// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/learn.hpp"
#include "command/learn/moodle.hpp"
#include "command/learn/variant.hpp"

namespace magicmass::command {

ExitCode learn_export(const LearnOptions& options) {
  const Catalogue catalogue{std::filesystem::path(options.content)};
  std::vector<Posed> questions;
  for (const Exercise& exercise : catalogue.exercises())
    if (options.id.empty() || exercise.id == catalogue.at(options.id).id)
      questions.push_back(posed(exercise, variant_of(exercise, options.seed.value_or(0))));
  Destination output(options.output.path);
  output.write(moodle_quiz(questions));
  output.finish();
  return ExitCode::done;
}

}  // namespace magicmass::command
