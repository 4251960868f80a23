// SPDX-License-Identifier: GPL-2.0-or-later
// What an exercise is. Its folder, tutorials/CHAPTER/exercises/ID, holds exercise.toml, prompt.md, misconceptions.toml,
// after.md, a starter (answer.txt or answer.cpp), solution/ with a file of the same name; code has driver.cpp besides.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace magicmass::command {

enum class ExerciseKind { symbolic, code, predict };

/// What a symbolic answer looks like.
enum class Shape {
  expression,
  matrix,
  derivation,  ///< lines, each equal to the one before, from `start` to the answer
  equations,   ///< lines, each true of the motion (`truth`), the last one the answer
};

/// The values of an exercise's parameters: {"k", "3"}. {k} in its texts stands for the value.
using Values = std::map<std::string, std::string>;

struct Misconception {
  std::string name;
  std::string feedback;
  std::vector<std::string> answers;  ///< what one types who has it
  Values replace;                    ///< or: what it makes of the solution, symbol by symbol
  std::string program;               ///< or: a program in the exercise's folder, for code
};

/// One function result that is compared, or one predicted quantity.
struct ComparedOutput {
  std::string name;
  std::string exact;    ///< expression in the inputs; empty where the program's own answer is taken
  std::string field;    ///< of that answer: a JSON pointer
  std::string words;    ///< "velocity of C", "number of collisions": what a difference is told in
  std::string theorem;  ///< that `exact` is, unless it is a name of the paper
};

/// A pass of the generator that a student writes, and the program that it is given.
struct GeneratorPass {
  std::string name;                   ///< empty: the function asked for is no pass
  Values outputs;                     ///< what the program computes: a name, and the theorem for it
  std::vector<std::string> bindings;  ///< theorems that say what symbols in these stand for
  std::vector<std::string> wanted;    ///< outputs that dead_code is to keep
};

/// What student's functions are held against.
struct CodeCheck {
  std::vector<std::string> inputs;
  std::vector<std::vector<std::string>> cases;  ///< an expression for each input
  std::vector<ComparedOutput> outputs;
  std::string place;                     ///< "after collision {ordinal:j}, alpha = {alpha}"
  double ulp = 4;                        ///< error allowed, in ulp of the exact value
  double absolute = 0;                   ///< or this much
  GeneratorPass pass;                    ///< `field` is then of what it leaves
  std::vector<std::string> contestants;  ///< of an open exercise, a row of rank.cpp each
};

struct Choice {
  std::string text;
  std::string
      when;  ///< a relation between the values: "b_t = 1"; it holds for the right choice alone
};

struct Exercise {
  std::filesystem::path folder;
  std::string id, title, chapter;
  ExerciseKind kind = ExerciseKind::symbolic;
  int difficulty = 1;
  std::vector<std::string> hints;                       ///< three
  std::vector<Values> variants;                         ///< at least one, which may be empty
  std::map<std::string, std::pair<long, long>> ranges;  ///< parameters drawn by the seed

  Shape shape = Shape::expression;
  std::string form;  ///< required; empty: any
  std::vector<std::string> symbols;
  std::vector<std::string> domain;
  std::string theorem;    ///< that the solution is
  Values where;           ///< what the theorem's symbols are here
  Values notation;        ///< "a(n - 1)" = "a": the theorem's elements as symbols
  std::string start;      ///< of a derivation
  Values truth;           ///< of equations: what their unknowns are
  Values truth_theorems;  ///< and the theorems that say so

  std::vector<std::string> run;  ///< arguments of magicmass whose JSON gives the values
  Values fields;                 ///< name to JSON pointer
  std::vector<Choice> choices;   ///< of a prediction
  std::string law;               ///< relations that `answer` must keep, for `learn test`
  std::string within;            ///< how far off a prediction may be; an expression

  CodeCheck code;
  std::vector<Misconception> misconceptions;
  std::vector<std::string> right, wrong, other_form;  ///< answers for `learn test`

  std::string answer_file() const {
    return kind == ExerciseKind::code ? "answer.cpp" : "answer.txt";
  }
};

std::string name_of(ExerciseKind kind);

/// Reads the folder. Throws InvalidInput: "FILE: line 3: kind = \"sybolic\"; allowed: symbolic, code, predict".
Exercise read_exercise(const std::filesystem::path& folder);

/// A text file of at most a megabyte. Throws InvalidInput.
std::string text_of(const std::filesystem::path& file);

}  // namespace magicmass::command
