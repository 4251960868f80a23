// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "equality/decide.hpp"

namespace magicmass::equality {

// What the child process tells its parent: a verdict, or why there is none.
struct Message {
  bool is_final = false;
  bool is_refusal = false;
  std::string refusal = {};
  Verdict verdict = {};
};

// As bytes, each message complete in itself; `take` removes the first one of a stream if all of it is there.
std::string packed(const Message& message);
std::optional<Message> take(std::string& stream);

}  // namespace magicmass::equality
