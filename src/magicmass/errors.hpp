// SPDX-License-Identifier: MIT
// The exceptions of magicmass: one root, two leaves, each with its exit code on the command line.
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
