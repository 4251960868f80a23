// An exercise: TOML that a teacher edits. What is said to an answer: never a guess. Texts, cut.
#pragma once

#include <functional>

#include "magicmass/scenes/scene.hpp"

namespace learn {
using magicmass::scenes::meant;
using Texts = std::vector<std::string>;

struct Misconception {
  std::string name;
  Texts answers;
  std::string feedback;
  std::vector<Texts> replace = {};  ///< in code: what in the solution, by what; makes an answer
};
struct Exercise {
  std::string source = {};  ///< the file, as messages name it
  std::string id = {}, title = {}, chapter = {};
  std::string options = {};  ///< that commands for it need: " --seed 7"
  std::string kind = {};     ///< symbolic, predict, derivation, code
  std::string prompt = {};
  std::string name = {};  ///< what is asked for: "v_1"; an answer may be an equation for it
  Texts symbols = {};     ///< that an answer may use
  std::map<std::string, std::string> values = {};  ///< of symbols: V = "1"
  std::string domain = {};                         ///< as `magicmass equal` reads it
  std::string form = {};                           ///< one of forms()
  std::string answer = {};       ///< as a student would type it; of choices the letter
  std::string answer_from = {};  ///< a step of the derivation, "contact.v_1": its right side
  std::string run = {};     ///< "count --alpha 3/25", or a scene: what it says has names in answers
  std::string within = {};  ///< how far a number may be off
  Texts choices = {};       ///< a), b), ...
  Texts when = {};          ///< for each choice: the conditions on what was run
  Texts laws = {};          ///< equations from which a derivation may start
  std::string start = {};   ///< of a chain: the expression with which it begins
  std::map<std::string, std::string> unknowns = {};  ///< and their values: steps or formulas
  Texts not_zero = {};             ///< what a line of a derivation may be divided by
  std::string starter = {};        ///< of code: what a student begins with, in C++
  std::string driver = {};         ///< call(), which calls the student's function
  std::string solution_code = {};  ///< the answer
  Texts inputs = {};               ///< names of call()'s inputs
  std::vector<Texts> cases = {};   ///< an input each: "1/7" is a double, "above 1/7" the next
  /// What call() should give: expressions in the inputs and the columns of what was run (with
  /// {alpha} for an input), steps of the derivation, or "solution_code": what that gives.
  Texts outputs = {};
  Texts words = {};  ///< for each output: "velocity of A"
  Texts hints = {};
  std::string solution = {};  ///< what is worth saying afterwards
  std::vector<Misconception> misconceptions = {};
  std::vector<std::map<std::string, std::string>> variants = {};  ///< of what {name} is in texts
};

/// The variant of this number, counted round and round, fills {name} in all texts. Throws
/// answers::InvalidInput, "FILE:LINE: ...", for what is no exercise.
Exercise read_exercise(std::string_view text, const std::string& source, std::size_t variant = 0);

using Numbers = std::vector<double>;
using Rows = std::vector<Numbers>;

struct Ran {
  std::string unread = {};   ///< why it was not compiled
  std::string stopped = {};  ///< why it came no further: "it crashed"
  Rows rows = {};            ///< what it gave for each case, as far as it came
};
/// Runs an answer to the exercise: a row of inputs is a case. Who judges does not know how.
using Run = std::function<Ran(const Exercise&, const std::string& code, const Rows& inputs)>;

enum class Mark { right, other_form, incomplete, wrong, unread, undecided };
const char* word(Mark mark);

struct Judgement {
  Mark mark = Mark::undecided;
  std::string feedback;
  Texts notes = {};                ///< how it was read, and where it has no value
  std::string misconception = {};  ///< the name of the one that it shows
};
/// What is said to one answer; of kind code it is a program, which `run` runs.
Judgement judge(const Exercise& exercise, const std::string& typed, const Run& run = {});

/// What an answer may be, a line each: choices; or symbols, the name asked for, its form; or none.
Texts rules(const Exercise& exercise);
/// What may be written, unless that was said, and an example that does not contain the answer.
std::string how_to_write(const Exercise& exercise, const std::string& said);
std::string own_answer(const Exercise& exercise);
/// What is wrong with the exercise itself: its own answer is not right, it differs from what the
/// program says, the answer of a misconception is not recognised, or a starter is not wrong.
Texts faults(const Exercise& exercise, const Run& run = {});

Texts fields(const std::string& text, char separator);
/// What stands between the separators, without blanks around it, and what is not empty.
Texts split(const std::string& text, char separator);
void replace_all(std::string& text, const std::string& what, const std::string& by);
/// The text and the pattern's groups in it; empty where the pattern does not match all of it.
Texts matched(const std::string& text, const std::string& pattern);
/// With something else for each part that matches: what `by` makes of the part and its groups.
std::string replaced(const std::string& text, const std::string& pattern,
                     const std::function<std::string(const Texts& part)>& by);
}  // namespace learn
