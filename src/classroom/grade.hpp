// SPDX-License-Identifier: GPL-2.0-or-later
// The answers of a class: a folder for each student, a file for each answer.
#pragma once

#include "answers/request.hpp"
#include "learn/judge.hpp"

namespace classroom {

/// `learn grade CLASS [--only ID,ID] [--why or --summary]` of these exercises.
answers::Answer grade(const answers::Request& request, const std::vector<learn::Exercise>& all,
                      const learn::Run& run);
/// The exercise of this name; refused where there is none, with the one that may be meant.
const learn::Exercise& named(const std::vector<learn::Exercise>& all, const std::string& id);

}  // namespace classroom
