// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "command/animate/animation.hpp"
#include "command/commands.hpp"
#include "command/destination.hpp"
#include "command/program.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

constexpr std::int64_t most_contacts = 20'000;

struct AnimateOptions {
  std::string scene;
  std::string page;
  std::string gif;
  std::int64_t max_events = most_contacts_of_a_picture;
};

/// For a page.
std::string title_of(const Scene& scene) {
  return scene.title.empty() ? shown_text(scene.source, 200) : scene.title;
}

/// Cut short by the limit, not by the scene's own end.
void say_if_cut(const SceneMotion& motion, const AnimateOptions& options) {
  if (motion.status != "limited" || std::ssize(motion.contacts) < options.max_events) return;
  std::cerr << fmt::format(
      "magicmass: note: the animation ends after {} collisions{}\n", options.max_events,
      options.max_events < most_contacts
          ? fmt::format("; --max-events N, up to {}, shows more", most_contacts)
          : ", the most that a page shows");
}

ExitCode animate(const AnimateOptions& options) {
  std::error_code none;
  if (!options.gif.empty() && !options.page.empty() &&
      std::filesystem::weakly_canonical(options.gif, none) ==
          std::filesystem::weakly_canonical(options.page, none))
    throw InvalidInput("--gif and -o name one file; allowed: two");
  const Scene scene = read_scene(options.scene);
  const bool is_page = options.gif.empty() || !options.page.empty();
  std::optional<Destination> page, gif;
  if (is_page) page.emplace(options.page);
  if (!options.gif.empty()) gif.emplace(options.gif);
  const SceneMotion motion = follow_scene(scene, options.max_events);
  if (gif) gif->write(animation_gif(motion));
  if (page) page->write(animation_page(title_of(scene), motion));
  if (page) page->finish();
  if (gif) gif->finish();
  say_if_cut(motion, options);
  return ExitCode::done;
}

}  // namespace

void add_animate(Program& program) {
  const auto options = std::make_shared<AnimateOptions>();
  CLI::App& command =
      add_command(program, "animate", "A scene in motion, as one HTML page that needs no network",
                  "magicmass animate tutorials/scenes/cradle.toml -o cradle.html");
  command.add_option("SCENE", options->scene, "a scene file in TOML")->type_name("")->required();
  command.add_option("-o,--output", options->page, "write the page to FILE, whole or not at all")
      ->type_name("FILE");
  command.add_option("--gif", options->gif, "a GIF, too; without -o a GIF alone")
      ->type_name("FILE");
  command
      .add_option("--max-events", options->max_events,
                  fmt::format("show so many collisions at most, up to {}", most_contacts))
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, most_contacts));
  command.footer(
      "Space plays and pauses, the arrow keys step from collision to collision.\n"
      "--gif needs gnuplot (Debian: gnuplot-nox).");
  on_run(program, command, [options] { return animate(*options); });
}

}  // namespace magicmass::command
