// SPDX-License-Identifier: GPL-2.0-or-later
// At alpha = alpha_k B takes everything (magic); at alpha = beta_k B and the ball go on together
// (deficient).
#include <optional>

#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr half() { return psi() / 2; }

/// |- psi/2 = pi/d under alpha = threshold, with 0 < pi/d and pi/d < pi/2.
Theorem angle_at(Book& book, const std::string& name, Expr d) {
  const Theorem is = assume(eq(alpha, fun(name, {k})));
  const Theorem k_from_1 = assume(le(1, k));
  const AngleRange range = range_of(d, linear(lt(2, d), {k_from_1}));
  const Theorem solved = chain(is, book["ratios." + name + "k"]);
  const Theorem cosines = cut(solved, at_angle(book["ratios.ratio"], d, range));
  const Theorem psi_from = part(book["rotation.psi_range"], 0);
  const Theorem psi_to = part(book["rotation.psi_range"], 1);
  return same_angle(cosines, linear(lt(0, half()), {psi_from}),
                    linear(lt(half(), pi()), {psi_from, psi_to}), range.positive,
                    linear(lt(pi() / d, pi()), {range.below_edge, positive(pi())}));
}

/// What both kinds of ratio share: the angle, the quotient pi/psi, the counts, velocities at the
/// angles left over.
class AtThreshold {
public:
  AtThreshold(Book& the_book, const std::string& ratio, Expr denominator)
      : book(the_book), name(ratio), d(denominator) {}

  void show_angle() {
    const Theorem angle = book.show("angle", "", "Half of psi is then", angle_at(book, name, d));
    const Theorem d_positive = linear(lt(0, d), {assume(le(1, k))});
    turn = equation(d * psi(), 2 * pi(), {linear(eq(psi(), 2 * pi() / d), {angle})}, {d_positive});
    Certificate per;
    per.multipliers = {psi_positive()};
    per.nonzero = {psi_positive()};
    per.equations = {{rational(1, 2), *turn}};
    quotient = arithmetic(eq(d / 2, pi() / psi()), per);
  }
  Theorem psi_positive() const { return part(book["rotation.psi_range"], 0); }
  /// |- N = count, from N = ceil(pi/psi - shift)
  Theorem counted(const std::string& which, Expr shift, Expr count) const {
    const Expr z = pi() / psi() - shift;
    const Theorem is =
        tautology(eq(ceil(z), count),
                  {instantiate(ceiling_is(), {{x, z}, {k, count}}),
                   linear(lt(count - 1, z), {*quotient}), linear(le(z, count), {*quotient})});
    return chain(book["counting." + which], is);
  }
  /// A velocity of the chapter "power" at n = index.
  Theorem velocity(const std::string& id, Expr index, const Theorem& index_from_0) const {
    return use(discharge(le(0, n), book["power." + id]), {{n, index}}, {index_from_0});
  }

  Book& book;
  std::string name;
  Expr d;
  std::optional<Theorem> turn;      // d psi = 2 pi
  std::optional<Theorem> quotient;  // d/2 = pi/psi
};

struct Values {
  Theorems rules, divisors;
};
/// Sines and cosines at pi - y for the y that are left over, and what they divide by.
Values values_at(Book& book) {
  const Expr q = psi() / 4;
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass});
  const Theorem cos_half = book["rotation.cos_half_psi"];
  Theorems rules{book["power.V_CM"], axiom("cos pi"), axiom("sin pi"), cos_half};
  for (const Expr& angle : {half(), q, psi()})
    for (const char* axiom_name : {"cos minus", "sin minus"})
      rules.push_back(use(axiom_name, {{x, angle}}));
  for (const Expr& angle : {half(), q, psi()})
    for (const char* axiom_name : {"cos sum", "sin sum"})
      rules.push_back(use(axiom_name, {{x, pi()}, {y, -angle}}));
  return {rules,
          {part(book["rotation.half_signs"], 1), part(book["power.quarter"], 0), p1,
           positive(2 + alpha, {mass})}};
}

