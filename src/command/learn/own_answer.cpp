// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/own_answer.hpp"

#include <fstream>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "command/learn/confined_process.hpp"
#include "command/learn/variant.hpp"
#include "command/scratch_folder.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {

std::string own_answer(const std::vector<std::string>& arguments, const std::string& format,
                       const std::filesystem::path& folder, const Values& values) {
  namespace fs = std::filesystem;
  const ScratchFolder scratch;
  std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string()};
  for (const std::string& argument : arguments) {
    words.push_back(filled(argument, values));
    if (argument.find('/') != std::string::npos || !fs::is_regular_file(folder / argument))
      continue;
    words.back() = argument;
    std::ofstream(scratch.path() / argument) << filled(text_of(folder / argument), values);
  }
  words.insert(words.end(), {"--format", format});
  ProcessLimits limits;
  limits.time = std::chrono::seconds(10);
  limits.memory = 0;  // a program of ours
  limits.output = std::size_t{16} << 20U;
  limits.is_computing_only = false;
  const ProcessEnd end = run_confined(words, "", scratch.path(), limits);
  if (!end.is_good())
    throw InvalidInput(fmt::format(
        "{}: run: magicmass {} says: {}", shown_text((folder / "exercise.toml").string(), 300),
        fmt::join(words.begin() + 1, words.end(), " "), shown_text(end.output, 300)));
  return end.output;
}

std::string field_of(const std::string& json, const std::string& pointer) {
  try {
    const nlohmann::json value =
        nlohmann::json::parse(json).at(nlohmann::json::json_pointer(pointer));
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    for (char& c : text)
      if (c == 'e' && value.is_number()) c = 'E';
    return text;
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput("fields: the program's answer has nothing at " + shown_text(pointer) +
                       "; it is " + shown_text(json, 400));
  }
}

Values computed_values(const Exercise& exercise, const Values& variant) {
  Values values;
  if (exercise.run.empty()) return values;
  const std::string json = own_answer(exercise.run, "json", exercise.folder, variant);
  for (const auto& [name, pointer] : exercise.fields)
    values[name] = field_of(json, filled(pointer, variant));
  return values;
}

}  // namespace magicmass::command
