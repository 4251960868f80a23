// SPDX-License-Identifier: GPL-2.0-or-later
// learn: lists exercises, shows them, judges answers, tests what teachers write.
#pragma once

#include "answers/request.hpp"

namespace classroom {

answers::Answer learn_by_exercises(const answers::Request& request);

}  // namespace classroom
