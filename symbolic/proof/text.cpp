// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/text.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <tuple>
#include <vector>

#include <ginac/ginac.h>

#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::proof {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

enum Precedence { sum, product, factor, power };

std::string print(const ex& e, Precedence outer);

std::string number(const numeric& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

bool is_index(const ex& e) {
  static const std::string indices = "jkmn";
  return is_a<GiNaC::symbol>(e) && ex_to<GiNaC::symbol>(e).get_name().size() == 1 &&
         indices.find(ex_to<GiNaC::symbol>(e).get_name()) != std::string::npos;
}

// n + 1/2, 2 k - 1: there the constant comes last.
bool is_sum_of_indices(const ex& sum_of_terms) {
  return std::any_of(sum_of_terms.begin(), sum_of_terms.end(), [](const ex& term) {
    return is_index(term) || (is_a<GiNaC::mul>(term) && term.nops() == 2 &&
                              (is_index(term.op(0)) || is_index(term.op(1))));
  });
}

numeric coefficient(const ex& term) {
  if (is_a<numeric>(term)) return ex_to<numeric>(term);
  if (is_a<GiNaC::mul>(term))
    for (const ex& part : term)
      if (is_a<numeric>(part)) return ex_to<numeric>(part);
  return 1;
}

// Speeds, lengths and constants first, then symbols, then sums, then functions, cosines before sines.
int rank(const ex& e) {
  static const std::vector<std::string> leading{"V_CM", "V", "L"};
  const ex base = is_a<GiNaC::power>(e) ? e.op(0) : e;
  if (is_a<numeric>(base)) return 0;
  if (is_a<GiNaC::symbol>(base)) {
    const std::string name = ex_to<GiNaC::symbol>(base).get_name();
    const auto found = std::find(leading.begin(), leading.end(), name);
    return found != leading.end() ? static_cast<int>(1 + (found - leading.begin())) : 5;
  }
  if (is_a<GiNaC::constant>(base)) return 4;
  if (is_a<GiNaC::add>(base)) return 6;
  return is_a<GiNaC::function>(base) ? 7 : 8;
}

std::string parenthesised(bool needed, const std::string& inside) {
  return needed ? "(" + inside + ")" : inside;
}

std::string print_sum(const ex& e, Precedence outer) {
  struct Term {
    bool constant_last;
    bool negative;
    int rank;
    std::string shown;
  };
  const bool of_indices = is_sum_of_indices(e);
  std::vector<Term> terms;
  for (const ex& term : e) {
    const bool constant = is_a<numeric>(term);
    std::string shown = print(term, sum);
    const bool negative = shown.front() == '-';
    if (negative) shown.erase(0, 1);
    terms.push_back({constant && of_indices, negative, constant ? -1 : rank(term), shown});
  }
  std::sort(terms.begin(), terms.end(), [](const Term& x, const Term& y) {
    return std::tie(x.constant_last, x.negative, x.rank, x.shown) <
           std::tie(y.constant_last, y.negative, y.rank, y.shown);
  });
  std::string result;
  for (const Term& term : terms) {
    if (result.empty())
      result = (term.negative ? "-" : "") + term.shown;
    else
      result += (term.negative ? " - " : " + ") + term.shown;
  }
  return parenthesised(outer > sum, result);
}

std::string join(std::vector<std::pair<int, std::string>> factors) {
  std::sort(factors.begin(), factors.end());
  std::string result;
  for (const auto& [rank, shown] : factors) result += (result.empty() ? "" : "*") + shown;
  return result;
}

struct Power {
  ex base;
  numeric exponent;
};

Power as_power(const ex& e) {
  const bool numeric_exponent = is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1));
  return numeric_exponent ? Power{e.op(0), ex_to<numeric>(e.op(1))} : Power{e, 1};
}

// x - y where GiNaC holds -(y - x): turns a sum that leads with a minus round, as far as its power allows.
void settle_sign(Power& power, bool& negative) {
  if (!is_a<GiNaC::add>(power.base) || !power.exponent.is_integer() ||
      !leads_with_minus(power.base))
    return;
  power.base = -power.base;
  if (power.exponent.is_odd()) negative = !negative;
}

std::string print_power(const ex& base, const numeric& exponent, Precedence outer) {
  if (exponent.is_equal(1)) return print(base, outer);
  if (exponent.is_equal(numeric(1, 2))) return "sqrt(" + print(base, sum) + ")";
  if (exponent.denom().is_equal(2))
    return "sqrt(" + print(base, sum) + ")^" + number(exponent.numer());
  return print(base, power) + "^" + number(exponent);
}

