// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/folder.hpp"

#include <filesystem>
#include <stdexcept>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"

namespace command {

void write_folder(const std::string& option, const std::string& folder,
                  const std::function<generate::Texts()>& texts) {
  const auto refuse = [&](const std::string& why) {
    throw answers::InvalidInput(option + " " + answers::shown_text(folder) + ": " + why +
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
  } catch (...) {
    if (is_new) std::filesystem::remove(folder, error);
    throw;
  }
}

}  // namespace command
