// What is said where something is refused.
#pragma once

#include <string>

/// The message of the Error with which the act ends, or "not refused".
template <class Error, class Act>
std::string refusal(const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "not refused";
}
