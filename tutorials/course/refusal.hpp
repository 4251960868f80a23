// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <stdexcept>

namespace magicmass::course {

/// The course cannot be rendered as it stands; what() is one line: where, what, what is allowed.
class Refusal : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

}  // namespace magicmass::course
