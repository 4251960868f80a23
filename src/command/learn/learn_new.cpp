// SPDX-License-Identifier: GPL-2.0-or-later
#include <map>
#include <system_error>
#include <utility>

#include "command/data_folder.hpp"
#include "command/destination.hpp"
#include "command/learn/learn.hpp"
#include "command/nearest_name.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

namespace fs = std::filesystem;

/// A new exercise begins as a copy of a small one that works.
const std::map<std::string, std::string>& models() {
  static const std::map<std::string, std::string> table{
      {"symbolic", "half_angle"}, {"code", "collide"}, {"predict", "count_them"}};
  return table;
}

std::string with_key(const std::string& toml, const std::string& key, const std::string& value) {
  const std::size_t at = toml.find(key + " = \"");
  if (at == std::string::npos) return toml;
  const std::size_t end = toml.find('\n', at);
  return toml.substr(0, at) + key + " = \"" + value + "\"" + toml.substr(end);
}

/// A folder that is made elsewhere and gets its name when it is whole. One that a killed program left is made anew.
class NewFolder {
public:
  NewFolder(fs::path part, fs::path target) : part_(std::move(part)), target_(std::move(target)) {}
  NewFolder(const NewFolder&) = delete;
  NewFolder(NewFolder&&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  NewFolder& operator=(NewFolder&&) = delete;
  ~NewFolder() {
    std::error_code ignored;
    fs::remove_all(part_, ignored);
  }

  const fs::path& path() const { return part_; }
  void copy_of(const fs::path& model) const {
    std::error_code error;
    fs::remove_all(part_, error);
    if (!error) fs::create_directories(part_, error);
    if (!error) fs::copy(model, part_, fs::copy_options::recursive, error);
    require_no(error);
  }
  void become_target() const {
    std::error_code error;
    fs::create_directories(target_.parent_path(), error);
    if (!error) fs::rename(part_, target_, error);
    require_no(error);
  }

private:
  fs::path part_, target_;

  void require_no(const std::error_code& error) const {
    if (error) throw InvalidInput("cannot write " + target_.string() + ": " + error.message());
  }
};

/// Where there are chapters a new one begins with its folder, so that a misspelt one is told.
void require_chapter(const LearnOptions& options) {
  std::error_code none;
  std::vector<std::string> chapters;
  for (const auto& entry : fs::directory_iterator(options.content, none))
    if (fs::is_directory(entry.path() / "exercises", none))
      chapters.push_back(entry.path().filename().string());
  const fs::path folder = fs::path(options.content) / options.chapter;
  if (chapters.empty() || fs::is_directory(folder, none)) return;
  throw InvalidInput("no chapter is called \"" + options.chapter + "\"; did you mean " +
                     nearest_name(options.chapter, chapters) +
                     "? a new one begins with its folder, " + shown_text(folder.string(), 200));
}

}  // namespace

ExitCode learn_new(const LearnOptions& options) {
  require_name("kind", options.kind, {"code", "predict", "symbolic"});
  if (!is_id(options.id))
    throw InvalidInput("the name \"" + shown_text(options.id) +
                       "\" is not allowed; up to 30 small letters, digits and _ are");
  if (!is_id(options.chapter))
    throw InvalidInput("the chapter \"" + shown_text(options.chapter) +
                       "\" is not allowed; a folder's name is, as 04_sequences");
  require_chapter(options);
  const Catalogue models_catalogue{data_folder("tutorials", "tutorials")};
  const Exercise& model = models_catalogue.at(models().at(options.kind));
  const fs::path folder = fs::path(options.content) / options.chapter / "exercises" / options.id;
  if (fs::exists(folder)) throw InvalidInput(folder.string() + " is there already");
  NewFolder made(fs::path(options.content) / ("." + options.id + ".part"), folder);
  made.copy_of(model.folder);
  std::string toml = text_of(made.path() / "exercise.toml");
  toml = with_key(toml, "id", options.id);
  toml = with_key(toml, "title", "A title");
  toml = with_key(toml, "chapter", options.chapter);
  Destination file((made.path() / "exercise.toml").string());
  file.write(toml);
  file.finish();
  made.become_target();
  Destination output(options.output.path);
  output.write(folder.string() + " is a copy of " + model.id +
               ", which works. Change it, then: magicmass learn test " + options.id + "\n");
  output.finish();
  return ExitCode::done;
}

}  // namespace magicmass::command
