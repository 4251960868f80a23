// SPDX-License-Identifier: GPL-2.0-or-later
// What an answer throws instead; what() is one line, fit to be shown.
#pragma once

#include <stdexcept>

namespace answers {

/// The request has no meaning: what, where, and what is allowed. Exit code 2.
class InvalidInput : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// There is an answer, but not at the precision, size or range offered. Exit code 3.
class Undecided : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

}  // namespace answers
