// How a page shows what a program printed, and a frame around what chapters say.
#include "course/chapter.hpp"
#include "notation/typed.hpp"

namespace course {
namespace {

std::string formula_or_words(const std::string& text) try {
  return render::mathml(notation::read(text), false);
} catch (const kernel::Refused&) {
  return html_text(text);
}

std::string frame(const std::string& title, const std::string& navigation, const std::string& main,
                  const std::string& bottom = "") {
  const std::string skip = html_link("#main", "To the text", " class=\"skip\"");
  const std::string header = "<header><nav aria-label=\"Course\">" + navigation + "</nav></header>";
  return render::html_page(
      title, "<link rel=\"stylesheet\" href=\"course.css\">\n",
      skip + " \n" + header + "\n<main id=\"main\">\n" + main + "</main>\n" + bottom);
}

}  // namespace

Texts read_printed(const std::string& output) {
  Texts all;
  std::string* block = nullptr;
  for (const std::string& line : learn::fields(output, '\n')) {
    if (line.starts_with("#")) continue;
    if (block != nullptr && line.starts_with("  ")) {
      *block += line.substr(2) + "\n";
      continue;
    }
    const auto part = learn::matched(line, "([A-Za-z_0-9]+): *(.*?) *");
    if (part.empty())
      throw InvalidInput("the program prints " + answers::shown_text(line) +
                         "; allowed: \"name: value\", \"name:\" above lines that begin with two "
                         "blanks, \"# ...\"");
    const auto [place, is_new] = all.emplace(part[1], part[2]);
    if (!is_new) throw InvalidInput("the program prints the name " + part[1] + " twice");
    block = part[2].empty() ? &place->second : nullptr;
  }
  return all;
}

Texts read_session(const std::string& session) {
  Texts all;
  std::string* printed = nullptr;
  for (const std::string& line : learn::fields(session, '\n')) {
    if (line.starts_with("$ "))
      printed = &all[line.substr(2)];
    else if (printed != nullptr)
      *printed += line + "\n";
  }
  return all;
}

std::string term_html(const std::string& text) {
  if (text.size() == 1 && std::isupper(static_cast<unsigned char>(text[0])) != 0)
    return "<math><mi>" + text + "</mi></math>&#x2060;";
  const kernel::Expr term = answers::given_by_user(
      "$" + text + "$ is not in the derivation's notation: ", [&] { return notation::read(text); });
  if (kernel::is_formula(term))
    throw InvalidInput("$" + text + "$ claims something; a claim is a theorem: {{theorem:id}}");
  return render::mathml(term, false) + "&#x2060;";
}

std::string value_html(const std::string& text) {
  const auto part = learn::matched(text, "(-?)([0-9.]+)(e([+-])0*([0-9]+))?");
  if (part.empty()) return formula_or_words(text);
  const std::string value = (part[1].empty() ? "" : "−") + part[2];
  if (part[3].empty()) return value;
  const std::string power = (part[4] == "-" ? "10<sup>−" : "10<sup>") + part[5] + "</sup>";
  return value == "1" ? power : value + "·" + power;
}

std::string block_html(const std::string& text) {
  if (text.find(" | ") == text.npos) return html_code(text);
  std::string table;
  for (std::string line : learn::fields(text, '\n')) {
    const bool is_head = table.empty();
    table += is_head ? "<thead><tr>" : "<tr>";
    learn::replace_all(line, " | ", "\t");
    for (const std::string& cell : learn::split(line, '\t'))
      table += is_head ? "<th scope=\"col\">" + formula_or_words(cell) + "</th>"
               : cell.find(' ') != cell.npos ? "<td class=\"words\">" + html_text(cell) + "</td>"
                                             : "<td>" + value_html(cell) + "</td>";
    table += is_head ? "</tr></thead><tbody>\n" : "</tr>\n";
  }
  return "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"table\"><table>" +
         table + "</tbody></table></div>";
}

Texts files_of(const std::vector<Page>& pages, const std::string& top, const std::string& proofs) {
  const std::string title = "Magic mass ratios";
  const std::string contents = html_link("index.html", title);
  const std::string all_proofs = html_link("derivation.html", "All proofs");
  Texts files;
  std::string list, list_on_paper, all;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const Page& page = pages[i];
    const std::string name = html_text(page.title);
    const std::string text = "<p class=\"place\">Chapter " + std::to_string(i + 1) + " of " +
                             std::to_string(pages.size()) + "</p>\n<h1 id=\"" + page.name + "\">" +
                             name + "</h1>\n" + page.html;
    const auto turn = [&](std::size_t to, const std::string& words, const std::string& attributes) {
      if (to >= pages.size()) return std::string();
      return html_link(pages[to].name + ".html", words + html_text(pages[to].title), attributes);
    };
    files[page.name + ".html"] =
        frame(page.title, contents + " " + all_proofs, text,
              "<nav class=\"turn\" aria-label=\"Previous and next\">" +
                  turn(i - 1, "← ", " rel=\"prev\"") + " " +
                  turn(i + 1, "→ ", " rel=\"next\" class=\"next\"") + "</nav>\n");
    list += "<li>" + html_link(page.name + ".html", name) + "</li>\n";
    list_on_paper += "<li>" + html_link("#" + page.name, name) + "</li>\n";
    all += "<section class=\"chapter\">\n" + text + "</section>\n";
  }
  const std::string first = "<h1>" + title + "</h1>\n" + top + "<h2>Chapters</h2>\n<ol>\n";
  files["index.html"] = frame(title, all_proofs, first + list + "</ol>\n");
  files["course.html"] = frame(title, "", first + list_on_paper + "</ol>\n" + all);
  files["derivation.html"] = frame("All proofs", contents, "<h1>All proofs</h1>\n" + proofs);
  return files;
}

}  // namespace course
