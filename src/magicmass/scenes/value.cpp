
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/plain/closed.hpp"
#include "magicmass/scenes/scene.hpp"
#include "notation/typed.hpp"

namespace magicmass::scenes {
namespace {

using kernel::Expr, kernel::Op;

constexpr std::size_t longest_text = 4096;
constexpr std::size_t most_bits = 1U << 17U;

/// All ratios of the paper that are surds.
constexpr std::pair<const char*, const char*> surd_ratios[]{{"magic:1", "1"},
                                                            {"magic:2", "sqrt(5)-2"},
                                                            {"deficient:1", "sqrt(2)-1"},
                                                            {"deficient:2", "2/sqrt(3)-1"},
                                                            {"deficient:5", "sqrt(6)-sqrt(2)-1"}};

[[noreturn]] void refuse(const std::string& why) { throw InvalidInput(why); }

Surd checked(Surd x) {
  if (x.bits() > most_bits) refuse("a number of more than " + std::to_string(most_bits) + " bits");
  return x;
}

/// The value of a term without variables. Throws std::domain_error, too.
Surd evaluate(Expr e) {
  switch (e.op()) {
    case Op::Num:
      return e.value();
    case Op::Add:
    case Op::Mul: {
      Surd result = evaluate(e.arg(0));
      for (std::size_t i = 1; i < e.size(); ++i) {
        const Surd next = evaluate(e.arg(i));
        result = checked(e.op() == Op::Add ? result + next : result * next);
      }
      return result;
    }
    case Op::Pow: {
      const Surd base = evaluate(e.arg(0));
      if (base.bits() * static_cast<std::size_t>(e.exponent()) > 2 * most_bits)
        refuse("a power of more than " + std::to_string(most_bits) + " bits");
      Surd result = 1;
      for (int k = 0; k < e.exponent(); ++k) result = result * base;
      return result;
    }
    case Op::Fun:
      if (e.name() == "inv") return Surd(1) / evaluate(e.arg(0));
      if (e.name() == "sqrt") return Surd::sqrt(evaluate(e.arg(0)));
      [[fallthrough]];
    default:
      refuse("only whole numbers, + - * / ^ and square roots of whole numbers have a value here");
  }
}

std::string ratio_of(const Value& x) { return x.ratio ? notation::text(*x.ratio) : ""; }

}  // namespace

double Value::to_double() const {
  if (ratio && number == 0) {
    const auto both = accurate::ratios(cln::cl_I_to_long(ratio->k));
    return sign * (ratio->is_magic ? both.magic : both.deficient);
  }
  const auto nearest = [this] {
    const Ball x = ball_of(*this);
    return nearest_double(x.low(), x.high());
  };
  if (ratio) return with_bits(17, nearest);
  if (const auto value = number.to_double()) return *value;
  throw Undecided((text.empty() ? "a place" : text.substr(0, 60)) +
                  " does not fit a normal double");
}

Ball ball_of(const Value& value) {
  if (!value.ratio) return ball_of(value.number);
  const auto& [is_magic, number] = *value.ratio;
  const std::int64_t k = cln::cl_I_to_long(number);
  if (k > std::int64_t(1) << 50U) throw Undecided(value.text + " is answered here up to k = 2^50");
  const auto [alpha_k, beta_k] = generated::ratios_closed<Ball>(k);
  return ball_of(value.number) + value.sign * (is_magic ? alpha_k : beta_k);
}

/// No ratio that is kept as one is a surd.
bool Value::is_positive() const {
  if (exact()) return Surd(0) < number;
  return with_bits(17, [this] { return ball_of(*this) > 0; });
}

Value negative(const Value& x) {
  return {x.text.empty() ? "" : "-" + x.text, -x.number, x.ratio, -x.sign};
}

std::optional<Value> difference(const Value& x, const Value& y) {
  const Surd rest = x.number - y.number;
  if (!y.ratio) return Value{"", rest, x.ratio, x.sign};
  if (!x.ratio) return Value{"", rest, y.ratio, -y.sign};
  if (ratio_of(x) != ratio_of(y) || x.sign != y.sign) return {};
  return Value{"", rest};
}

std::optional<Surd> quotient(const Value& x, const Value& y) {
  if (x.is(0)) return Surd(0);
  if (x.exact() && y.exact()) return x.number / y.number;
  const Surd turn = x.sign * y.sign;
  const bool is_it = ratio_of(x) == ratio_of(y) && x.number == turn * y.number;
  return is_it ? std::optional(turn) : std::nullopt;
}

Value read_value(std::string_view text) try {
  if (text.size() > longest_text)
    refuse(std::to_string(text.size()) + " characters, at most " + std::to_string(longest_text));
  if (text.starts_with("-magic:") || text.starts_with("-deficient:"))
    return negative(read_value(text.substr(1)));
  if (text.starts_with("magic:") || text.starts_with("deficient:")) {
    Value value = value_of(notation::read_alpha(text));
    if (value.ratio && value.ratio->k > cln::ash(1, 50))
      refuse("k above 2^50, for which there are counts alone: magicmass count");
    return value;
  }
  if (text.find_first_of(".eExX") != text.npos && text.find_first_of("()/*^") == text.npos) {
    const auto value = notation::read_double(text);
    if (!value) refuse("not a number");
    if (std::isinf(*value)) refuse("it does not fit a double, write it as a fraction");
    return {std::string(text), Surd(*value)};
  }
  return {std::string(text), checked(evaluate(notation::read(text)))};
} catch (const std::domain_error& error) {
  refuse(error.what());
} catch (const kernel::Refused& refused) {
  refuse(refused.what());
}

Value value_of(const notation::Alpha& ratio) {
  const std::string text = notation::text(ratio);
  for (const auto& [name, value] : surd_ratios)
    if (text == name) return {text, evaluate(notation::read(value))};
  if (const auto* at = std::get_if<notation::Threshold>(&ratio)) return {text, 0, *at};
  const auto* rational = std::get_if<cln::cl_RA>(&ratio);
  return {text, rational != nullptr ? Surd(*rational) : Surd(std::get<double>(ratio))};
}

Value value_of(double number) {
  if (!std::isfinite(number)) refuse("not a finite number");
  return value_of(notation::Alpha(number));
}

}  // namespace magicmass::scenes
