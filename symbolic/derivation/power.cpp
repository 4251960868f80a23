// Lambda^n, and with it the velocities after n cycles, for every n, under alpha > 0 alone.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
void powers_of_lambda(Book& book) {
  const auto turned_by = [&](Expr angle) { return at(book["rotation.lambda_3"], {{x, angle}}); };
  book.show("angles_add", "Rotations about one axis add their angles:",
            equation(times(lambda_3(x), lambda_3(y)), lambda_3(x + y),
                     {turned_by(x), turned_by(y), turned_by(x + y)}, {x, y}));
  // Lambda^n
  const auto turned_frame = [](Expr angle) {
    return times(times(R(), lambda_3(angle)), transpose(R()));
  };
  const Theorem powers = matrix_power(Lambda(), n);
  const Theorem power_0 = part(powers, 0), frame = book["rotation.R"], split = root_split(book);
  const Theorem base =
      equation(power(Lambda(), Expr(0)), turned_frame(Expr(0) * psi()),
               {power_0, turned_by(Expr(0) * psi()), frame, axiom("cos 0"), axiom("sin 0")});
  book.show(
      "Lambda_n", "eq:Lambda-n-final eq:Lambda-n-final-txt", "So n cycles turn by n psi:",
      by_induction(
          n, eq(power(Lambda(), n), turned_frame(n * psi())), base, [&](const Theorem& now) {
            const Theorem added = equation(
                times(Lambda(), turned_frame(n * psi())), turned_frame((n + 1) * psi()),
                {book["cycle.Lambda"], split, frame, turned_by(n * psi()),
                 turned_by((n + 1) * psi()), book["rotation.cos_psi"], book["rotation.sin_psi"]},
                {n * psi(), psi()});
            return rewrite(added, rewrite(now, at(part(powers, 1))));
          }));

  // V_n = Lambda^n V_0
  book.show("V_n", "eq:V-n-0 eq:V-n-0-app", "and the velocities are",
            by_induction(
                n, eq(V_vector(n), times(power(Lambda(), n), column({V, 0, 0}))),
                {at(book["cycle.vector"], {{n, 0}}), power_0, book["cycle.start_vector"]},
                {canonical_form(at(book["cycle.recurrence"], {{n, n + 1}})), at(part(powers, 1))}));
}

/// The quarter of psi and the velocity of the centre of mass; the rules that they give.
Theorems quarter_rules(Book& book) {
  const Theorem cos_half = book["rotation.cos_half_psi"], sin_half = book["rotation.sin_half_psi"];
  const Theorem cosine_squared = linear(
      eq(power(cos(quarter()), 2), (1 + 1 / (1 + alpha)) / 2),
      {angles({cos(half())}, {quarter()}, false)[0], cos_half, at("circle", {{x, quarter()}})});
  const Theorem product = linear(eq(cos(quarter()) * sin(quarter()), right(sin_half) / 2),
                                 {angles({sin(half())}, {quarter()}, false)[0], sin_half});
  book.show("quarter",
            "The quarter of psi:", both({positive(sin(quarter())), cosine_squared, product}));
  const Theorem mean = book.name("V_CM", {alpha, V}, V / (2 + alpha), {alpha_positive},
                                 "The velocity of the centre of mass:");
  book.show("V_CM_psi", "in terms of psi,",
            equation(V_CM(), V * cos(half()) / (1 + cos(half())), {mean, cos_half}));
  return {cosine_squared, product, mean, cos_half, sin_half, root_split(book)};
}
}  // namespace

