// SPDX-License-Identifier: MIT
// The exceptions of magicmass: one root and two kinds, each with its exit code on the command line. Everything that a caller is to
// blame for, or that no precision offered decides, is one of these or of a type derived from them; std::logic_error is a bug.
#pragma once

#include <stdexcept>

namespace magicmass {

/// Root of everything magicmass throws on purpose; what() is one line fit to be shown to a user.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The caller asked for something that has no meaning; what() names it and what is allowed. Exit code 2.
class InvalidInput : public Error {
public:
  using Error::Error;
};

/// The question has an answer, but not at the precision, size or range offered. Exit code 3.
class Undecided : public Error {
public:
  using Error::Error;
};

}  // namespace magicmass