// A product, a quotient or a power with a numeric exponent.
std::string print_product(const std::vector<ex>& parts, Precedence outer) {
  numeric scale = 1;
  bool negative = false;
  std::vector<std::pair<int, std::string>> above;
  std::vector<std::pair<int, std::string>> below;
  for (const ex& part : parts) {
    if (is_a<numeric>(part)) {
      scale = ex_to<numeric>(part);
      continue;
    }
    Power power = as_power(part);
    settle_sign(power, negative);
    const bool inverse = power.exponent.is_negative();
    (inverse ? below : above)
        .emplace_back(rank(part),
                      print_power(power.base, inverse ? -power.exponent : power.exponent, factor));
  }
  if (scale.is_negative()) {
    scale = -scale;
    negative = !negative;
  }
  if (!scale.is_rational()) {
    above.emplace_back(-1, number(scale));
  } else {
    if (!scale.numer().is_equal(1)) above.emplace_back(-1, number(scale.numer()));
    if (!scale.denom().is_equal(1)) below.emplace_back(-1, number(scale.denom()));
  }
  std::string result = above.empty() ? "1" : join(above);
  if (!below.empty()) result += "/" + parenthesised(below.size() > 1, join(below));
  if (negative) result = "-" + result;
  const bool single = above.size() + below.size() == 1 && below.empty() && !negative;
  return parenthesised((outer > product && !single) || (negative && outer > sum), result);
}

std::string print_matrix(const GiNaC::matrix& m) {
  std::string result = "[";
  for (unsigned row = 0; row < m.rows(); ++row) {
    result += row == 0 ? "[" : ", [";
    for (unsigned column = 0; column < m.cols(); ++column)
      result += (column == 0 ? "" : ", ") + print(m(row, column), sum);
    result += "]";
  }
  return result + "]";
}

// v_A(n), or v_A(n; 1/2, 1, e) at other parameters than the general ones.
std::string print_family(const ex& e) {
  std::string arguments = is_sequence(e) ? print(e.op(0), sum) : "";
  if (!families_are_general(e)) {
    std::string separator = arguments.empty() ? "" : "; ";
    for (const ex& argument : arguments_of_family(e)) {
      arguments += separator + print(argument, sum);
      separator = ", ";
    }
  }
  return function_name(e) + (arguments.empty() ? "" : "(" + arguments + ")");
}

std::string print(const ex& e, Precedence outer) {
  if (is_a<numeric>(e)) {
    const numeric value = ex_to<numeric>(e);
    const bool compound = value.is_negative() || !value.is_integer();
    return parenthesised(compound && outer > (value.is_negative() ? sum : product), number(value));
  }
  if (is_a<GiNaC::symbol>(e)) return ex_to<GiNaC::symbol>(e).get_name();
  if (e.is_equal(GiNaC::Pi)) return "pi";
  if (is_a<GiNaC::add>(e)) return print_sum(e, outer);
  if (is_a<GiNaC::mul>(e)) return print_product({e.begin(), e.end()}, outer);
  if (is_a<GiNaC::power>(e)) {
    if (is_a<numeric>(e.op(1))) return print_product({e}, outer);
    return print(e.op(0), power) + "^" + print(e.op(1), power);
  }
  if (is_a<GiNaC::matrix>(e)) return print_matrix(ex_to<GiNaC::matrix>(e));
  if (is_family(e)) return print_family(e);
  if (is_a<GiNaC::function>(e)) {
    std::string arguments;
    for (const ex& argument : e)
      arguments += (arguments.empty() ? "" : ", ") + print(argument, sum);
    return function_name(e) + "(" + arguments + ")";
  }
  std::ostringstream out;  // anything else prints as GiNaC has it
  out << e;
  return out.str();
}

}  // namespace

bool leads_with_minus(const ex& sum_of_terms) {
  const std::string constant_key =
      is_sum_of_indices(sum_of_terms) ? "~" : " ";  // last or first of all
  std::string first;
  bool negative = false;
  for (const ex& term : sum_of_terms) {
    const numeric scale = coefficient(term);
    const std::string key = is_a<numeric>(term) ? constant_key : text(term / scale);
    if (first.empty() || key < first) {
      first = key;
      negative = scale.is_negative();
    }
  }
  return negative;
}

std::string text(const ex& e) { return print(e, sum); }

std::string text(const Statement& statement) {
  static const char* const signs[] = {" = ", " != ", " <= ", " > "};
  return text(statement.lhs()) + signs[static_cast<int>(statement.relation())] +
         text(statement.rhs());
}

bool speaks_of(const std::string& words, const std::string& name) {
  const auto part_of_name = [](char character) {
    return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_';
  };
  for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !part_of_name(words[at - 1])) &&
        (end == words.size() || !part_of_name(words[end])))
      return true;
  }
  return false;
}

}  // namespace magicmass::proof