void powers(Book& book) {
  book.chapter("power", "The velocities", {alpha_positive, n_from_0});
  powers_of_lambda(book);

  // Multiplied out.
  const Expr frame = right(book["rotation.R"]);
  const Theorem turn = at(book["rotation.lambda_3"], {{x, n * psi()}});
  const Expr turned_frame = times(times(frame, right(turn)), transpose(frame));
  const Expr velocities = times(turned_frame, column({V, 0, 0}));
  Theorems rules{rewrite(book["power.Lambda_n"], book["power.V_n"]), book["rotation.R"], turn};
  for (const Theorem& t : entries(book["cycle.vector"])) rules.push_back(turned(t));
  Theorems derived;
  const auto multiplied = [&](const std::string& name, const std::string& words, Expr of, int row,
                              Expr divisor) {
    const Expr value =
        simplified(entry(velocities, row, 0) / divisor, {cos(n * psi()), sin(n * psi())});
    const Theorems factors = divisor == Expr(1) ? Theorems{} : Theorems{positive(divisor)};
    derived.push_back(book.show(name, words, cancel(eq(of, value), factors, rules)));
  };
  multiplied("a_multiplied", "Multiplied out, A has", a(n), 0, 1);
  multiplied("b_multiplied", "B has", b(n), 1, 1);
  multiplied("c_prime_multiplied", "and C has", c_prime(n), 2, sqrt(alpha));

  const Theorems common = quarter_rules(book);
  const Expr middle = V_CM();
  const Theorem a_n =
      book.show("a", "eq:a-final", "A after its n-th collision, as the paper has it:",
                equation(a(n), middle * (1 + cos(n * psi()) / cos(half())), derived + common));
  const Theorem b_n =
      book.show("b", "eq:b-final", "B after its n-th collision:",
                equation(b(n), middle * (1 - cos((n + rational(1, 2)) * psi()) / cos(half())),
                         derived + common, {n * psi(), half()}));
  const auto proved = [&](Expr l, Expr r, const Theorems& forms) {
    return cancel(eq(l, r), {positive(sin(quarter()))}, forms + common, {n * psi() / 2, quarter()});
  };
  const Theorem c_prime_n =
      book.show("c_prime", "eq:c'-final", "C after its n-th collision with B:",
                proved(c_prime(n),
                       middle * (1 - sin((n + rational(1, 4)) * psi()) / sin(quarter())), derived));
  const Theorems finals{a_n, b_n, c_prime_n};
  const Expr c_form = middle * (1 + sin((n - rational(1, 4)) * psi()) / sin(quarter()));
  const Theorem c_from_1 =
      proved(c(n), c_form, {part(book["cycle.P"], 1), one_before(a_n), one_before(c_prime_n)});
  const Theorem c_at_0 =
      equation(c(0), substitute(c_form, {{n, 0}}), {book["cycle.c_start"]}, {quarter()});
  const auto later = [&](const Theorem& t) { return cut(linear(le(1, n), {t}), c_from_1); };
  const Theorem c_n =
      book.show("c", "eq:c-final", "C after its n-th collision with A (before the first it rests):",
                follows(eq(c(n), c_form), {where_equal(n, 0, eq(c(n), c_form), c_at_0),
                                           given(lt(0, n), later), assume(n_from_0)}));

  // Products.
  const Expr up = (n + rational(1, 2)) * half(), down = (n - rational(1, 2)) * half(),
             lead = 2 * middle * (1 + alpha);
  book.show("a_product", "The same as products: A,",
            proved(a(n), lead * cos(up) * cos(down), finals));
  book.show("b_product", "B,",
            proved(b(n), lead * sin((n + 1) * half()) * sin(n * half()), finals));
  book.show("c_prime_product", "C after B",
            proved(c_prime(n), -2 * middle * sin(n * half()) * cos(up) / sin(quarter()), finals));
  book.show("c_product", "and C after A:",
            proved(c(n), 2 * middle * sin(n * half()) * cos(down) / sin(quarter()), {c_n}));
  book.show("before_P", "Before P_(n+1) A approaches C with the speed",
            proved(a(n) - c_prime(n), V * sin((n + rational(1, 2)) * psi()) / sin(half()), finals));
  book.show("before_Q", "Before Q_(n+1) C approaches B with the speed",
            proved(c(n + 1) - b(n), V * sin((n + 1) * psi()) / sin(half()),
                   {at(c_n, {{n, n + 1}}), b_n}));
}
}  // namespace derivation
