// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "derivation/derivation.hpp"

/// All chapters, derived once a process. Cases that look at them have the tag [shared] and run in one.
inline const magicmass::derivation::Derivation& whole_derivation() {
  static const magicmass::derivation::Derivation result = magicmass::derivation::derive();
  return result;
}
