// SPDX-License-Identifier: GPL-2.0-or-later
// Lambda^n, and with it the velocities after n cycles, for every n, under alpha > 0 alone.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr from_0 = le(0, n), from_1 = le(1, n);
Expr half() { return psi() / 2; }
Expr quarter() { return psi() / 4; }

void powers_of_lambda(Book& book, const Roots& roots) {
  const Theorem def_turn = book["rotation.lambda_3"];
  const auto turned_by = [&](Expr angle) { return entries(instantiate(def_turn, {{x, angle}})); };
  const Theorems sum_rules = turned_by(x) + turned_by(y) + turned_by(x + y) +
                             angles({cos(x + y), sin(x + y)}, {x, y}, false);
  const Theorem sum =
      book.show("angles_add", "", "Rotations about one axis add their angles:",
                matrix_equation(times(lambda_3(x), lambda_3(y)), lambda_3(x + y), sum_rules));
  // Lambda^n
  const auto turned_frame = [](Expr angle) {
    return times(times(R(), lambda_3(angle)), transpose(R()));
  };
  const Expr claim = eq(power(Lambda(), n), turned_frame(n * psi()));
  const Theorem powers = matrix_power(Lambda(), n);
  const Theorems frame = entries(book["rotation.R"]) + roots.squares;
  const Theorem base = matrix_equation(power(Lambda(), Expr(0)), turned_frame(Expr(0) * psi()),
                                       entries(part(powers, 0)) + turned_by(Expr(0) * psi()) +
                                           Theorems{axiom("cos 0"), axiom("sin 0")} + frame,
                                       roots.divisors);
  const auto one_more = [&](const Theorem& n_from_0, const Theorem& known) {
    const Theorem next =
        tautology(part(powers, 1).conclusion().arg(1), {part(powers, 1), n_from_0});
    const Theorem product = rewrite(known, next);  // Lambda^(n+1) = Lambda (R lambda_3(n psi) R^T)
    const Theorem added = matrix_equation(
        times(Lambda(), turned_frame(n * psi())), turned_frame((n + 1) * psi()),
        entries(book["cycle.Lambda"]) + frame + turned_by(n * psi()) + turned_by((n + 1) * psi()) +
            angles({cos((n + 1) * psi()), sin((n + 1) * psi())}, {n * psi(), psi()}, false) +
            Theorems{book["rotation.cos_psi"], book["rotation.sin_psi"]},
        roots.divisors);
    return rewrite(added, product);
  };
  book.show("Lambda_n", "eq:Lambda-n-final eq:Lambda-n-final-txt",
            "So n cycles turn by n psi:", by_induction(n, claim, base, one_more));

  // V_n = Lambda^n V_0
  const Expr start = column({V, 0, 0});
  const Expr vectors = eq(V_vector(n), times(power(Lambda(), n), start));
  const auto vector_at = [&](Expr i) {
    return entries(instantiate(book["cycle.vector"], {{n, i}}));
  };
  const auto plain = [&](Expr i, const Theorem& i_from_0) {
    Theorems out;
    for (const Theorem& t : vector_at(i)) out.push_back(cut(i_from_0, t));
    return out;
  };
  const Theorem zero_from_0 = linear(le(0, 0), {});
  const Theorem first = matrix_equation(
      V_vector(0), times(power(Lambda(), Expr(0)), start),
      plain(0, zero_from_0) + entries(part(powers, 0)) +
          Theorems{part(book["cycle.start_vector"], 0), part(book["cycle.start_vector"], 1),
                   part(book["cycle.start_vector"], 2)});
  const Theorem recurrence = discharge(from_1, book["cycle.recurrence"]);
  book.show(
      "V_n", "eq:V-n-0 eq:V-n-0-app", "and the velocities are",
      by_induction(n, vectors, first, [&](const Theorem& n_from_0, const Theorem& known) {
        const Theorem next = use(recurrence, {{n, n + 1}}, {linear(le(1, n + 1), {n_from_0})});
        const Theorem simpler = restate(eq(V_vector(n + 1), times(Lambda(), V_vector(n))), next);
        const Theorem up =
            tautology(part(powers, 1).conclusion().arg(1), {part(powers, 1), n_from_0});
        return matrix_equation(V_vector(n + 1), times(power(Lambda(), n + 1), start),
                               entries(simpler) + entries(known) + entries(up));
      }));
}

