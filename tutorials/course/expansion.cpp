// SPDX-License-Identifier: GPL-2.0-or-later
#include "course/expansion.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "course/figures.hpp"
#include "course/refusal.hpp"
#include "course/shell.hpp"
#include "render/formula_mathml.hpp"

namespace magicmass::course {
namespace {

using render::html_escaped;

std::string raw_inline(const std::string& html) { return "`" + html + "`{=html}"; }
std::string raw_block(const std::string& html) {
  return "\n```{=html}\n" + html + "\n```\n";
}
std::string code_block(const std::string& language, const std::string& text) {
  const std::string kind = language.empty() ? "" : " {." + language + "}";
  return "\n~~~~~~" + kind + "\n" + text + "\n~~~~~~\n";
}

std::string table(const Printed& block) {
  std::string html;
  for (std::size_t i = 0; i < block.lines.size(); ++i) {
    const std::string tag = i == 0 ? "th scope=\"col\"" : "td";
    html += i == 0 ? "<thead><tr>" : "<tr>";
    for (const std::string& text : cells(block.lines[i])) {
      const bool is_words = text.find(' ') != std::string::npos;
      html += "<" + tag + (is_words ? " class=\"words\">" : ">") +
              (i == 0 ? heading(text) : value(text)) + "</" + tag.substr(0, 2) +
              ">";
    }
    html += i == 0 ? "</tr></thead><tbody>\n" : "</tr>\n";
  }
  return "<div class=\"scroll\" tabindex=\"0\" role=\"group\" "
         "aria-label=\"table\"><table>" +
         html + "</tbody></table></div>";
}

std::string block_markdown(const Printed& block) {
  const bool has_columns = std::any_of(
      block.lines.begin(), block.lines.end(),
      [](const auto& line) { return line.find(" | ") != std::string::npos; });
  if (has_columns) return raw_block(table(block));
  std::string text;
  for (const std::string& line : block.lines)
    text += (text.empty() ? "" : "\n") + line;
  return code_block("", text);
}

class Expansion {
public:
  Expansion(const Chapter& chapter, const Surroundings& around)
      : chapter_(chapter), around_(around) {}

  std::string all() {
    std::istringstream lines(chapter_.text);
    std::string result;
    bool in_code = false;
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      const bool is_fence = line.starts_with("```") || line.starts_with("~~~");
      if (is_fence) in_code = !in_code;
      const int first = line_;
      if (line.starts_with("{{figure:") ||
          line.starts_with("{{plot:"))  // with its caption
        for (std::string more;
             std::getline(lines, more) && ++line_ && !more.empty();)
          line += " " + more;
      try {
        result += (in_code || is_fence ? line : one_line(line)) + "\n";
      } catch (const Refusal& refusal) {
        throw Refusal(chapter_.file("intro.md:") + std::to_string(first) + ": " +
                      refusal.what());
      }
    }
    for (const Printed& each : chapter_.printed)
      if (!used_.contains(each.name))
        throw Refusal(chapter_.file("intro.md") + ": does not use {{" + each.name +
                      "}}, which the program prints");
    return result;
  }

private:
  const Chapter& chapter_;
  const Surroundings& around_;
  int line_ = 1;  // the title was before
  std::set<std::string> used_;

  std::string one_line(const std::string& line) {
    if (!line.starts_with("{{")) return inline_text(line);
    const auto end = line.find("}}");
    if (end == std::string::npos) throw Refusal("{{ without }}");
    const std::string reference = line.substr(2, end - 2),
                      rest = line.substr(end + 2);
    const auto colon = reference.find(':');
    const std::string kind =
        colon == std::string::npos ? "" : reference.substr(0, colon);
    const std::string name =
        reference.substr(colon == std::string::npos ? 0 : colon + 1);
    if (kind == "figure" || kind == "plot") return figure(kind, name, rest);
    if (!rest.empty()) return inline_text(line);
    if (kind == "theorem") return raw_block(theorem_display(step(name)));
    if (kind == "left") return raw_block(side_display(step(name).from));
    if (kind == "right") return raw_block(side_display(step(name).to));
    if (kind == "math") return raw_block(side_display(printed(name).value));
    if (kind == "run") return command(name);
    if (reference == "program")
      return code_block("cpp",
                        chapter_.program.substr(0, chapter_.program.size() - 1));
    if (reference == "exercises") return exercise_list();
    if (kind.empty() && printed(name).is_block)
      return block_markdown(printed(name));
    return inline_text(line);
  }

  std::string inline_text(const std::string& line) {
    std::string result;
    std::size_t at = 0;
    while (at < line.size() &&
           (line[at] == ' ' || std::isdigit(at_letter(line, at)) != 0))
      ++at;
    if (line.compare(at, 2, ". ") != 0) at = 0;  // else the number of a list's item
    result = line.substr(0, at);
    const auto up_to = [&](const std::string& end, std::size_t from,
                           const std::string& what) {
      const auto found = line.find(end, from);
      if (found == std::string::npos) throw Refusal(what + " without " + end);
      return found;
    };
    while (at < line.size()) {
      if (line.compare(at, 2, "{{") == 0) {
        const auto end = up_to("}}", at, "{{");
        const std::string text = line.substr(at + 2, end - at - 2);
        at = end + 2;
        result += text.starts_with("chapter:")
                      ? chapter_link(text.substr(8))
                      : raw_inline(with_punctuation(reference(text), line, at));
      } else if (line[at] == '$') {
        const auto end = up_to("$", at + 1, "$");
        const std::string formula = term(line.substr(at + 1, end - at - 1));
        at = end + 1;
        result += raw_inline(with_punctuation(formula, line, at));
      } else if (line[at] == '`' || line.compare(at, 2, "](") == 0) {
        const auto end =
            up_to(line[at] == '`' ? "`" : ")", at + 2, line.substr(at, 2));
        result += line.substr(at, end + 1 - at);
        at = end + 1;
      } else if (std::isdigit(at_letter(line, at)) != 0) {
        throw Refusal(
            "a number is typed: \"" + line.substr(at, 12) +
            "...\"; print it in tutorial.cpp and refer to it as {{name}}");
      } else {
        result += line[at++];
      }
    }
    return result;
  }

