#include "course/chapter.hpp"

#include <cstdlib>
#include <memory>
#include <sstream>

#include <cmark.h>

#include "magicmass/scenes/files.hpp"

namespace course {
namespace {

namespace fs = std::filesystem;

const std::string sections =
    "Goal, Derivation, Check it yourself, Exercises, Possibilities for extensions";

/// What cannot break from the sign after it.
std::string in_words(kernel::Expr e) { return render::mathml(e, false) + "&#x2060;"; }

std::string display(const kernel::Exprs& lines) {
  std::string out = "<div class=\"equation\" tabindex=\"0\" role=\"group\" aria-label=\"formula\">";
  for (const kernel::Expr& line : lines) {
    const bool is_long = line.op() == kernel::Op::Iff && line.arg(1).op() == kernel::Op::And;
    if (is_long) out += render::mathml(line.arg(0), true) + "<p>if and only if</p>";
    for (const kernel::Expr& part : is_long ? line.arg(1).args() : kernel::Exprs{line})
      out += render::mathml(part, true);
  }
  return out + "</div>";
}

std::string link(const std::string& to, const std::string& inside) {
  return "<a href=\"" + to + "\">" + inside + "</a>";
}

std::string theorem(const render::Step& s) {
  const bool has_parts = s.formula.op() == kernel::Op::And;
  std::string conditions;
  for (const kernel::Expr& c : s.conditions)
    conditions += (conditions.empty() ? " if " : " and ") + in_words(c);
  return "\n<div class=\"theorem\" data-theorem=\"" + s.id + "\">" +
         display(has_parts ? s.formula.args() : kernel::Exprs{s.formula}) + "<p class=\"source\">" +
         link("derivation.html#" + s.id, s.id) + conditions + "</p></div>";
}

/// Paragraphs and blocks of indented lines of a text in which no sign is Markdown's.
std::string plain_html(const std::string& text) {
  const std::string parts = "(    .*\n)+|((?!    ).+\n)+|\n";
  return learn::replaced(text + "\n", parts, [](const learn::Texts& part) -> std::string {
    if (part[0] == "\n") return "";
    if (!part[0].starts_with("    ")) return "<p>" + html_text(part[0]) + "</p>\n";
    std::string code = part[0].substr(4);
    learn::replace_all(code, "\n    ", "\n");
    return code_html(code);
  });
}

/// From Markdown with references to HTML. What is looked up stands in the Markdown as a number
/// between control characters, which cmark leaves alone, and is put in afterwards.
struct Expansion {
  const Chapter& chapter;
  const Surroundings& around;
  Texts printed = {}, session = {};
  std::set<std::string> not_shown = {};
  std::vector<std::string> pieces = {};  ///< a block begins with a line's end

  std::string html() {
    std::istringstream lines(chapter.text);
    std::string markdown, line, found;
    int number = 1;
    bool in_code = false;
    try {
      printed = read_printed(chapter.printed);
      session = read_session(chapter.session);
      for (const auto* all : {&printed, &session})
        for (const auto& [name, text] : *all) not_shown.insert(name);
      std::getline(lines, line);  // the title
      while (std::getline(lines, line)) {
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

  static std::string mark(std::size_t piece) { return "\x01" + std::to_string(piece) + "\x01"; }
  std::string piece(const std::string& html) {
    pieces.push_back(html);
    return mark(pieces.size() - 1);
  }
  std::string with_pieces(std::string html) const {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::string stand_in = pieces[i].starts_with("\n") ? "<p>" + mark(i) + "</p>" : mark(i);
      const std::size_t at = html.find(stand_in);
      if (at == html.npos) throw InvalidInput(chapter.source + ": {{...}} in HTML is left out");
      html.replace(at, stand_in.size(), pieces[i]);
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
      if (!part[1].empty()) return piece(reference(part[1], is_alone));
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
      return is_alone ? theorem(s) : link("derivation.html#" + name, in_words(s.formula));
    }
    if (kind == "left" || kind == "right") {
      const kernel::Expr formula = step(name).formula;
      if (formula.op() != kernel::Op::Eq) throw InvalidInput(name + " is no equation");
      const kernel::Expr side = formula.arg(kind == "left" ? 0 : 1);
      return is_alone ? "\n" + display({side}) : in_words(side);
    }
    if (kind == "chapter")
      return link(name + ".html", html_text(found(around.chapters, name, "chapter")));
    if (kind == "figure")
      return "<span class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"figure\"><img "
             "src=\"figures/" +
             name + ".svg\" alt=\"" + html_text(found(around.figures, name, "figure")) +
             "\"/></span>";
    const bool has_block = kind == "run" || what == "program" || what == "exercises" ||
                           (kind.empty() && found(printed, name, "printed value").ends_with("\n"));
    if (!kind.empty() && kind != "run") throw InvalidInput("{{" + what + "}} is of no known kind");
    if (has_block && !is_alone) throw InvalidInput("{{" + what + "}} needs a line of its own");
    not_shown.erase(name);
    if (kind == "run")
      return "\n" + code_html("$ " + name + "\n" + found(session, name, "command of session.txt"),
                              " data-run=\"" + html_text(name) + "\"");
    if (what == "program") return "\n" + code_html(chapter.program);
    if (what == "exercises") return exercises();
    const std::string& value = printed.at(name);
    return has_block ? "\n" + block_html(value)
                     : "<span data-value=\"" + name + "\">" + value_html(value) + "</span>";
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
      list += code_html("magicmass learn show " + e.id) + "</details>\n";
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
  const fs::path session = folder / "session.txt";
  Chapter chapter{folder.filename(),
                  folder / "intro.md",
                  text_of(folder / "intro.md"),
                  text_of(folder / "tutorial.cpp"),
                  text_of(folder / "expected_output.txt"),
                  fs::exists(session) ? text_of(session) : "",
                  {}};
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