/// The paper's forms, and products of two sines or cosines, compared with the derived ones.
class Forms {
public:
  Forms(Book& the_book, const Roots& root_rules) : book(the_book), roots(root_rules) {}

  void prepare() {
    const Theorem mass = assume(alpha_positive);
    const Theorem psi_positive = part(book["rotation.psi_range"], 0);
    const Theorem psi_below = part(book["rotation.psi_range"], 1);
    cos_half = {book["rotation.cos_half_psi"]};
    sin_half = {book["rotation.sin_half_psi"]};
    const Theorem sine_q = use("sin positive", {{x, quarter()}},
                               {linear(lt(0, quarter()), {psi_positive}),
                                linear(lt(quarter(), pi()), {psi_below, psi_positive})});
    const Theorem circle = use("circle", {{x, quarter()}});
    const Theorem cos_q2 =
        linear(eq(power(cos(quarter()), 2), (1 + 1 / (1 + alpha)) / 2),
               {angles({cos(half())}, {quarter()}, false)[0], cos_half[0], circle});
    const Expr t = sin_half[0].conclusion().arg(1);
    const Theorem product = linear(eq(cos(quarter()) * sin(quarter()), t / 2),
                                   {angles({sin(half())}, {quarter()}, false)[0], sin_half[0]});
    book.show("quarter", "", "The quarter of psi:", both({sine_q, cos_q2, product}));
    know(sine_q);
    quarter_rules = {cos_q2, product};
    divisors_of_c = {sine_q, roots.divisors[2]};
    const Theorem signs = book["rotation.half_signs"];
    const Theorem above_0 = part(signs, 1);
    divisors = roots.divisors + Theorems{above_0, sine_q, part(signs, 0)};
    const Theorem mean = define("V_CM", {alpha, V}, V / (2 + alpha));
    restrict_domain("V_CM", {alpha, V}, alpha_positive);
    book.show("V_CM", "", "The velocity of the centre of mass:", under({alpha_positive}, mean));
    book.show("V_CM_psi", "", "in terms of psi,",
              cancel(eq(V_CM(), V * cos(half()) / (1 + cos(half()))), {}, Theorems{mean} + cos_half,
                     divisors + Theorems{linear(lt(0, 1 + cos(half())), {above_0})}));
    common = Theorems{mean} + cos_half + roots.squares;
  }
  Theorem proved(Expr l, Expr r, const Theorems& rules, const Exprs& bases,
                 const Theorems& factors = {}) const {
    Exprs terms{l, r};
    for (const Theorem& rule : rules) terms.push_back(rule.conclusion().arg(1));
    return cancel(eq(l, r), factors, angles(terms, bases) + quarter_rules + rules + common,
                  divisors);
  }
  Theorems cos_half, sin_half, quarter_rules, divisors, divisors_of_c, common;

private:
  Book& book;
  const Roots& roots;
};
}  // namespace

