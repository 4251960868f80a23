// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/notation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace magicmass::render {
namespace {

const std::map<std::string, std::string, std::less<>>& greek() {
  static const std::map<std::string, std::string, std::less<>> letters{
      {"alpha", "α"},  {"beta", "β"},  {"gamma", "γ"},    {"delta", "δ"}, {"epsilon", "ε"},
      {"zeta", "ζ"},   {"eta", "η"},   {"theta", "θ"},    {"iota", "ι"},  {"kappa", "κ"},
      {"lambda", "λ"}, {"mu", "μ"},    {"nu", "ν"},       {"xi", "ξ"},    {"pi", "π"},
      {"rho", "ρ"},    {"sigma", "σ"}, {"tau", "τ"},      {"phi", "φ"},   {"chi", "χ"},
      {"psi", "ψ"},    {"omega", "ω"}, {"Gamma", "Γ"},    {"Delta", "Δ"}, {"Theta", "Θ"},
      {"Lambda", "Λ"}, {"Xi", "Ξ"},    {"Pi", "Π"},       {"Sigma", "Σ"}, {"Phi", "Φ"},
      {"Psi", "Ψ"},    {"Omega", "Ω"}, {"infinity", "∞"}, {"ell", "ℓ"}};
  return letters;
}

using Pair = std::pair<std::string_view, std::string_view>;

/// The kernel's name, and how it is printed.
constexpr std::array<Pair, 26> upright{
    {{"cos", "cos"},           {"sin", "sin"},      {"tan", "tan"},      {"cot", "cot"},
     {"sec", "sec"},           {"csc", "csc"},      {"cosh", "cosh"},    {"sinh", "sinh"},
     {"tanh", "tanh"},         {"acos", "arccos"},  {"asin", "arcsin"},  {"atan", "arctan"},
     {"acosh", "arcosh"},      {"asinh", "arsinh"}, {"atanh", "artanh"}, {"log", "ln"},
     {"exp", "exp"},           {"det", "det"},      {"tr", "tr"},        {"diag", "diag"},
     {"max", "max"},           {"min", "min"},      {"gcd", "gcd"},      {"sign", "sgn"},
     {"sawtooth", "sawtooth"}, {"lim", "lim"}}};

/// Applied to an argument, but printed in a way of their own.
constexpr std::array<std::string_view, 8> shaped{"sqrt",      "abs",      "ceil", "floor",
                                                 "factorial", "binomial", "sum",  "O"};

constexpr std::array<Pair, 7> unicode_signs{
    {{"=", "="}, {"!=", "≠"}, {"<=", "≤"}, {">=", "≥"}, {"<", "<"}, {">", ">"}, {"~", "∼"}}};
constexpr std::array<Pair, 7> latex_signs{{{"=", "="},
                                           {"!=", "\\neq"},
                                           {"<=", "\\le"},
                                           {">=", "\\ge"},
                                           {"<", "<"},
                                           {">", ">"},
                                           {"~", "\\sim"}}};

template <std::size_t size>
std::string_view found(const std::array<Pair, size>& pairs, std::string_view name) {
  const auto pair = std::find_if(pairs.begin(), pairs.end(),
                                 [&](const Pair& each) { return each.first == name; });
  return pair == pairs.end() ? std::string_view() : pair->second;
}

}  // namespace

Symbol symbol_of(std::string_view name) {
  Symbol symbol;
  while (name.ends_with('\'')) {
    name.remove_suffix(1);
    ++symbol.primes;
  }
  const std::size_t underscore = name.find('_');
  symbol.base = name.substr(0, underscore);
  while (symbol.base.ends_with('\'')) {  // e'_3
    symbol.base.pop_back();
    ++symbol.primes;
  }
  if (underscore != std::string_view::npos) symbol.subscript = name.substr(underscore + 1);
  if (symbol.subscript == "prime") {
    symbol.subscript.clear();
    ++symbol.primes;
  }
  return symbol;
}

bool looks_like_symbol(std::string_view name) {
  const Symbol symbol = symbol_of(name);
  return symbol.base.size() == 1 || greek().contains(symbol.base) ||
         !upright_function(name).empty();
}

bool is_function_name(std::string_view name) {
  const std::string base = symbol_of(name).base;
  return !upright_function(name).empty() || base == "lambda" || base == "Gamma" ||
         base == "Lambda" || std::find(shaped.begin(), shaped.end(), name) != shaped.end();
}

std::string upright_function(std::string_view name) { return std::string(found(upright, name)); }

std::string unicode_letter(std::string_view name) {
  const auto letter = greek().find(name);
  return letter == greek().end() ? std::string(name) : letter->second;
}

std::string latex_letter(std::string_view name) {
  if (name == "infinity") return "\\infty";
  if (name == "epsilon") return "\\varepsilon";
  if (greek().contains(name)) return "\\" + std::string(name);
  return name.size() == 1 ? std::string(name) : "\\mathrm{" + std::string(name) + "}";
}

std::string unicode_sign(std::string_view sign) {
  const std::string_view shown = found(unicode_signs, sign);
  return std::string(shown.empty() ? sign : shown);
}

std::string latex_sign(std::string_view sign) {
  const std::string_view shown = found(latex_signs, sign);
  return std::string(shown.empty() ? sign : shown);
}

}  // namespace magicmass::render
