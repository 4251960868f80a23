// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/lower.hpp"

#include <algorithm>
#include <stdexcept>

#include <ginac/ginac.h>

#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::codegen {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

std::int64_t whole(const numeric& value) {
  if (!value.is_integer() || GiNaC::abs(value) > 1000000)
    throw std::logic_error("constant out of range");
  return value.to_long();
}

class Lowering {
public:
  explicit Lowering(const Source& source) : source_(source) {}

  Program run() {
    for (const auto& [name, theorem] : source_.outputs) {
      const ex& side = source_.left_sides ? theorem.lhs() : theorem.rhs();
      if (!is_a<GiNaC::matrix>(side)) {
        program_.outputs.push_back({name, lowered(side), theorem.id()});
        continue;
      }
      const auto& matrix = ex_to<GiNaC::matrix>(side);
      for (unsigned row = 0; row < matrix.rows(); ++row)
        for (unsigned column = 0; column < matrix.cols(); ++column)
          program_.outputs.push_back(
              {name + "_" + std::to_string(row + 1) + std::to_string(column + 1),
               lowered(matrix(row, column)), theorem.id()});
    }
    return std::move(program_);
  }

private:
  int lowered(const ex& e) {
    if (is_a<numeric>(e)) return constant(ex_to<numeric>(e));
    if (e.is_equal(GiNaC::Pi)) return append(program_, {.op = Op::pi});
    if (is_a<GiNaC::symbol>(e)) return symbol(e);
    if (is_a<GiNaC::add>(e)) return sum(e);
    if (is_a<GiNaC::mul>(e)) return product(e);
    if (is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1))) return turned_power(e);
    if (is_a<GiNaC::power>(e))
      return append(program_,
                    {.op = Op::indexed_power, .args = {lowered(e.op(0)), lowered(e.op(1))}});
    if (is_a<GiNaC::function>(e)) return function(e);
    throw std::logic_error("no operation for " + proof::to_text(e));
  }

  int constant(const numeric& value) {
    if (!value.is_rational()) throw std::logic_error("constant that is not rational");
    if (value.is_negative())
      return append(program_, {.op = Op::negate, .args = {constant(-value)}});
    return append(program_, {.op = Op::constant,
                             .numerator = whole(value.numer()),
                             .denominator = whole(value.denom())});
  }

  bool is_unit(const ex& e) const {
    return is_a<GiNaC::symbol>(e) &&
           std::find(source_.units.begin(), source_.units.end(),
                     ex_to<GiNaC::symbol>(e).get_name()) != source_.units.end();
  }

  const proof::Theorem* binding(const ex& e) const {
    for (const proof::Theorem& theorem : source_.bindings)
      if (theorem.lhs().is_equal(e)) return &theorem;
    return nullptr;
  }

  int bound(const proof::Theorem& theorem) {
    const int node = lowered(theorem.rhs());
    Node& made = program_.nodes[static_cast<std::size_t>(node)];
    made.name = proof::to_text(theorem.lhs());
    made.origin = theorem.id();
    return node;
  }

  int symbol(const ex& e) {
    const std::string name = ex_to<GiNaC::symbol>(e).get_name();
    if (const proof::Theorem* theorem = binding(e)) return bound(*theorem);
    if (is_unit(e)) return constant(1);
    if (std::find(source_.real_inputs.begin(), source_.real_inputs.end(), name) !=
        source_.real_inputs.end())
      return append(program_, {.op = Op::input, .name = name});
    if (name == source_.index) return append(program_, {.op = Op::index, .name = name});
    throw std::logic_error("nothing says what " + name + " is");
  }

  int sum(const ex& e) {
    Node node{.op = Op::add};
    for (const ex& term : e) node.args.push_back(lowered(term));
    return append(program_, node);
  }

  // A sum that leads with a minus is turned round, so that the program does not depend on GiNaC's hashes.
  int turned_power(const ex& e) {
    const ex& base = e.op(0);
    const numeric exponent = ex_to<numeric>(e.op(1));
    if (!exponent.is_integer() || !is_a<GiNaC::add>(base) || !proof::leads_with_minus(base))
      return power(base, exponent);
    const int magnitude = power(-base, exponent);
    return exponent.is_odd() ? append(program_, {.op = Op::negate, .args = {magnitude}})
                             : magnitude;
  }

  bool is_sign(const ex& e) const {
    return is_a<GiNaC::symbol>(e) && ex_to<GiNaC::symbol>(e).get_name() == source_.sign;
  }

  // The same of a factor.
  int product(const ex& e) {
    for (const ex& part : e)
      if (is_sign(part))
        return append(program_, {.op = Op::magnitude, .args = {lowered((e / part).expand())}});
    Node node{.op = Op::multiply};
    bool negative = false;
    for (const ex& part : e) {
      if (is_a<numeric>(part)) {
        const numeric value = ex_to<numeric>(part);
        negative = negative != value.is_negative();
        if (!GiNaC::abs(value).is_equal(1)) node.args.push_back(constant(GiNaC::abs(value)));
        continue;
      }
      const bool is_power = is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::integer);
      const ex base = is_power ? part.op(0) : part;
      if (is_a<GiNaC::add>(base) && proof::leads_with_minus(base)) {
        const numeric exponent = is_power ? ex_to<numeric>(part.op(1)) : numeric(1);
        negative = negative != exponent.is_odd();
        node.args.push_back(power(-base, exponent));
      } else {
        node.args.push_back(lowered(part));
      }
    }
    const int magnitude = node.args.size() == 1 ? node.args[0] : append(program_, node);
    return negative ? append(program_, {.op = Op::negate, .args = {magnitude}}) : magnitude;
  }

  int power(const ex& base, const numeric& exponent) {
    if (is_unit(base)) return constant(1);
    if (exponent.is_equal(1)) return lowered(base);
    if (exponent.is_negative())
      return append(program_, {.op = Op::reciprocal, .args = {power(base, -exponent)}});
    return append(program_, {.op = Op::power,
                             .args = {lowered(base)},
                             .numerator = whole(exponent.numer()),
                             .denominator = whole(exponent.denom())});
  }

  int function(const ex& e) {
    if (const proof::Theorem* theorem = binding(e)) return bound(*theorem);
    const std::string name = proof::function_name(e);
    if (name == "T") return cosine_of_multiple(e.op(0));
    const std::map<std::string, Op> known{
        {"sin", Op::sine}, {"cos", Op::cosine}, {"atan", Op::arctangent}};
    const auto found = known.find(name);
    if (found == known.end()) throw std::logic_error("no operation for " + proof::to_text(e));
    return append(program_, {.op = found->second, .args = {lowered(e.op(0))}});
  }

  // T(c n) and T(c n + 1) come from one ladder at c n.
  int cosine_of_multiple(const ex& multiple) {
    const ex index = proof::symbol(source_.index);
    const numeric scale = ex_to<numeric>(multiple.coeff(index, 1));
    const numeric offset = ex_to<numeric>(multiple.coeff(index, 0));
    if (offset != 0 && offset != 1)
      throw std::logic_error("a ladder gives T(m) and T(m + 1), not " + proof::to_text(multiple));
    const proof::Theorem* first = binding(proof::T(1));
    if (first == nullptr) throw std::logic_error("nothing says what T(1) is");
    return append(program_, {.op = offset == 0 ? Op::ladder_low : Op::ladder_high,
                             .args = {bound(*first)},
                             .numerator = whole(scale),
                             .denominator = 0,
                             .name = source_.index});
  }

  const Source& source_;
  Program program_;
};

}  // namespace

Program lower(const Source& source) { return Lowering(source).run(); }

}  // namespace magicmass::codegen
