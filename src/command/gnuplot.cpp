// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/gnuplot.hpp"

#include <cerrno>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace magicmass::command {

Drawing run_gnuplot(const std::filesystem::path& folder, const std::string& script) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "gnuplot.log",
                                   O_WRONLY | O_CREAT | O_TRUNC, 0666);
  std::string program = "gnuplot";
  std::string without_own_settings = "-d";
  std::string argument = script;
  char* const arguments[] = {program.data(), without_own_settings.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return Drawing::no_gnuplot;
  int status = 0;
  if (error != 0 || ::waitpid(child, &status, 0) != child) return Drawing::failed;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) return Drawing::no_gnuplot;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Drawing::done : Drawing::failed;
}

std::string gnuplot_quoted(const std::string& text) {
  std::string inside;
  for (const char character : text)
    inside += character == '\'' ? std::string("''") : std::string(1, character);
  return "'" + inside + "'";
}

}  // namespace magicmass::command
