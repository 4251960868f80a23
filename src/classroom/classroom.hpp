// learn: exercises, and answers of others, judged where they can do no harm, and remembered.
#pragma once

#include <filesystem>

#include "answers/request.hpp"
#include "learn/exercise.hpp"

namespace classroom {

using answers::Answer, answers::InvalidInput, answers::Request, answers::text_cell;
using learn::Exercise, learn::Judgement;

Answer learn_by_exercises(const Request& request);

/// The program's exercises, or those of a folder or file, chapter by chapter.
std::vector<Exercise> exercises(const std::string& place = "", std::size_t variant = 0);

/// "half_angle.txt", or "collide.cpp" for code.
std::string answer_file(const Exercise& exercise);

/// What is said of a file that looks like an answer but is none to these exercises; else nothing.
std::optional<std::string> misnamed(const std::string& file, const std::vector<Exercise>& all);

/// What is said to the answer in a folder; nothing where there is none. Links, pipes, devices, and
/// what is too long or no text are unread. Each is judged in a process of its own: one that is
/// late, or ends that process, is undecided. What all answers need is computed once, before.
std::optional<Judgement> judged_file(const Exercise& exercise, const std::string& folder,
                                     const learn::Run& run, unsigned seconds = 20);

answers::Fields told(const Exercise& exercise, const Judgement& said);

/// `learn grade CLASS [--only ID,ID] [--why or --summary]`: in CLASS a folder for each student.
Answer grade(const Request& request, const std::vector<Exercise>& all, const learn::Run& run);
/// The exercise of this name; refused where there is none, with the one that may be meant.
const Exercise& named(const std::vector<Exercise>& all, const std::string& id);

/// Says what it watches, then a block for each answer; after an empty piece all is to be seen.
/// Goes on until say() throws, or the program ends.
[[noreturn]] void watch(const std::vector<Exercise>& all, const std::string& folder,
                        const learn::Run& run, const std::function<void(std::string_view)>& say);

/// What a user answered before: a line an answer in answers.tsv, in the folder of their state.
struct Attempts {
  std::string done = {};  ///< "right" where it was once, "tried", or ""
  std::size_t misses = 0, unread = 0;
  std::set<std::string> shown = {};  ///< "hint 1" and so on
};

/// By exercise. Nothing where nothing was kept, or where it cannot be.
std::map<std::string, Attempts> attempts();
/// Keeps what was said to an answer. From the third miss on, each adds to the feedback the next
/// hint that was not shown yet, or else where the solution is; to an unread one how to write.
void remember(const Exercise& exercise, Judgement& said);
void remember_hint(const Exercise& exercise, std::size_t number);

/// Compiles the answer with the exercise's driver, runs it with these inputs, once for all who ask,
/// and leaves nothing. Throws answers::Undecided without a compiler or a filter of system calls.
learn::Ran run_code(const Exercise& exercise, const std::string& code, const learn::Rows& inputs);

}  // namespace classroom
