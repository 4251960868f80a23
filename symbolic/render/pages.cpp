#include <regex>
#include <sstream>

#include "render/visitor.hpp"

namespace render {
namespace {
std::string listed(const auto& all, const auto& print, const std::string& between) {
  std::string out;
  for (const auto& one : all) out += (out.empty() ? "" : between) + print(one);
  return out;
}
std::string because(const Step& s, std::string (*link)(const std::string&)) {
  return s.rule + (s.premises.empty() ? "" : " from " + listed(s.premises, link, ", "));
}
/// A conjunction is shown a line a part.
Exprs lines_of(Expr f) { return f.op() == Op::And ? f.args() : Exprs{f}; }
/// What a page puts around its parts.
struct Markup {
  std::string (*name)(const std::string& head, const std::string& index);
  std::string (*escaped)(const std::string& words);
  std::string (*heading)(const std::string& title);
  std::string (*paragraph)(const std::string& inside, const std::string& id);
  std::string (*in_line)(Expr);
  std::string (*block)(Expr);
  std::string (*own_id)(const std::string& id);
  std::string (*link)(const std::string& id);
  std::string (*reason)(const std::string& inside);
};
/// ", j and n integers" for the integers among the variables of formulas.
std::string integers(const Exprs& formulas, const auto& print) {
  std::set<Expr> found;
  for (const Expr& f : formulas) found.merge(free_variables(f));
  std::erase_if(found, [](Expr v) { return v.sort() != kernel::Sort::Int; });
  if (found.empty()) return "";
  return ", " + listed(found, print, " and ") + (found.size() == 1 ? " an integer" : " integers");
}
/// In a line of words, or each by itself where one is too wide for that: nothing breaks it.
std::string conditions(const Markup& m, const std::string& before, const Exprs& all,
                       const std::string& between, const std::string& after) {
  constexpr std::size_t columns = 40;
  const auto is_wide = [](Expr e) { return kernel::text(e).size() > columns; };
  if (all.empty()) return "";
  if (std::none_of(all.begin(), all.end(), is_wide))
    return m.paragraph(before + listed(all, m.in_line, between) + after, "");
  std::string out = m.paragraph(before.substr(0, before.find(' ')), "");
  for (const Expr& condition : all) out += m.block(condition);
  return after.size() == 1 ? out : out + m.paragraph(after.substr(2), "");
}
/// Words with the names in them as formulas have them: M_1, P_(n+1), alpha.
std::string with_names(const std::string& words, const Markup& m) {
  static const std::regex names("([A-Za-z]+)(?:_\\(([^)]*)\\)|_(\\w+))?");
  std::string out;
  auto done = words.begin();
  for (std::sregex_iterator i(words.begin(), words.end(), names), end; i != end; ++i) {
    const std::smatch& found = *i;
    if (found[0].length() == found[1].length() && !greek.contains(found[1])) continue;
    out += m.escaped({done, found[0].first}) + m.name(found[1], found[2].str() + found[3].str());
    done = found[0].second;
  }
  return out + m.escaped({done, words.end()});
}
std::string page(const std::vector<Section>& sections, const Markup& m) {
  std::string out;
  for (const Section& section : sections) {
    out += m.heading(with_names(section.title, m));
    out += conditions(m, "Throughout: ", section.assumptions, ", ",
                      integers(section.assumptions, m.in_line) + ".");
    for (const Step& s : section.steps) {
      out += m.paragraph(with_names(s.words, m), s.id);
      out += conditions(m, "If ", s.conditions, " and ", ":");
      for (const Expr& line : lines_of(s.formula)) out += m.block(line);
      out += m.reason(m.own_id(s.id) + (s.label.empty() ? "" : " (" + m.escaped(s.label) + ")") +
                      ": " + because(s, m.link));
    }
  }
  return out;
}
std::string escaped(const std::string& text, const std::map<char, std::string>& escapes) {
  std::string out;
  for (const char c : text) {
    const auto found = escapes.find(c);
    out += found == escapes.end() ? std::string(1, c) : found->second;
  }
  return out;
}
std::string as_it_is(const std::string& text) { return text; }
std::string between_lines(const std::string& inside, const std::string& /*id*/) {
  return "\n" + inside + "\n";
}
std::string in_dollars(Expr e) { return "$" + latex(e) + "$"; }
/// A long formula as a line of text, which TeX breaks at its signs.
std::string shown_in_latex(Expr e) {
  constexpr std::size_t fits = 240;
  const std::string text = latex(e);
  return text.size() <= fits ? "\\[" + text + "\\]\n"
                             : "\n{\\raggedright $\\displaystyle " + text + "$\\par}\n\n";
}
std::string in_latex(const std::string& text) {
  return escaped(text, {{'_', "\\_"}, {'^', "\\^{}"}, {'&', "\\&"}, {'%', "\\%"}, {'#', "\\#"}});
}
}  // namespace

std::string wrapped(const std::string& text, const std::string& indent) {
  std::string out, line = indent;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() > indent.size() && line.size() + 1 + word.size() > 80) {
      out += line + "\n";
      line = indent + "  ";
    }
    line += (line.find_first_not_of(' ') == std::string::npos ? "" : " ") + word;
  }
  return out + line + "\n";
}

