// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/families.hpp"
#include "proof/finite_sums.hpp"
#include "proof/generators.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

ex NormalForm::Generators::translate(const ex& e) {
  if (const auto known = translated_.find(e); known != translated_.end()) return known->second;
  const ex written_out = definitions_.expand_except_angles(e);
  const auto before = denominators_;
  collect_angles(written_out);
  if (denominators_ != before) {  // angles are divided further than before
    translated_.clear();
    rewritten_.clear();
    multiples_.clear();
    pairs_of_angles_.clear();
  }
  return translated_[e] = rewritten(written_out);
}

// A transcendental generator that stands for `original`; one a key.
ex NormalForm::Generators::opaque(const std::string& key, const ex& original, bool is_positive) {
  const auto found = by_key_.find(key);
  if (found != by_key_.end()) return found->second;
  ex generator = GiNaC::realsymbol(key);
  by_key_.emplace(key, generator);
  originals_[generator] = original;
  if (is_positive) positive_generators_.insert(generator);
  return generator;
}

ex NormalForm::Generators::rewritten(const ex& e) {
  if (const auto known = rewritten_.find(e); known != rewritten_.end()) return known->second;
  ex result = rewritten_anew(e);
  if (is_a<GiNaC::power>(e) || is_a<GiNaC::function>(e)) rewritten_[e] = result;
  return result;
}

ex NormalForm::Generators::rewritten_anew(const ex& e) {
  if (is_a<numeric>(e)) {
    if (!ex_to<numeric>(e).is_rational()) throw NotInClass("not a rational number: " + to_text(e));
    return e;
  }
  if (is_a<GiNaC::symbol>(e)) {
    const ex* meaning = definitions_.angle(ex_to<GiNaC::symbol>(e).get_name());
    if (meaning == nullptr) return e;
    return opaque(to_text(e), e, positive(rewritten(*meaning)));
  }
  if (e.is_equal(GiNaC::Pi)) return opaque("pi", GiNaC::Pi, true);
  if (is_a<GiNaC::add>(e)) {
    ex sum = 0;
    for (const ex& term : e) sum += rewritten(term);
    return sum;
  }
  if (is_a<GiNaC::mul>(e)) {
    ex product = 1;
    for (const ex& part : e) product *= rewritten(part);
    return product;
  }
  if (is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1))) {
    const numeric exponent = ex_to<numeric>(e.op(1));
    if (!exponent.is_rational() || exponent.denom() > 2)
      throw NotInClass("only whole and half powers are handled: " + to_text(e));
    if (GiNaC::abs(exponent) > largest_exponent)
      throw NotInClass("too large an exponent: " + to_text(e));
    ex base = rewritten(e.op(0));
    if (exponent.is_negative()) require_nonzero(base, e.op(0));
    if (exponent.is_integer()) return GiNaC::power(base, exponent);
    return GiNaC::power(square_root(base), 2 * exponent);
  }
  if (is_a<GiNaC::power>(e)) return symbolic_power(e.op(0), e.op(1));
  if (is_a<GiNaC::function>(e)) {
    const std::string name = ex_to<GiNaC::function>(e).get_name();
    if (name == "cos") return cosine_and_sine(e.op(0)).cosine;
    if (name == "sin") return cosine_and_sine(e.op(0)).sine;
    if (name == "tan") {
      const Pair pair = cosine_and_sine(e.op(0));
      require_nonzero(pair.cosine, cos(e.op(0)));
      return pair.sine / pair.cosine;
    }
    if (name == "atan") {
      const ex argument = rewritten(e.op(0));
      const auto [above, below] = quotient(argument);
      return opaque("atan(" + to_text(above / below) + ")", e, positive(argument));
    }
    if (is_finite_sum(e)) return opaque_sum(e);

    if (is_step_function(e)) {  // equal arguments, equal values
      const auto [above, below] = quotient(rewritten(e.op(0)));
      return opaque(function_name(e) + "(" + to_text(above / below) + ")", e, false);
    }
    if (is_family(e)) {
      std::string key = function_name(e);  // arguments in one form, or one element is taken for two
      for (const ex& argument : e) {
        const auto [above, below] = quotient(rewritten(argument));
        key += ";" + to_text(above.expand()) + "/" + to_text(below.expand());
      }
      return opaque(key, e, false);
    }
    if (is_sequence(e)) {
      const ex index = e.op(0).expand();
      return opaque(function_name(e) + "(" + to_text(index) + ")", e, false);
    }
  }
  throw NotInClass("no normal form for " + to_text(e));
}

// A sum stands for itself; its bases and what stands in front of it must be defined.
ex NormalForm::Generators::opaque_sum(const ex& sum) {
  const auto shape = finite_sum_of(sum);
  if (!shape) throw NotInClass("not a sum that the kernel understands: " + to_text(sum));
  rewritten(shape->x);
  rewritten(shape->y);
  const auto visit = [this](const auto& self, const ex& part) -> void {
    if (is_a<GiNaC::function>(part) && ex_to<GiNaC::function>(part).get_name() == "factorial") {
      const ex argument = part.op(0);
      for (const auto& [name, from] : domain_.integer) {
        const ex surplus = (argument - symbol(name)).expand();
        if (!is_a<numeric>(surplus) || !ex_to<numeric>(surplus).is_integer()) continue;
        if (ex_to<numeric>(surplus) + from >= 0) {
          conditions.insert(index_condition(name, from));
          return;
        }
      }
      throw NotInClass("not seen to be the factorial of an integer >= 0: " + to_text(part));
    }
    if (is_a<GiNaC::mul>(part)) {
      for (const ex& factor : part) self(self, factor);
    } else {
      rewritten(part);
    }
  };
  visit(visit, shape->front);
  return opaque(to_text(sum), sum, false);
}

}  // namespace magicmass::proof
