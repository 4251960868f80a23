// SPDX-License-Identifier: GPL-2.0-or-later
// Answers in files of others, judged where they can do no harm.
#pragma once

#include <optional>

#include "answers/request.hpp"
#include "learn/judge.hpp"

namespace classroom {

/// "half_angle.txt", or "collide.cpp" for code.
std::string answer_file(const learn::Exercise& exercise);

/// What is said of a file that looks like an answer but is none of these; else nothing.
std::optional<std::string> misnamed(const std::string& file, const learn::Texts& answer_files);

/// What is said to the answer in a folder; nothing where there is none. Links, pipes, devices, and
/// what is too long or no text are unread. Each is judged in a process of its own: one that is
/// late, or ends that process, is undecided. What all answers need is computed once, before.
std::optional<learn::Judgement> judged_file(const learn::Exercise& exercise,
                                            const std::string& folder, const learn::Run& run,
                                            unsigned seconds = 20);

/// What is said to one answer.
answers::Fields told(const learn::Exercise& exercise, const learn::Judgement& said);

}  // namespace classroom