  /// No line may break between a formula and the comma after it: those signs go with it, and
  /// `at` past them.
  static std::string with_punctuation(const std::string& html,
                                      const std::string& line, std::size_t& at) {
    if (html.find("<math") == std::string::npos) return html;
    const std::size_t end =
        std::min(line.find_first_not_of(".,;:?!)'", at), line.size());
    const std::string signs = line.substr(at, end - at);
    at = end;
    return signs.empty()
               ? html
               : "<span class=\"joined\">" + html + html_escaped(signs) + "</span>";
  }

  static int at_letter(const std::string& line, std::size_t at) {
    return static_cast<unsigned char>(line[at]);
  }

  std::string reference(const std::string& text) {
    const auto colon = text.find(':');
    if (colon == std::string::npos) {
      if (printed(text).is_block)
        throw Refusal("{{" + text + "}} is a block: put it on a line of its own");
      return "<span class=\"value\">" + value(printed(text).value) + "</span>";
    }
    const std::string kind = text.substr(0, colon), name = text.substr(colon + 1);
    if (kind == "theorem") return theorem_inline(step(name));
    if (kind == "left") return side_inline(step(name).from);
    if (kind == "right") return side_inline(step(name).to);
    if (kind == "math") return side_inline(printed(name).value);
    throw Refusal("{{" + text +
                  "}} is of no known kind, or not on a line of its own");
  }

  std::string chapter_link(const std::string& name) {
    const auto found = around_.chapters.find(name);
    if (found == around_.chapters.end())
      throw Refusal("no chapter is called " + name);
    return "[" + found->second + "](" + name + ".html)";
  }

  const proof::Step& step(const std::string& id) {
    const auto found = around_.steps.find(id);
    if (found == around_.steps.end()) throw Refusal("no theorem is called " + id);
    return found->second;
  }

  const Printed& printed(const std::string& name) {
    for (const Printed& each : chapter_.printed)
      if (each.name == name) {
        used_.insert(name);
        return each;
      }
    throw Refusal("the program prints nothing called " + name);
  }

  std::string figure(const std::string& kind, const std::string& name,
                     const std::string& caption) {
    if (kind == "plot")
      for (const std::string& block :
           names_in(read(chapter_.folder / (name + ".gnuplot"))))
        printed(block);
    const std::string image = around_.draw(chapter_, kind, name);
    return raw_block(
               "<figure><div class=\"scroll\" tabindex=\"0\" role=\"group\" "
               "aria-label=\"figure\">" +
               image + "</div><figcaption>") +
           "\n" + inline_text(caption) + "\n" + raw_block("</figcaption></figure>");
  }

  std::string command(const std::string& line) {
    const std::string name = "magicmass ";
    if (!line.starts_with(name))
      throw Refusal("{{run:" + line + "}} must begin with \"magicmass \"");
    // as a reader does: from the folder that holds tutorials/
    const std::string there =
        std::filesystem::absolute(chapter_.folder / "../..").string();
    const Ran ran =
        run("cd " + quoted(there) + " && " +
            quoted(std::filesystem::absolute(around_.magicmass).string()) + " " +
            line.substr(name.size()));
    if (ran.status != 0)
      throw Refusal("`" + line + "` ends with exit code " +
                    std::to_string(ran.status));
    return code_block(
        "", "$ " + line + "\n" +
                ran.output.substr(0, ran.output.find_last_not_of('\n') + 1));
  }

  std::string exercise_list() {
    std::string list;
    for (const Exercise& exercise : exercises(chapter_.folder))
      list +=
          "- " + exercise.title + " (`magicmass learn show " + exercise.id + "`)\n";
    return list.empty() ? ""
                        : "\nTo be solved with `magicmass learn`, which tells you "
                          "why an answer is "
                          "wrong:\n\n" +
                              list;
  }
};

}  // namespace

std::string expanded(const Chapter& chapter, const Surroundings& surroundings) {
  return Expansion(chapter, surroundings).all();
}

int reading_minutes(const std::string& markdown) {
  constexpr double words_a_minute = 160, seconds_a_display = 20;
  std::istringstream stream(markdown);
  int words = 0, displays = 0;
  bool is_html = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      is_html = line == "```{=html}";
      displays += is_html ? 1 : 0;
    }
    if (is_html) continue;
    std::istringstream text(line);
    for (std::string word; text >> word;) ++words;
  }
  return static_cast<int>(words / words_a_minute +
                          displays * seconds_a_display / 60 + 0.5);
}

}  // namespace magicmass::course
