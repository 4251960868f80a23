// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/scratch_folder.hpp"

#include <cstdlib>
#include <system_error>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {

ScratchFolder::ScratchFolder() {
  std::error_code missing;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(missing);
  const SignalsHeld held;
  std::string name = (parent / "magicmass-XXXXXX").string();
  if (missing || ::mkdtemp(name.data()) == nullptr)
    throw InvalidInput(
        "cannot make a folder for temporary files" +
        (missing ? ": TMPDIR must name a folder" : " in " + shown_text(parent.string(), 200)));
  path_ = name;
  leftover_.put_on_list(path_.c_str());
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace magicmass::command
