#include "course/chapter.hpp"

#include <memory>

#include <cmark.h>

#include "magicmass/scenes/files.hpp"

namespace course {
namespace {

namespace fs = std::filesystem;

const std::string sections =
    "Goal, Derivation, Check it yourself, Exercises, Possibilities for extensions";

/// What cannot break from the sign after it.
std::string in_words(kernel::Expr e) { return render::mathml(e, false) + "&#x2060;"; }

std::string display(kernel::Expr e) {
  return "<div class=\"equation\" tabindex=\"0\" role=\"group\" aria-label=\"formula\">" +
         render::html_lines(e) + "</div>";
}

std::string theorem(const render::Step& s) {
  std::string conditions;
  for (const kernel::Expr& c : s.conditions)
    conditions += (conditions.empty() ? " if " : " and ") + in_words(c);
  return "\n<div class=\"theorem\" data-theorem=\"" + s.id + "\">" + display(s.formula) +
         "<p class=\"source\">" + html_link("derivation.html#" + s.id, s.id) + conditions +
         "</p></div>";
}

/// Paragraphs and blocks of indented lines of a text in which no sign is Markdown's.
std::string plain_html(const std::string& text) {
  const std::string parts = "((?:    .*\n)+|(?:(?!    ).+\n)+)\n*";
  return learn::replaced(text + "\n", parts, [](const learn::Texts& part) {
    if (!part[1].starts_with("    ")) return "<p>" + html_text(part[1]) + "</p>\n";
    std::string code = part[1].substr(4);
    learn::replace_all(code, "\n    ", "\n");
    return html_code(code);
  });
}

/// From Markdown with references to HTML. What is looked up stands in the Markdown as a number
/// between control characters, which cmark leaves alone, and is put in afterwards.
struct Expansion {
  const Chapter& chapter;
  const Surroundings& around;
  Texts printed = {}, session = {};
  std::set<std::string> not_shown = {};
  Texts pieces = {};  ///< by what stands for them; a block begins with a line's end

  std::string html() {
    const std::string below_title = chapter.text.substr(chapter.text.find('\n') + 1);
    std::string markdown, found;
    int number = 1;
    bool in_code = false;
    try {
      printed = read_printed(chapter.printed);
      session = read_session(chapter.session);
      for (const auto* all : {&printed, &session})
        for (const auto& [name, text] : *all) not_shown.insert(name);
      for (const std::string& line : learn::fields(below_title, '\n')) {
        ++number;
        if (line.starts_with("## ")) found += (found.empty() ? "" : ", ") + line.substr(3);
        const bool is_fence = line.starts_with("```");
        in_code = in_code != is_fence;
        markdown += (in_code || is_fence ? line : expanded(line)) + "\n";
      }
      if (found != sections) throw InvalidInput("its sections (##) must be: " + sections);
      if (!not_shown.empty()) throw InvalidInput("printed, never shown: " + *not_shown.begin());
    } catch (const InvalidInput& error) {
      throw InvalidInput(chapter.source + ":" + std::to_string(number) + ": " + error.what());
    }
    return with_pieces(html_of(markdown));
  }

  std::string piece(const std::string& html) {
    return pieces.emplace("\x01" + std::to_string(pieces.size()) + "\x01", html).first->first;
  }
  std::string with_pieces(std::string html) const {
    for (const auto& [mark, piece] : pieces) {
      const std::string stand_in = piece.starts_with("\n") ? "<p>" + mark + "</p>" : mark;
      const std::size_t at = html.find(stand_in);
      if (at == html.npos) throw InvalidInput(chapter.source + ": {{...}} in HTML is left out");
      html.replace(at, stand_in.size(), piece);
    }
    return html;
  }

  std::string expanded(const std::string& line) {
    // A reference, a term; what stays: code, a link's target, a list's number; what is refused.
    const std::string special =
        R"(\{\{(.+?)\}\}|\$(.+?)\$|(`.*?`|\]\(.*?\)|^[ 0-9]*\. )|(\{\{|\$|`|\]\()|([0-9].*|)"
        R"((eleven|twelve|\w+teen|(twen|thir|for|fif|six|seven|eigh|nine)ty|hundred and)\b.*))";
    static const Texts ends{{"{{", "}}"}, {"$", "$"}, {"`", "`"}, {"](", ")"}};
    const bool is_alone = line.starts_with("{{") && line.find("}}") == line.size() - 2;
    const std::string out = learn::replaced(line, special, [&](const learn::Texts& part) {
      if (!part[1].empty()) {
        const std::string html = reference(part[1], is_alone);
        if (html.starts_with("\n") && !is_alone)
          throw InvalidInput(part[0] + " needs a line of its own");
        return piece(html);
      }
      if (!part[2].empty()) return piece(term_html(part[2]));
      if (!part[4].empty()) throw InvalidInput(part[4] + " without " + ends.at(part[4]));
      if (!part[5].empty())
        throw InvalidInput("a number is typed: " + answers::shown_text(part[5], 12) +
                           "; print it in tutorial.cpp and refer to it as {{name}}");
      return part[3];
    });
    return is_alone ? "\n" + out + "\n" : out;  // a paragraph of its own
  }