void powers(Book& book) {
  book.chapter("power", "The velocities", {alpha_positive, from_0});
  const Roots roots = roots_of(book);
  powers_of_lambda(book, roots);

  // Multiplied out.
  const Expr C = cos(n * psi()), S = sin(n * psi());
  const Expr frame = book["rotation.R"].conclusion().arg(1);
  const Expr turn_3 = instantiate(book["rotation.lambda_3"], {{x, n * psi()}}).conclusion().arg(1);
  const Expr velocities = times(times(times(frame, turn_3), transpose(frame)), column({V, 0, 0}));
  const Theorem rotated = rewrite(book["power.Lambda_n"], book["power.V_n"]);
  Theorems rules;
  for (const Theorem& t : entries(book["cycle.vector"])) rules.push_back(turned(t));
  rules = rules + entries(rotated) + entries(book["rotation.R"]) +
          entries(instantiate(book["rotation.lambda_3"], {{x, n * psi()}})) + roots.squares;
  Theorems derived;
  for (const auto& [name, left, row, divisor] :
       {std::tuple{"a_multiplied", a(n), 0, Expr(1)}, std::tuple{"b_multiplied", b(n), 1, Expr(1)},
        std::tuple{"c_prime_multiplied", c_prime(n), 2, sqrt(alpha)}}) {
    const Expr value = simplified(entry(velocities, row, 0) / divisor, {C, S});
    const bool scaled_by_root = row == 2;
    derived.push_back(
        book.show(name, "",
                  row == 0   ? "Multiplied out, A has"
                  : row == 1 ? "B has"
                             : "and C has",
                  cancel(eq(left, value), scaled_by_root ? Theorems{roots.divisors[2]} : Theorems{},
                         rules, roots.divisors)));
  }
  Forms forms(book, roots);
  forms.prepare();
  const Expr middle = V_CM();
  const Theorem a_n =
      book.show("a", "eq:a-final", "A after its n-th collision, as the paper has it:",
                forms.proved(a(n), middle * (1 + cos(n * psi()) / cos(half())), derived,
                             {n * psi(), half()}));
  const Theorem b_n =
      book.show("b", "eq:b-final", "B after its n-th collision:",
                forms.proved(b(n), middle * (1 - cos((n + rational(1, 2)) * psi()) / cos(half())),
                             derived + forms.sin_half, {n * psi(), half()}));
  const Exprs bases{n * psi(), quarter()};
  const Theorem c_prime_n = book.show(
      "c_prime", "eq:c'-final", "C after its n-th collision with B:",
      forms.proved(c_prime(n), middle * (1 - sin((n + rational(1, 4)) * psi()) / sin(quarter())),
                   derived, bases, forms.divisors_of_c));
  const Theorem before = linear(le(0, n - 1), {assume(from_1)});
  const auto one_before = [&](const Theorem& t) {
    return use(discharge(from_0, t), {{n, n - 1}}, {before});
  };
  const Expr c_form = middle * (1 + sin((n - rational(1, 4)) * psi()) / sin(quarter()));
  const Theorem c_from_1 = forms.proved(
      c(n), c_form, Theorems{part(book["cycle.P"], 1), one_before(a_n), one_before(c_prime_n)},
      bases, forms.divisors_of_c);
  const Theorem c_at_0 = equation(
      c(0), substitute(c_form, {{n, 0}}),
      {book["cycle.c_start"], restate(eq(sin((Expr(0) - rational(1, 4)) * psi()), -sin(quarter())),
                                      use("sin minus", {{x, quarter()}}))},
      forms.divisors);
  const Theorem at_0 = assume(eq(n, 0));
  const Theorem above_0 = assume(lt(0, n));
  const Theorem c_n = book.show(
      "c", "eq:c-final", "C after its n-th collision with A (before the first it rests):",
      tautology(
          eq(c(n), c_form),
          {discharge(at_0.conclusion(), restate(eq(c(n), c_form), rewrite(turned(at_0), c_at_0))),
           discharge(above_0.conclusion(),
                     cut(linear(le(1, n), {next_integer(above_0)}), c_from_1)),
           assume(from_0), use("equal or less or greater", {{x, n}, {y, 0}})}));

  // Products.
  const Exprs halves{n * psi() / 2, quarter()};
  const Theorems all_forms{a_n, b_n, c_prime_n};
  const Expr up = (n + rational(1, 2)) * half(), down = (n - rational(1, 2)) * half(),
             lead = 2 * middle * (1 + alpha);
  book.show("a_product", "", "The same as products: A,",
            forms.proved(a(n), lead * cos(up) * cos(down), all_forms, halves));
  book.show("b_product", "", "B,",
            forms.proved(b(n), lead * sin((n + 1) * half()) * sin(n * half()), all_forms, halves));
  book.show("c_prime_product", "", "C after B",
            forms.proved(c_prime(n), -2 * middle * sin(n * half()) * cos(up) / sin(quarter()),
                         all_forms, halves));
  book.show(
      "c_product", "", "and C after A:",
      forms.proved(c(n), 2 * middle * sin(n * half()) * cos(down) / sin(quarter()), {c_n}, halves));
  book.show("before_P", "", "Before P_(n+1) A approaches C with the speed",
            forms.proved(a(n) - c_prime(n), V * sin((n + rational(1, 2)) * psi()) / sin(half()),
                         all_forms + forms.sin_half, bases, forms.divisors_of_c));
  const Theorem c_next =
      use(discharge(from_0, c_n), {{n, n + 1}}, {linear(le(0, n + 1), {assume(from_0)})});
  book.show("before_Q", "", "Before Q_(n+1) C approaches B with the speed",
            forms.proved(c(n + 1) - b(n), V * sin((n + 1) * psi()) / sin(half()),
                         Theorems{c_next, b_n} + forms.sin_half, bases, forms.divisors_of_c));
}
}  // namespace derivation
