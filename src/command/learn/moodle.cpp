// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/moodle.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "command/learn/exercise_text.hpp"
#include "render/formula_mathml.hpp"

namespace magicmass::command {
namespace {

constexpr render::TextStyle plain{.unicode = true, .colourful = false};

/// Paragraphs of a page as HTML.
std::string html_of(const std::string& page) {
  std::istringstream lines(page);
  std::string html;
  std::string paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) html += "<p>" + paragraph + "</p>\n";
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      end_paragraph();
      continue;
    }
    if (line.starts_with("- ")) end_paragraph();
    paragraph += (paragraph.empty()          ? ""
                  : line.starts_with("    ") ? "<br/>"
                                             : " ") +
                 render::html_escaped(line);
  }
  end_paragraph();
  return html;
}

std::string page_in(const Posed& posed, const char* file) {
  return html_of(page_of(text_of(posed.exercise.folder / file), posed, plain));
}

std::string type_of(const Posed& posed) {
  if (posed.exercise.kind == ExerciseKind::symbolic) return "stack";
  if (posed.exercise.kind == ExerciseKind::code) return "coderunner";
  return posed.exercise.choices.empty() ? "numerical" : "multichoice";
}

std::string inner(const Posed& posed) {
  if (posed.exercise.kind == ExerciseKind::symbolic) return moodle_symbolic(posed);
  return posed.exercise.kind == ExerciseKind::code ? moodle_code(posed) : moodle_prediction(posed);
}

std::string question(const Posed& posed) {
  std::string prompt = page_in(posed, "prompt.md");
  if (!posed.exercise.form.empty()) prompt += "<p>Form asked for: " + posed.exercise.form + ".</p>";
  const auto& symbols = posed.exercise.symbols;
  if (std::find(symbols.begin(), symbols.end(), "e") != symbols.end())
    prompt += "<p>Type e_r for e: in this quiz e is Euler's number.</p>";
  if (posed.exercise.kind == ExerciseKind::symbolic)
    prompt += "<p>[[input:ans1]] [[validation:ans1]]</p>";
  std::string xml = "<question type=\"" + type_of(posed) + "\">\n";
  xml += text_element("name", posed.exercise.id + ": " + posed.exercise.title);
  xml += html_element("questiontext", prompt);
  xml += html_element("generalfeedback", page_in(posed, "after.md"));
  xml += element("defaultgrade", fmt::format("{}", posed.exercise.difficulty));
  xml += element("penalty", "0.1") + element("hidden", "0") +
         element("idnumber", "magicmass-" + posed.exercise.id);
  return xml + inner(posed) + "</question>\n";
}

}  // namespace

std::string element(const std::string& name, const std::string& text) {
  return "<" + name + ">" + render::html_escaped(text) + "</" + name + ">\n";
}

std::string text_element(const std::string& name, const std::string& text) {
  return "<" + name + "><text>" + render::html_escaped(text) + "</text></" + name + ">\n";
}

std::string html_element(const std::string& name, const std::string& html) {
  return "<" + name + " format=\"html\"><text>" + render::html_escaped(html) + "</text></" + name +
         ">\n";
}

std::string moodle_quiz(const std::vector<Posed>& questions) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n";
  std::string chapter;
  for (const Posed& posed : questions) {
    if (posed.exercise.chapter != chapter) {
      chapter = posed.exercise.chapter;
      xml += "<question type=\"category\">\n" +
             text_element("category", "$course$/top/magicmass/" + chapter) + "</question>\n";
    }
    xml += question(posed);
  }
  return xml + "</quiz>\n";
}

}  // namespace magicmass::command
