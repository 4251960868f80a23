// SPDX-License-Identifier: GPL-2.0-or-later
// What a program printed, and how a page shows it.
#include "answers/errors.hpp"
#include "course/chapter.hpp"
#include "notation/read.hpp"

namespace course {
namespace {

using answers::InvalidInput;
using render::html_text;

std::string formula_or_words(const std::string& text) {
  try {
    return render::mathml(notation::read(text), false);
  } catch (const kernel::Refused&) {
    return html_text(text);
  }
}

}  // namespace

Texts read_printed(const std::string& output) {
  Texts all;
  std::string* block = nullptr;
  for (const std::string& line : learn::fields(output, '\n')) {
    if (line.starts_with("#")) continue;
    const auto part = learn::matched(line, "([A-Za-z_0-9]+): *(.*?) *");
    if (block != nullptr && line.starts_with("  ")) {
      *block += line.substr(2) + "\n";
    } else if (!part.empty()) {
      const auto [place, is_new] = all.emplace(part[1], part[2]);
      if (!is_new) throw InvalidInput("the program prints the name " + place->first + " twice");
      block = place->second.empty() ? &place->second : nullptr;
    } else {
      throw InvalidInput("the program prints " + answers::shown_text(line) +
                         "; allowed: \"name: value\", \"name:\" above lines that begin with two "
                         "blanks, \"# ...\"");
    }
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
  kernel::Expr term;
  try {
    term = notation::read(text);
  } catch (const kernel::Refused& refused) {
    throw InvalidInput("$" + text + "$ is not in the derivation's notation: " + refused.what());
  }
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
  if (text.find(" | ") == text.npos) return code_html(text);
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

std::string code_html(const std::string& text, const std::string& attributes) {
  return "<pre tabindex=\"0\"" + attributes + "><code>" + html_text(text) + "</code></pre>";
}

}  // namespace course
