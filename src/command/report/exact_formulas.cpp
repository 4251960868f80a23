// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/report/exact_formulas.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <cln/cln.h>
#include <ginac/ginac.h>

#include "magicmass/reference/rational.hpp"
#include "proof/names.hpp"
#include "report/exact_value.hpp"
#include "report/quantities.hpp"

namespace magicmass::command {
namespace {

using report::ExactValue;
using report::Input;

constexpr long first_digits = 100;
constexpr long last_digits = 3200;
constexpr long certain_bits = 160;
constexpr int step = 85;  // of relative changes: 2^-step

/// GiNaC's precision, put back at the end.
class Precision {
public:
  explicit Precision(long digits) : before_(GiNaC::Digits) { GiNaC::Digits = digits; }
  Precision(const Precision&) = delete;
  Precision(Precision&&) = delete;
  Precision& operator=(const Precision&) = delete;
  Precision& operator=(Precision&&) = delete;
  ~Precision() { GiNaC::Digits = before_; }

private:
  long before_;
};

/// What a relative change of alpha or of e makes of an input.
struct Change {
  cln::cl_RA alpha = 1, e = 1;
};

std::optional<cln::cl_RA> value(const GiNaC::ex& formula, const codegen::Form& form,
                                const Input& input, const Change& change, long digits) {
  const Precision precision(digits);
  const cln::float_format_t format = cln::float_format(static_cast<unsigned long>(digits));
  const auto real = [&](double x, const cln::cl_RA& factor) {
    return GiNaC::numeric(cln::cl_float(reference::exact(x) * factor, format));
  };
  try {
    GiNaC::lst values;
    for (const std::string& name : inputs_of(form))
      values.append(proof::symbol(name) == (name == "alpha" ? real(input.alpha, change.alpha)
                                            : name == "e"
                                                ? real(input.e, change.e)
                                                : GiNaC::numeric(static_cast<long>(input.index))));
    const GiNaC::ex got = formula.subs(values).evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(got)) return std::nullopt;
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(got);
    if (!number.is_real()) return std::nullopt;
    return cln::rational(cln::the<cln::cl_R>(number.to_cl_N()));
  } catch (const std::exception&) {  // a division by zero
    return std::nullopt;
  }
}

/// |y'/y| for a relative change of what `change` changes.
double condition(const GiNaC::ex& formula, const codegen::Form& form, const Input& input,
                 const Change& change, const cln::cl_RA& y, long digits) {
  const auto moved = value(formula, form, input, change, digits);
  if (!moved) return 0;
  return std::fabs(std::ldexp(cln::double_approx((*moved - y) / y), step));
}

/// To certain_bits less a few: without the last digits of floats, which depend on the order of GiNaC's terms, too.
cln::cl_RA without_noise(const cln::cl_RA& y) {
  const auto length = [](const cln::cl_I& x) { return static_cast<long>(cln::integer_length(x)); };
  const long shift = certain_bits - 10 - length(cln::numerator(y)) + length(cln::denominator(y));
  const cln::cl_RA unit = cln::expt(cln::cl_RA(2), cln::cl_I(-shift));
  return cln::round1(y / unit) * unit;
}

/// Nothing where more digits do not help. That goes for 0, too: whether floats cancel to it depends on that order.
ExactValue certain(const GiNaC::ex& formula, const codegen::Form& form, const Input& input) {
  ExactValue none;
  none.exists = false;
  std::optional<cln::cl_RA> before = value(formula, form, input, {}, first_digits);
  for (long digits = 2 * first_digits; before && digits <= last_digits; digits *= 2) {
    const std::optional<cln::cl_RA> y = value(formula, form, input, {}, digits);
    if (!y || cln::zerop(*y)) return none;
    const cln::cl_RA width = cln::abs(*y) / cln::cl_RA(cln::ash(cln::cl_I(1), certain_bits));
    if (cln::abs(*y - *before) <= width && report::rounding_is_certain(*y, certain_bits)) {
      ExactValue exact = report::exact_value(without_noise(*y));
      const cln::cl_RA factor = 1 + cln::cl_RA(1) / cln::cl_RA(cln::ash(cln::cl_I(1), step));
      if (!form.real_input.empty())
        exact.condition = condition(formula, form, input, {factor, 1}, *y, digits);
      if (report::quantity_named(form.quantity).takes("e"))
        exact.condition += condition(formula, form, input, {1, factor}, *y, digits);
      return exact;
    }
    before = y;
  }
  return none;
}

}  // namespace

std::vector<std::string> unknown_quantities(const std::vector<DerivedForm>& forms) {
  std::vector<std::string> names;
  for (const DerivedForm& one : forms)
    if (!report::quantity_named(one.form.quantity).is_known &&
        std::find(names.begin(), names.end(), one.form.quantity) == names.end())
      names.push_back(one.form.quantity);
  return names;
}

void teach(report::Oracle& oracle, const std::vector<DerivedForm>& forms) {
  for (const DerivedForm& one : forms)
    if (!report::quantity_named(one.form.quantity).is_known)
      oracle.learn(one.form.quantity, one.form.name,
                   [form = one.form, outputs = one.outputs](const Input& input) {
                     std::vector<ExactValue> members;
                     for (const GiNaC::ex& formula : *outputs)
                       members.push_back(certain(formula, form, input));
                     return members;
                   });
}

double input_named(const std::string& name, const Input& input) {
  return name == "alpha" ? input.alpha : name == "e" ? input.e : static_cast<double>(input.index);
}

}  // namespace magicmass::command