void magic(Book& book) {
  book.chapter("magic", "Magic mass ratios",
               {alpha_positive, V_positive, le(1, k), eq(alpha, fun("alpha_", {k}))});
  AtThreshold at(book, "alpha_", 2 * k + 1);
  at.show_angle();
  const Theorem k_from_0 = linear(le(0, k), {assume(le(1, k))});
  const Theorem N_A_is = at.counted("N_A", rational(1, 2), k);
  const Theorem N_B_is = at.counted("N_B", 1, k);
  book.show("counts", "eq:Naatcritical", "Each block has had k collisions,",
            both({N_A_is, N_B_is, linear(eq(k, pi() / psi() - rational(1, 2)), {*at.quotient})}));
  const Values values = values_at(book);
  const auto value = [&](Expr left, Expr right, const std::string& id, Expr angle, Expr rest) {
    const Theorem left_over = linear(eq(angle, pi() - rest), {*at.turn});
    const Theorem velocity = rewrite(left_over, at.velocity(id, k, k_from_0));
    return equation(left, right, Theorems{velocity} + values.rules, values.divisors);
  };
  const Theorem a_k = value(a(k), 0, "a", k * psi(), half());
  const Theorem b_k = [&] {
    const Theorem whole = linear(eq((k + rational(1, 2)) * psi(), pi()), {*at.turn});
    const Theorem velocity = rewrite(whole, at.velocity("b", k, k_from_0));
    return equation(b(k), V, Theorems{velocity} + values.rules, values.divisors);
  }();
  const Theorem c_k = value(c_prime(k), 0, "c_prime", (k + rational(1, 4)) * psi(), psi() / 4);
  book.show("velocities", "",
            "after which A and C are at rest and B has what A had:", both({a_k, b_k, c_k}));
  book.show("terminal", "", "These are the terminal velocities:",
            both({rewrite(turned(N_A_is), a_k), rewrite(turned(N_B_is), b_k),
                  rewrite(turned(N_B_is), c_k)}));
}

void deficient(Book& book) {
  book.chapter("deficient", "Deficient mass ratios",
               {alpha_positive, V_positive, le(1, k), eq(alpha, fun("beta_", {k}))});
  AtThreshold at(book, "beta_", 2 * k + 2);
  at.show_angle();
  const Theorem k_from_1 = assume(le(1, k));
  const Theorem k_from_0 = linear(le(0, k), {k_from_1});
  const Theorem next_from_0 = linear(le(0, k + 1), {k_from_1});
  const Theorem N_A_is = at.counted("N_A", rational(1, 2), k + 1);
  const Theorem N_B_is = at.counted("N_B", 1, k);
  book.show("counts", "eq:Nbatcritical", "A has had one collision more than B,",
            both({N_A_is, N_B_is, linear(eq(k, pi() / psi() - 1), {*at.quotient})}));
  const Values values = values_at(book);
  const auto value = [&](Expr left, Expr right, const Theorem& velocity) {
    return equation(left, right, Theorems{velocity} + values.rules, values.divisors);
  };
  const Theorem whole = linear(eq((k + 1) * psi(), pi()), {*at.turn});
  const Theorem a_k = value(a(k + 1), -alpha * V / (2 + alpha),
                            rewrite(whole, at.velocity("a", k + 1, next_from_0)));
  const auto rest = [&](Expr angle, Expr left_over) {
    return linear(eq(angle, pi() - left_over), {*at.turn});
  };
  const Theorem b_k =
      value(b(k), 2 * V / (2 + alpha),
            rewrite(rest((k + rational(1, 2)) * psi(), half()), at.velocity("b", k, k_from_0)));
  const Expr at_c = (k + 1 - rational(1, 4)) * psi();
  const Theorem c_next = at.velocity("c", k + 1, next_from_0);
  const Theorem c_k = value(c(k + 1), 2 * V / (2 + alpha), rewrite(rest(at_c, psi() / 4), c_next));
  book.show("velocities", "eq:defb-terminal",
            "after which B and C go on together:", both({a_k, b_k, c_k}));
  book.show("terminal", "", "These are the terminal velocities:",
            both({rewrite(turned(N_A_is), a_k), rewrite(turned(N_B_is), b_k),
                  rewrite(turned(N_A_is), c_k)}));
}
}  // namespace

void ratios(Book& book) {
  magic(book);
  deficient(book);
}
}  // namespace derivation
