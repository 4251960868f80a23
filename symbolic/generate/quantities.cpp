// Reads quantities.txt and hands its theorems to the generator.
#include "generate/quantities.hpp"

#include <algorithm>
#include <sstream>

#include "codegen/operations.hpp"
#include "derivation/book.hpp"
#include "notation/alpha.hpp"
#include "notation/typed.hpp"

namespace generate {
extern const char* const quantities_text;  // of the file, by CMake
using codegen::Case;
using codegen::Condition;
using codegen::PlainForm;
using codegen::Refused;

kernel::Theorems Source::at(const std::string& words, const kernel::Substitution& terms) {
  kernel::Theorems out;
  std::istringstream in(words);
  std::string chapter;
  for (std::string word; in >> word;) {
    const std::size_t dot = word.find('.');
    if (dot != std::string::npos) chapter = word.substr(0, dot + 1);
    const std::string name = word.substr(dot == std::string::npos ? 0 : dot + 1);
    const std::size_t slash = name.find('/');
    const std::string id = chapter + name.substr(0, slash);
    kernel::Theorem t = derivation::the_book()[id];
    if (slash != std::string::npos)
      t = kernel::tautology(t.conclusion().arg(std::stoul(name.substr(slash + 1))), {t});
    out.push_back(kernel::instantiate(t, terms));
    ids.insert({out.back().conclusion(), id});
  }
  return out;
}
Case Source::of(const std::string& name, const std::vector<Condition>& where,
                const std::string& words, const kernel::Substitution& terms) {
  const std::size_t to = words.find("->");
  if (to == std::string::npos) throw Refused("no -> before outputs: " + words);
  return {name, where, at(words.substr(0, to), terms), at(words.substr(to + 2), terms), {}, {}};
}

namespace {
class Reader {
public:
  Inventory made;
  explicit Reader(const std::string& text) {
    derivation::the_book();  // declares the names
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream in(line.substr(0, line.find('#')));
      for (std::string word; in >> word;)
        if (word.ends_with(":")) {
          take_entry();
          entry = word;
        } else if (word[0] == '$') {
          const codegen::Words& meant = lets.at(word);
          words.insert(words.end(), meant.begin(), meant.end());
        } else {
          words.push_back(word);
        }
    }
    take_entry();
  }

private:
  std::string entry;
  codegen::Words words;  // of the entry
  std::map<std::string, codegen::Words> lets;
  std::string form;  // of what is next
  double most_in_float = codegen::infinity;

