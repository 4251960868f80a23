#include <regex>
#include <sstream>

#include "learn/terms.hpp"
#include "magicmass/scenes/files.hpp"

namespace learn {
namespace {

using Pairs = std::map<std::string, std::string>;

/// Each once. No other file includes <regex>, which takes seconds to compile.
const std::regex& compiled(const std::string& pattern) {
  static std::map<std::string, std::regex> all;
  return all.try_emplace(pattern, pattern).first->second;
}

/// Visits keys, each with the member for its value.
void each(const auto& visit, const char* key, auto& member, auto&... others) {
  visit(key, member);
  if constexpr (sizeof...(others) > 0) each(visit, others...);
}
void each_key(Misconception& m, const auto& visit) {
  each(visit, "name", m.name, "answers", m.answers, "replace", m.replace, "feedback", m.feedback);
}
void each_key(Exercise& e, const auto& visit) {
  each(visit, "id", e.id, "title", e.title, "chapter", e.chapter, "kind", e.kind, "prompt",
       e.prompt, "name", e.name, "symbols", e.symbols, "values", e.values, "domain", e.domain,
       "form", e.form, "answer", e.answer, "answer_from", e.answer_from, "run", e.run, "within",
       e.within, "choices", e.choices, "when", e.when, "laws", e.laws, "start", e.start, "unknowns",
       e.unknowns, "not_zero", e.not_zero, "starter", e.starter, "driver", e.driver,
       "solution_code", e.solution_code, "inputs", e.inputs, "cases", e.cases, "outputs", e.outputs,
       "words", e.words, "hints", e.hints, "solution", e.solution, "misconceptions",
       e.misconceptions);
}

/// Reads keys of one file, and says where something is wrong.
struct Reader {
  std::string source;
  Pairs variant = {};  // that fills the texts

