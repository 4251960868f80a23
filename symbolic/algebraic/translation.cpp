// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/translation.hpp"

#include <sstream>

#include <ginac/ginac.h>

#include "algebraic/constant.hpp"
#include "algebraic/decision.hpp"

namespace magicmass::algebraic {
namespace {

using cln::cl_I;
using cln::cl_RA;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

constexpr long largest_index = 10000;

std::string shown(const ex& e) {
  std::ostringstream stream;
  stream << e;
  const std::string text = stream.str();
  return text.size() <= 200 ? text : text.substr(0, 200) + "...";
}

cl_RA rational_value(const numeric& number) {
  if (!number.is_real()) throw NotAlgebraic("not a real number: " + shown(number));
  if (!number.is_rational())
    throw NotAlgebraic("not an exact number, but a decimal approximation: " + shown(number));
  return cln::the<cl_RA>(number.to_cl_N());
}

class Translation {
public:
  Translation(Terms& terms, const Work& work) : terms_(terms), work_(work) {}

  std::size_t operator()(const ex& e) {
    if (const auto found = known_.find(e); found != known_.end()) return found->second;
    work_.check_time();
    if (++depth_ > work_.budget().depth)
      throw BeyondBudget("more than " + std::to_string(work_.budget().depth) +
                         " levels of nesting");
    const std::size_t term = translated(e);
    --depth_;
    known_.emplace(e, term);
    return term;
  }

private:
  std::size_t translated(const ex& e) {
    if (is_a<numeric>(e)) return terms_.rational(rational_value(ex_to<numeric>(e)));
    if (is_a<GiNaC::add>(e)) return terms_.sum(parts(e));
    if (is_a<GiNaC::mul>(e)) return terms_.product(parts(e));
    if (is_a<GiNaC::power>(e)) return power(e);
    if (is_a<GiNaC::function>(e)) return function(e);
    throw NotAlgebraic("not an algebraic number: " + shown(e));
  }

  std::vector<std::size_t> parts(const ex& e) {
    std::vector<std::size_t> all;
    all.reserve(e.nops());
    for (const ex& part : e) all.push_back((*this)(part));
    return all;
  }

  int sign(std::size_t term) { return decide(terms_, term, work_).sign; }

  std::size_t power(const ex& e) {
    if (!is_a<numeric>(e.op(1)))
      throw NotAlgebraic("a power whose exponent is not a rational number: " + shown(e));
    const cl_RA exponent = rational_value(ex_to<numeric>(e.op(1)));
    std::size_t base = (*this)(e.op(0));
    const cl_I index = cln::denominator(exponent);
    if (cln::minusp(exponent) && sign(base) == 0)
      throw NotAlgebraic("division by zero: " + shown(e));
    if (index > largest_index)
      throw BeyondBudget("a root of an index above " + std::to_string(largest_index));
    if (index > 1) {
      const int radicand = sign(base);
      if (radicand < 0) throw NotAlgebraic("a root of a negative number: " + shown(e));
      base = radicand == 0 ? terms_.rational(0) : terms_.root(base, cln::cl_I_to_long(index));
    }
    return terms_.power(base, cln::numerator(exponent));
  }

  std::size_t function(const ex& e) {
    const std::string name = ex_to<GiNaC::function>(e).get_name();
    if (name == "abs") {
      const std::size_t part = (*this)(e.op(0));
      return sign(part) < 0 ? terms_.product({part, terms_.rational(-1)}) : part;
    }
    if (name != "cos" && name != "sin" && name != "tan")
      throw NotAlgebraic("not a function of the class: " + shown(e));
    const ex ratio = (e.op(0) / GiNaC::Pi).expand();
    if (!is_a<numeric>(ratio) || !ex_to<numeric>(ratio).is_rational())
      throw NotAlgebraic("not an angle that is a rational multiple of Pi: " + shown(e));
    const cl_RA turn = rational_value(ex_to<numeric>(ratio)) / 2;
    const std::size_t cosine = terms_.cosine(turn);
    if (name == "cos") return cosine;
    const std::size_t sine = terms_.cosine(cl_RA(1) / 4 - turn);
    if (name == "sin") return sine;
    if (terms_[cosine].sign == 0) throw NotAlgebraic("a tangent at its pole: " + shown(e));
    return terms_.product({sine, terms_.power(cosine, -1)});
  }

  Terms& terms_;
  const Work& work_;
  long depth_ = 0;
  std::map<ex, std::size_t, GiNaC::ex_is_less> known_;
};

}  // namespace

std::size_t translate(const ex& constant, Terms& terms, const Work& work) {
  return Translation(terms, work)(constant);
}

}  // namespace magicmass::algebraic