  codegen::Quantity& quantity() { return made.all.back().quantity; }
  Case& last() { return quantity().cases.back(); }
  std::string text() const { return codegen::joined(words, " "); }
  /// "alpha 0 1 n 0 5 0 9"
  std::vector<Condition> ranges() const {
    std::vector<Condition> all;
    for (std::size_t k = 0; k < words.size();) {
      const std::string& term = words[k++];
      std::vector<double> ends;
      for (; k < words.size() && notation::read_double(words[k]); ++k)
        ends.push_back(*notation::read_double(words[k]));
      if (ends.size() != 2 && ends.size() != 4)
        throw Refused(entry + " " + term + " has " + std::to_string(ends.size()) +
                      " ends; allowed: 2, and 2 in MPFR's numbers");
      const codegen::Interval wide{ends[ends.size() - 2], ends.back()};
      all.push_back({term, {ends[0], ends[1]}, wide});
    }
    return all;
  }
  kernel::Substitution terms() const {
    kernel::Substitution r;
    for (std::size_t k = 0; k + 1 < words.size(); k += 2)
      r.emplace(notation::read(words[k]), notation::read(words[k + 1]));
    return r;
  }
  const std::map<std::string, std::function<void()>> entries{
      {"", [] {}},
      {"form:", [this] { form = text(); }},
      {"float:", [this] { most_in_float = notation::read_double(words.at(0)).value(); }},
      {"let:", [this] { lets["$" + words.at(0)].assign(words.begin() + 1, words.end()); }},
      {"quantity:",
       [this] {
         made.all.push_back({{text(), "", {}, {}, made.source.units}, form, most_in_float});
       }},
      {"labels:", [this] { quantity().labels = text(); }},
      {"arrays:", [this] { quantity().has_arrays = true; }},
      {"untested:", [this] { quantity().is_tested = false; }},
      {"units:", [this] { quantity().units = terms(); }},
      {"doubling:",
       [this] {
         const kernel::Theorems t = made.source.at(text(), quantity().units);
         quantity().doubling = {t.at(0), t.at(1), t.at(2), t.at(3)};
       }},
      {"recursions:", [this] { quantity().recursions = made.source.at(text(), quantity().units); }},
      {"inputs:",
       [this] {
         for (const Condition& c : ranges())
           quantity().inputs.push_back({notation::read(c.name), c.range, *c.wide_range});
       }},
      {"zeros:",
       [this] {
         for (codegen::Input& i : quantity().inputs)
           i.may_be_zero = std::ranges::count(words, i.name()) > 0;
       }},
      {"case:", [this] { quantity().cases.push_back({text()}); }},
      {"where:", [this] { last().where = ranges(); }},
      {"theorems:",
       [this] {
         if (quantity().cases.empty()) quantity().cases.push_back({"all"});
         last() = made.source.of(last().name, last().where, text(), quantity().units);
       }},
      {"facts:",
       [this] {
         for (const kernel::Theorem& t : made.source.at(text(), quantity().units))
           last().facts.emplace_back(t);
       }},
      {"computed:", [this] { last().facts.back().of_computed = text(); }},
      {"guards:", [this] { last().guards = ranges(); }},
      {"divisors:", [this] { last().divisors = words; }}};
  void take_entry() {
    const auto found = entries.find(entry);
    if (found == entries.end()) throw Refused("quantities.txt: no entry is called " + entry);
    found->second();
    words.clear();
  }
};
}  // namespace

Inventory read(const std::string& text) { return Reader(text).made; }
const Inventory& inventory() {
  static const Inventory made = read(quantities_text);
  return made;
}
std::vector<codegen::Quantity> evaluators() {
  std::vector<codegen::Quantity> r;
  for (const PlainForm& f : inventory().all)
    if (f.form == "evaluator") r.push_back(f.quantity);
  return r;
}
Texts texts(const std::vector<PlainForm>& all, const codegen::Ids& ids) {
  std::vector<codegen::Emitted> emitted;
  std::map<std::string, std::vector<PlainForm>> plain;
  for (const PlainForm& f : all)
    if (f.form == "evaluator")
      emitted.push_back(codegen::emit_evaluator(f.quantity, ids));
    else
      plain[f.form].push_back(f);
  for (const auto& [form, forms] : plain) emitted.push_back(codegen::emit_plain(forms, ids));
  std::string errors =
      "What each value may be off by, in sizes of computed values, tier by tier.\n";
  codegen::Words manifest;
  Texts files{{"magicmass/evaluators/polynomials.hpp", codegen::emit_polynomials()}};
  for (const codegen::Emitted& e : emitted) {
    if (!files.insert({"magicmass/" + e.path, e.header}).second)
      throw Refused("two files are called " + e.path);
    errors += e.errors;
    manifest.insert(manifest.end(), e.manifest.begin(), e.manifest.end());
  }
  files["magicmass/evaluators/errors.txt"] = errors;
  files["manifest.json"] = "[\n  " + codegen::joined(manifest, ",\n  ") + "\n]\n";
  return files;
}
Texts generated() { return texts(inventory().all, inventory().source.ids); }
std::string selected(const std::string& form, const std::set<std::string>& outputs,
                     const std::set<std::string>& quantities, const std::string& more) {
  static const std::set<std::string> of_scenes{"shape", "two_collisions"};
  std::vector<PlainForm> forms;
  for (const PlainForm& f : inventory().all)
    if (f.form == form && form != "matrices" && form != "evaluator" &&
        !of_scenes.contains(f.quantity.name) &&
        (quantities.empty() || quantities.contains(f.quantity.name)))
      forms.push_back(f);
  if (forms.empty())
    throw Refused("no form " + form + "; allowed: closed, product, tangent, exact, restitution");
  return codegen::emit_plain(forms, inventory().source.ids, outputs, more).header;
}
}  // namespace generate