  [[noreturn]] void refuse(const toml::node& at, const std::string& what) const {
    throw InvalidInput(source + ":" + std::to_string(at.source().begin.line) + ": " + what);
  }
  void read(const std::string& key, const toml::node& node, std::string& to) const {
    if (!node.is_string()) refuse(node, key + ": a text is expected, in quotation marks");
    to = node.as_string()->get();
    while (to.ends_with('\n')) to.pop_back();
    for (const auto& [name, value] : variant) replace_all(to, "{" + name + "}", value);
    const Texts open = matched(variant.empty() ? "" : to, R"([\s\S]*\{([A-Za-z]\w*)\}[\s\S]*)");
    if (!open.empty()) refuse(node, key + ": no variant has {" + open[1] + "}");
  }
  template <class Item>
  void read(const std::string& key, const toml::node& node, std::vector<Item>& to) const {
    const bool is_texts = std::is_same_v<Item, std::string>;
    if (!node.is_array())
      refuse(node, key + (is_texts ? ": texts are expected, [\"...\", \"...\"]"
                                   : ": several are expected, with brackets around each"));
    for (const toml::node& one : *node.as_array()) read(key, one, to.emplace_back());
  }
  void read(const std::string& key, const toml::node& node, Pairs& to) const {
    if (!node.is_table()) refuse(node, key + ": names and texts are expected, { V = \"1\" }");
    for (const auto& [name, one] : *node.as_table()) read(key, one, to[std::string(name.str())]);
  }
  /// Each has the same names, and each name is in a text.
  std::vector<Pairs> variants(const toml::node& node, std::string_view text) const {
    if (!node.is_array() || node.as_array()->empty())
      refuse(node, "variants: at least one is expected, [{ alpha = \"1/7\" }, ...]");
    std::vector<Pairs> all;
    for (const toml::node& one : *node.as_array()) {
      read("variants", one, all.emplace_back());
      for (const auto& [name, value] : all.back())
        if (!all[0].contains(name) || text.find("{" + name + "}") == text.npos)
          refuse(one, "variants: {" + name + "} is not in each variant and in a text");
      if (all.back().size() != all[0].size()) refuse(one, "variants: a name is missing");
    }
    return all;
  }
  void read(const std::string& of, const toml::node& node, Misconception& to) const {
    if (!node.is_table()) refuse(node, of + ": [[" + of + "]] is expected");
    read_keys(*node.as_table(), {}, " in a misconception", to);
    if (to.name.empty() || (to.answers.empty() && to.replace.empty()) || to.feedback.empty())
      refuse(node, "a misconception needs a name, answers (or, of code, replace) and feedback");
  }
  /// Each key to the member of its name; `known` are read elsewhere.
  void read_keys(const toml::table& table, Texts known, const std::string& in, auto& to) const {
    each_key(to, [&](const std::string& key, auto& member) {
      known.push_back(key);
      if (const toml::node* node = table.get(key)) read(key, *node, member);
    });
    for (const auto& [name, node] : table) {
      const std::string key(name.str());
      if (std::ranges::count(known, key) == 0)
        refuse(node, "no such key" + in + ": " + answers::shown_text(key, 40) +
                         meant(key, known, "; allowed: " + answers::joined(known)));
    }
  }
  void check(const toml::table& file, const Exercise& e) const {
    const auto need = [&](bool fine, const std::string& what) {
      if (!fine) refuse(file, what);
    };
    need(e.kind != "code" || e.variants.empty(), "variants: not of code, which has cases");
    std::string keys = "id title chapter kind prompt";
    if (e.kind == "code") keys += " starter driver solution_code inputs cases outputs words within";
    for (const std::string& key : split(keys, ' ')) need(file.contains(key), key + " is missing");
    need(!matched(e.id, "[A-Za-z0-9_]+").empty(),
         "id: allowed: letters, digits and _, since answers are in files of that name");
    need(e.kind == "symbolic" || e.kind == "predict" || e.kind == "derivation" || e.kind == "code",
         "kind: allowed: symbolic, predict, derivation, code");
    if (e.kind == "code") {
      need(e.inputs.size() <= 16 && e.outputs.size() <= 16, "inputs and outputs: at most 16");
      need(e.words.size() == e.outputs.size(), "words: one text for each of the outputs");
      for (const Texts& one : e.cases)
        need(one.size() == e.inputs.size(), "cases: one text for each of the inputs");
      need(!e.cases.empty() && e.cases.size() <= 100, "cases: 1 to 100");
      return;
    }
    need(!e.answer.empty() || !e.answer_from.empty() || !e.when.empty(),
         "answer is missing; allowed: answer, answer_from or, with choices, when");
    const Texts all_forms = forms();
    need(e.form.empty() || std::ranges::count(all_forms, e.form) == 1,
         "form: allowed: " + answers::joined(all_forms));
    need(e.when.empty() || e.when.size() == e.choices.size(), "when: one for each of the choices");
    need(e.choices.size() <= 26, "choices: at most 26");
    need(e.kind == "predict" || (e.choices.empty() && e.within.empty()),
         "choices and within: not of kind " + e.kind);
    need(e.kind != "derivation" || !e.laws.empty(), "laws are missing");
    need(e.start.empty() || !e.form.empty(), "form is missing, which ends the chain from start");
  }
};

}  // namespace

Exercise read_exercise(std::string_view text, const std::string& source, std::size_t variant) {
  const toml::table file = magicmass::scenes::table_of(
      text, source, "an exercise in TOML, lines like kind = \"symbolic\"");
  Reader in{source};
  Exercise e;
  e.source = source;
  if (const toml::node* node = file.get("variants")) {
    e.variants = in.variants(*node, text);
    in.variant = e.variants[variant % e.variants.size()];
  }
  in.read_keys(file, {"variants"}, "", e);
  in.check(file, e);
  const toml::node& at = file.contains("misconceptions") ? *file.get("misconceptions") : file;
  for (Misconception& m : e.misconceptions) {
    if (!m.replace.empty()) m.answers.push_back(e.solution_code);
    for (const Texts& edit : m.replace) {
      std::string& code = m.answers.back();
      if (edit.size() != 2) in.refuse(at, "replace: two texts are expected, what and by what");
      if (edit[0].empty() || code.find(edit[0]) == code.npos)
        in.refuse(at, "replace: \"" + answers::shown_text(edit[0]) + "\" is not in solution_code");
      replace_all(code, edit[0], edit[1]);
    }
  }
  return e;
}

Texts fields(const std::string& text, char separator) {
  std::istringstream stream(text);
  Texts all;
  for (std::string field; std::getline(stream, field, separator);) all.push_back(field);
  return all;
}

Texts split(const std::string& text, char separator) {
  constexpr const char* blanks = " \t\r";
  Texts parts;
  for (const std::string& part : fields(text, separator))
    if (const std::size_t begin = part.find_first_not_of(blanks); begin != part.npos)
      parts.push_back(part.substr(begin, part.find_last_not_of(blanks) + 1 - begin));
  return parts;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

Texts matched(const std::string& text, const std::string& pattern) {
  std::smatch part;
  if (!std::regex_match(text, part, compiled(pattern))) return {};
  return {part.begin(), part.end()};
}

std::string replaced(const std::string& text, const std::string& pattern,
                     const std::function<std::string(const Texts& part)>& by) {
  std::string out;
  auto rest = text.begin();
  for (std::sregex_iterator it(rest, text.end(), compiled(pattern)), end; it != end; ++it) {
    out.append(rest, it->prefix().second).append(by({it->begin(), it->end()}));
    rest = it->suffix().first;
  }
  return out.append(rest, text.end());
}

}  // namespace learn