std::string html_text(const std::string& words) {
  return escaped(words, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}
std::string html_link(const std::string& to, const std::string& html, const std::string& more) {
  return "<a href=\"" + to + "\"" + more + ">" + html + "</a>";
}
std::string html_code(const std::string& text, const std::string& more) {
  return "<pre tabindex=\"0\"" + more + "><code>" + html_text(text) + "</code></pre>";
}
std::string html_lines(Expr e) {
  std::string out;
  for (const Expr& line : lines_of(e)) {
    const bool is_long = line.op() == Op::Iff && line.arg(1).op() == Op::And;
    if (is_long) out += mathml(line.arg(0), true) + "<p>if and only if</p>";
    for (const Expr& part : is_long ? line.arg(1).args() : Exprs{line}) out += mathml(part, true);
  }
  return out;
}
std::string html_page(const std::string& title, const std::string& head, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
         html_text(title) + "</title>\n" + head + "</head>\n<body>\n" + body + "</body>\n</html>\n";
}

std::string text_page(const std::vector<Section>& sections) {
  const auto print = [](Expr e) { return kernel::text(e); };
  std::string out;
  for (const Section& section : sections) {
    out += (out.empty() ? "" : "\n\n") + section.title + "\n" +
           std::string(section.title.size(), '=') + "\n";
    if (!section.assumptions.empty())
      out += wrapped("Throughout: " + listed(section.assumptions, print, ", ") +
                         integers(section.assumptions, print) + ".",
                     "");
    for (const Step& s : section.steps) {
      out += "\n" + wrapped(s.words, "");
      if (!s.conditions.empty()) out += wrapped("if " + listed(s.conditions, print, " and "), "  ");
      for (const Expr& line : lines_of(s.formula)) out += wrapped(print(line), "    ");
      out += wrapped("[" + s.id + "]" + (s.label.empty() ? "" : " (" + s.label + ")") + " by " +
                         because(s, as_it_is),
                     "  ");
    }
  }
  return out;
}
std::string markdown_page(const std::vector<Section>& sections) {
  return page(sections, {.name = latex_name,
                         .escaped = as_it_is,
                         .heading = [](const std::string& title) { return "\n## " + title + "\n"; },
                         .paragraph = between_lines,
                         .in_line = in_dollars,
                         .block = [](Expr e) { return "\n$$" + latex(e) + "$$\n"; },
                         .own_id = [](const std::string& id) { return "`" + id + "`"; },
                         .link = as_it_is,
                         .reason = [](const std::string& inside) { return "\n" + inside + "\n"; }});
}
std::string latex_page(const std::vector<Section>& sections) {
  const Markup markup{
      .name = latex_name,
      .escaped = in_latex,
      .heading = [](const std::string& title) { return "\n\\section{" + title + "}\n"; },
      .paragraph = between_lines,
      .in_line = in_dollars,
      .block = shown_in_latex,
      .own_id = [](const std::string& id) { return "\\texttt{" + in_latex(id) + "}"; },
      .link = in_latex,
      .reason = [](const std::string& inside) { return "{\\footnotesize " + inside + "}\n"; }};
  return "\\documentclass{article}\n\\usepackage{amsmath}\n"
         "\\usepackage[margin=2cm]{geometry}\n\\sloppy\n\\begin{document}\n" +
         page(sections, markup) + "\\end{document}\n";
}
std::string html_body(const std::vector<Section>& sections) {
  const auto link = [](const std::string& id) { return html_link("#" + id, id); };
  return page(
      sections,
      {.name = mathml_name,
       .escaped = html_text,
       .heading = [](const std::string& title) { return "<h2>" + title + "</h2>\n"; },
       .paragraph =
           [](const std::string& inside, const std::string& id) {
             return (id.empty() ? "<p>" : "<p id=\"" + id + "\">") + inside + "</p>\n";
           },
       .in_line = [](Expr e) { return mathml(e, false); },
       .block = [](Expr e) { return mathml(e, true) + "\n"; },
       .own_id = link,
       .link = link,
       .reason =
           [](const std::string& inside) { return "<p class=\"reason\">" + inside + "</p>\n"; }});
}
std::string html_page(const std::vector<Section>& sections) {
  const std::string style =
      "<style>\nbody { max-width: 50em; margin: auto; padding: 1em; font-family: serif; }\n"
      "math[display] { overflow: auto hidden; margin: 0.5em 0; }\n"
      ".reason { font-size: smaller; color: #444; }\n</style>\n";
  return html_page("Derivation", style, html_body(sections));
}
}  // namespace render