  std::string reference(const std::string& what, bool is_alone) {
    const std::size_t colon = what.find(':');
    const std::string kind = colon == what.npos ? "" : what.substr(0, colon);
    const std::string name = what.substr(colon == what.npos ? 0 : colon + 1);
    if (kind == "theorem") {
      const render::Step& s = step(name);
      return is_alone ? theorem(s) : html_link("derivation.html#" + name, in_words(s.formula));
    }
    if (kind == "left" || kind == "right") {
      const kernel::Expr formula = step(name).formula;
      if (formula.op() != kernel::Op::Eq) throw InvalidInput(name + " is no equation");
      const kernel::Expr side = formula.arg(kind == "left" ? 0 : 1);
      return is_alone ? "\n" + display(side) : in_words(side);
    }
    if (kind == "chapter")
      return html_link(name + ".html", html_text(found(around.chapters, name, "chapter")));
    if (kind == "figure")
      return "<span class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"figure\"><img "
             "src=\"figures/" +
             name + ".svg\" alt=\"" + html_text(found(around.figures, name, "figure")) +
             "\"/></span>";
    if (!kind.empty() && kind != "run") throw InvalidInput("{{" + what + "}} is of no known kind");
    not_shown.erase(name);
    if (kind == "run")
      return "\n" + html_code("$ " + name + "\n" + found(session, name, "command of session.txt"),
                              " data-run=\"" + html_text(name) + "\"");
    if (what == "program") return "\n" + html_code(chapter.program);
    if (what == "exercises") return exercises();
    const std::string& value = found(printed, name, "printed value");
    if (value.ends_with("\n")) return "\n" + block_html(value);
    return "<span data-value=\"" + name + "\">" + value_html(value) + "</span>";
  }
  const render::Step& step(const std::string& id) const {
    for (const render::Section& section : around.derivation)
      for (const render::Step& one : section.steps)
        if (one.id == id) return one;
    throw InvalidInput("no theorem is called " + id);
  }
  const std::string& found(const Texts& all, const std::string& id, const std::string& what) const {
    const auto place = all.find(id);
    if (place == all.end()) throw InvalidInput("no " + what + " is called " + id);
    return place->second;
  }
  std::string exercises() const {
    std::string list = "\n";
    for (const learn::Exercise& e : chapter.exercises) {
      list += "<details data-exercise=\"" + e.id + "\"><summary>" + html_text(e.title) +
              "</summary>" + plain_html(e.prompt);
      for (const std::string& rule : rules(e)) list += "<p>" + html_text(rule) + "</p>\n";
      list += html_code("magicmass learn show " + e.id) + "</details>\n";
    }
    return list;
  }
};

}  // namespace

std::set<fs::path> files_in(const fs::path& folder) {
  return {fs::directory_iterator(folder), fs::directory_iterator()};
}
Chapter read_chapter(const fs::path& folder) {
  using magicmass::scenes::text_of;
  const fs::path source = folder / "intro.md", session = folder / "session.txt";
  Chapter chapter{folder.filename(), source, text_of(source), text_of(folder / "tutorial.cpp"),
                  text_of(folder / "expected_output.txt")};
  if (fs::exists(session)) chapter.session = text_of(session);
  for (const fs::path& file : files_in(folder / "exercises"))
    if (file.extension() == ".toml")
      chapter.exercises.push_back(learn::read_exercise(text_of(file), file));
  return chapter;
}

std::string title_of(const Chapter& chapter) {
  const std::string line = chapter.text.substr(0, chapter.text.find('\n'));
  if (!line.starts_with("# ")) throw InvalidInput(chapter.source + ":1: \"# Title\" is expected");
  return line.substr(2);
}

std::string chapter_html(const Chapter& chapter, const Surroundings& surroundings) {
  return Expansion{chapter, surroundings}.html();
}

std::string html_of(const std::string& markdown) {
  const std::unique_ptr<char, decltype(&std::free)> html(
      cmark_markdown_to_html(markdown.data(), markdown.size(), CMARK_OPT_SMART), &std::free);
  return html.get();
}

}  // namespace course
