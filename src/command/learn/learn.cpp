// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/learn.hpp"

#include <functional>
#include <memory>

#include "command/commands.hpp"
#include "command/program.hpp"

namespace magicmass::command {
namespace {

using Action = ExitCode (*)(const LearnOptions&);

class Adder {
public:
  Adder(Program& program, CLI::App& learn) : program_(program), learn_(learn) {}

  /// Every command under learn has options of its own, so that none sees another's defaults.
  CLI::App& add(const std::string& name, const std::string& summary, const std::string& example,
                Action action) {
    options_ = std::make_shared<LearnOptions>();
    command_ = learn_.add_subcommand(name, summary + "\n  " + example);
    command_->add_option("--content", options_->content, "folder of the course")
        ->type_name("FOLDER");
    on_run(program_, *command_, [options = options_, action] { return action(*options); });
    return *command_;
  }
  Adder& for_student() {
    command_->add_option("--folder", options_->folder, "your answers (./magicmass-exercises)")
        ->type_name("FOLDER");
    return *this;
  }
  Adder& id(bool is_required, const std::string& words) {
    command_->add_option("ID", options_->id, words)->type_name("")->required(is_required);
    return *this;
  }
  Adder& seed() {
    command_->add_option("--seed", options_->seed, "which variants; kept in progress.txt")
        ->type_name("NUMBER")
        ->check(
            CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000'000'000'000}).description(""));
    return *this;
  }
  Adder& plain() {
    command_->add_flag("--ascii", options_->ascii, "plain characters, whatever the locale");
    return *this;
  }
  Adder& formats(const std::vector<std::string>& names) {
    options_->output.format = names.front();
    add_output_options(*command_, options_->output, names);
    return *this;
  }
  LearnOptions& options() { return *options_; }
  CLI::App& command() { return *command_; }

private:
  Program& program_;
  CLI::App& learn_;
  std::shared_ptr<LearnOptions> options_;
  CLI::App* command_ = nullptr;
};

void add_student_commands(Adder& adder) {
  adder.add("list", "The exercises, and how far you are", "magicmass learn list", learn_list);
  adder.for_student().formats({"text", "json", "csv"});
  adder.add("show", "An exercise; without ID the next one", "magicmass learn show momentum_lines",
            learn_show);
  adder.id(false, "an exercise").for_student().seed().plain().formats({"text"});
  CLI::App& check = adder.add("check", "Check an answer; exit code 0 right, 1 wrong, 2 unread",
                              "magicmass learn check half_angle \"1/(1+α)\"", learn_check);
  adder.id(true, "an exercise").for_student().seed().plain().formats({"text", "json"});
  check
      .add_option("ANSWER", adder.options().answer, "an expression, or a file of code; - is stdin")
      ->type_name("");
  check.footer(
      "Answers: 2alpha, α, √(2+α), a^2, cos^2(psi), \\frac{a}{b} from LaTeX;\n"
      "matrices [[a, b], [c, d]]; derivations a line a step; without one, what your\n"
      "file says. An answer without ID is for the next exercise, which show shows.\n"
      "Exit codes: 0 right, 1 wrong or not in the form asked for, 2 unread,\n"
      "3 undecided. A function that is checked runs alone: 3 s, 512 MiB; it writes\n"
      "no file, starts no process and has no network.");
  adder.add("hint", "The next of three hints", "magicmass learn hint half_angle", learn_hint);
  adder.id(true, "an exercise").for_student().seed().formats({"text"});
  CLI::App& solution = adder.add("solution", "The solution, after an attempt",
                                 "magicmass learn solution half_angle --reveal", learn_solution);
  adder.id(true, "an exercise").for_student().seed().plain().formats({"text"});
  solution.add_flag("--reveal", adder.options().reveal, "without an attempt");
  CLI::App& watch = adder.add("watch", "Check whenever you save, and move on",
                              "magicmass learn watch", learn_watch);
  adder.id(false, "an exercise to begin with").for_student().seed().plain();
  watch.add_option("--seconds", adder.options().seconds, "stop after so long")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.001, 1e6).description(""));
  CLI::App& reset = adder.add("reset", "Begin an exercise again",
                              "magicmass learn reset half_angle", learn_reset);
  adder.id(false, "an exercise").for_student();
  reset.add_flag("--all", adder.options().all, "all of them");
}

void add_teacher_commands(Adder& adder) {
  CLI::App& scaffold =
      adder.add("new", "Begin a new exercise (teachers)",
                "magicmass learn new my_question --chapter 04_sequences", learn_new);
  adder.id(true, "a name: small letters, digits and _");
  scaffold.add_option("--kind", adder.options().kind, "symbolic, code or predict")
      ->type_name("KIND");
  scaffold.add_option("--chapter", adder.options().chapter, "its chapter's folder")
      ->type_name("CHAPTER")
      ->required();
  adder.add("test", "Check the exercises themselves (teachers)", "magicmass learn test half_angle",
            learn_test);
  adder.id(false, "an exercise; all without it").formats({"text", "json"});
  CLI::App& grade = adder.add("grade", "A class: a folder a student (teachers)",
                              "magicmass learn grade class/ --format csv", learn_grade);
  grade.add_option("FOLDER", adder.options().folder, "a folder of students' folders")
      ->type_name("")
      ->required();
  adder.formats({"csv", "json"});
  adder.add("export", "The exercises for a quiz server (teachers)",
            "magicmass learn export --format moodle -o course.xml", learn_export);
  adder.id(false, "an exercise; all without it").seed().formats({"moodle"});
}

}  // namespace

void add_learn(Program& program) {
  CLI::App& learn = add_command(program, "learn", "Exercises that say why an answer is wrong",
                                "magicmass learn list\n  magicmass learn show\n"
                                "  magicmass learn check half_angle \"1/(1+alpha)\"");
  learn.require_subcommand(1);
  learn.footer(
      "Your answers and progress.txt are in ./magicmass-exercises, or where --folder\n"
      "says; nothing is kept anywhere else. tutorials/TEACHERS.md is for teachers.");
  Adder adder(program, learn);
  add_student_commands(adder);
  add_teacher_commands(adder);
}

}  // namespace magicmass::command
