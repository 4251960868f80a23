// The table of names, and what keeps two things from printing alike.
#include "kernel/names.hpp"

#include <algorithm>

namespace kernel {
namespace {
std::map<std::string, Sort>& variables() {
  static std::map<std::string, Sort> table;
  return table;
}
std::map<std::string, Signature>& functions() {
  const Signature real_function = {{Sort::Real}, Sort::Real};
  static std::map<std::string, Signature> table = {
      {"inv", real_function},  {"sqrt", real_function}, {"sin", real_function},
      {"cos", real_function},  {"atan", real_function}, {"ceil", {{Sort::Real}, Sort::Int}},
      {"pi", {{}, Sort::Real}}};
  return table;
}
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
// Would `name` print as the function at an index: u_1, a_n?
bool reads_as_index(const std::string& name, const std::string& function) {
  const std::string start = stem(function);
  if (!name.starts_with(start)) return false;
  const std::string index = name.substr(start.size());
  if (index.empty()) return true;
  const auto it = variables().find(index);
  return std::all_of(index.begin(), index.end(), is_digit) ||
         (it != variables().end() && it->second == Sort::Int);
}
std::string read_as_index(const std::string& name, const std::string& function) {
  return name + " could be read as " + function + " at an index";
}
std::string why_no_name(const std::string& name) {
  static const std::set<std::string> words = {"all",  "and", "det",     "every",   "for",
                                              "if",   "iff", "implies", "integer", "not",
                                              "only", "or",  "real"};
  const std::string body = name.ends_with('\'') ? name.substr(0, name.size() - 1) : name;
  const bool plain = !body.empty() && body.size() <= 60 && is_letter(body[0]) &&
                     std::all_of(body.begin(), body.end(),
                                 [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
  if (!plain) return "\"" + name + "\" is no name: letter, letters or digits or _, at most one '";
  if (words.count(name)) return "\"" + name + "\" is a word of the notation, no name";
  for (const auto& [function, s] : functions())
    if (s.indexed() && reads_as_index(name, function)) return read_as_index(name, function);
  return "";
}
std::string why_no_index(const std::string& name, const Signature& s) {
  for (const auto& [other, t] : functions()) {
    if ((s.indexed() || t.indexed()) && stem(other) == stem(name))
      return name + " at an index prints as " + other;
    if (s.indexed() && reads_as_index(other, name)) return read_as_index(other, name);
  }
  for (const auto& [variable, sort] : variables())
    if (s.indexed() && reads_as_index(variable, name)) return read_as_index(variable, name);
  return "";
}
}  // namespace

bool Signature::indexed() const { return std::ranges::count(args, Sort::Int) > 0; }
std::string Signature::separator(std::size_t i) const {
  if (!body || result != Sort::Bool || i == 0) return ", ";
  const auto letter = [](Expr v) { return v.name().substr(0, v.name().find('_') + 1); };
  return letter(variables[i - 1]) == letter(variables[i]) ? ", " : "; ";
}
std::string stem(const std::string& name) { return name.ends_with('_') ? name : name + "_"; }

const Signature* signature(const std::string& name) {
  const auto it = functions().find(name);
  return it == functions().end() ? nullptr : &it->second;
}
bool is_known(const std::string& name) {
  return functions().count(name) != 0 || variables().count(name) != 0;
}
Expr known_variable(const std::string& name) {
  const auto it = variables().find(name);
  if (it == variables().end()) return {};
  return make({.op = Op::Var, .name = name, .variable = it->second});
}
void declare(const std::string& name, const Signature& s) {
  if (functions().count(name)) refuse(name + " is defined already");
  if (variables().count(name)) refuse(name + " is a variable already");
  const bool matrix = s.result == Sort::Matrix;
  if (matrix != (s.rows > 0 && s.cols > 0) || s.rows > 8 || s.cols > 8 ||
      s.params.size() > s.args.size())
    refuse("a signature that does not fit together for " + name);
  for (Sort sort : s.args)
    if (sort != Sort::Real && sort != Sort::Int) refuse(name + ": an argument must be a number");
  for (const std::string& why : {why_no_name(name), why_no_index(name, s)})
    if (!why.empty()) refuse(why);
  functions().emplace(name, s);
}
std::string why_no_variable(const std::string& name, Sort sort) {
  if (functions().count(name)) return name + " is the name of a function or constant: no variable";
  if (const auto it = variables().find(name); it != variables().end())
    return it->second == sort ? "" : name + " is a variable of another sort";
  if (sort != Sort::Real && sort != Sort::Int) return name + ": a variable is real or integer";
  for (const auto& [function, s] : functions())
    if (sort == Sort::Int && s.indexed() && is_known(stem(function) + name))
      return read_as_index(stem(function) + name, function);
  return why_no_name(name);
}
void declare_variable(const std::string& name, Sort sort) {
  if (const std::string why = why_no_variable(name, sort); !why.empty()) refuse(why);
  variables().emplace(name, sort);
}
}  // namespace kernel
