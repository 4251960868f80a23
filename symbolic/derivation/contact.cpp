// One collision of two bodies: from momentum and energy to the velocities after it, and to Gamma.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
/// v_1 and v_2 of two bodies of any masses.
Theorem velocities_after(Book& book) {
  const Expr energy =
      eq(M_1 * power(u_1, 2) + M_2 * power(u_2, 2), M_1 * power(v_1, 2) + M_2 * power(v_2, 2));
  const Exprs bodies{M_1, M_2, u_1, u_2, v_1, v_2};
  const Theorem law =
      book.show("law",
                "A collision of bodies with masses M_1 and M_2 changes velocities u into v. It "
                "keeps momentum and energy, and something changes:",
                define("contact", bodies, logic_and({momentum_kept, energy, neq(v_1, u_1)}), 0));
  const Theorems laws = parts({tautology(right(law), {law, assume(fun("contact", bodies))})});
  const Theorem P = laws[0], E = laws[1], changes = laws[2];

  // M_1 (u_1 - v_1) ((u_1 + v_1) - (u_2 + v_2)) = 0, and the first two factors are not 0.
  const Theorem relative =
      book.show("relative", "Then the relative velocity turns round:",
                arithmetic(eq(u_1 + v_1, u_2 + v_2), {.equations = {{1, E}, {-(u_2 + v_2), P}},
                                                      .multipliers = {positive(M_1), changes}}));
  const Exprs after = solve({momentum_kept, relative.conclusion()}, {v_1, v_2}, {u_1, u_2});
  const Theorems rules{solved_for(v_2, relative), solved_for(M_1 * v_1, P)};
  const Theorem velocities =
      both({book.show("v_1",
                      "Together with momentum these are two linear equations, and the velocities "
                      "after the collision are",
                      equation(v_1, after[0], rules)),
            book.show("v_2", "and", equation(v_2, after[1], rules))});

  const Theorem reverse = instantiate(law, {{u_1, -v_1}, {u_2, -v_2}, {v_1, -u_1}, {v_2, -u_2}});
  const Expr back = right(reverse);
  book.show("reversed", "Run backwards in time, a collision is a collision again:",
            tautology(left(reverse), {reverse, linear(back.arg(0), {P}), linear(back.arg(1), {E}),
                                      linear(iff(eq(-u_1, -v_1), eq(v_1, u_1))), changes}));

  // The converse: with these velocities, v_1 is u_1 only where u_1 is u_2.
  const Expr alike = eq(u_1, u_2), stays = eq(v_1, u_1);
  const Theorem w_1 = assume(eq(v_1, after[0])), w_2 = assume(eq(v_2, after[1]));
  const auto where = [&](Expr f, const Theorem& t) {
    return discharge(w_1.conclusion(), discharge(f, t));
  };
  const Theorem together =
      arithmetic(alike, {.equations = {{-(M_1 + M_2) / 2, assume(stays)}, {(M_1 + M_2) / 2, w_1}},
                         .multipliers = {positive(M_2)},
                         .nonzero = {positive(M_1 + M_2)}});
  const Theorems facts{
      law, discharge(left(law), velocities), where(alike, equation(v_1, u_1, {w_1, assume(alike)})),
      where(stays, together),
      where(w_2.conclusion(), equation(logic_and({momentum_kept, energy}), {w_1, w_2}))};
  book.show(
      "exists",
      "Conversely, these velocities keep momentum and energy, and something changes where the "
      "bodies approach or part. So the law says no more than this:",
      tautology(iff(left(law), logic_and({w_1.conclusion(), w_2.conclusion(), neq(u_1, u_2)})),
                facts));
  return velocities;
}
}  // namespace

void show_angle(Book& book, const Theorem& is, const Theorems& hypotenuse, Expr cosine, Expr sine) {
  const Expr angle = left(is), t = right(is).arg(1).arg(0);
  const Theorem half = linear(eq(atan(t), angle / 2), {is});
  const auto show = [&](const std::string& of, const char* words, const Theorem& theorem) {
    return book.show(of + angle.name(), "table:trig", words, theorem);
  };
  const auto at_half = [&](const char* axiom_name) {
    return rewritten(hypotenuse, rewrite(half, at(axiom_name, {{x, t}})));
  };
  const Theorems of_half{show("cos_half_", "Its half is an arctangent,", at_half("cos atan")),
                         show("sin_half_", "and", at_half("sin atan"))};
  show("cos_", "The double angle", equation(cos(angle), cosine, of_half, {angle / 2}));
  show("sin_", "and", equation(sin(angle), sine, of_half, {angle / 2}));
}

void contact(Book& book) {
  book.chapter("contact", "One collision of two bodies", {lt(0, M_1), lt(0, M_2)});
  const Theorem general = velocities_after(book);

  // A block of mass M and the ball of mass alpha M.
  book.chapter("ball", "A block and the ball", {alpha_positive, lt(0, M)});
  const Theorem special =
      cut(positive(alpha * M), instantiate(general, {{M_1, M}, {M_2, alpha * M}}));
  Exprs after;
  Theorems velocities;
  for (std::size_t i = 0; i < 2; ++i) {
    const Theorem v = part(special, i);
    after.push_back(simplified(right(v), {u_1, u_2}));
    velocities.push_back(chain(v, equation(right(v), after[i])));
  }
  book.show("velocities", "A block of mass M and the ball of mass alpha M:", both(velocities));

  // In terms of (u_1, sqrt(alpha) u_2): scaled coefficients of u_1 and u_2.
  const Expr s = sqrt(alpha);
  const auto coefficient = [&](std::size_t row, int in_u_1) {
    return substitute(after[row], {{u_1, in_u_1}, {u_2, 1 - in_u_1}});
  };
  const Expr scaled_matrix = simplified(matrix(
      2, {coefficient(0, 1), coefficient(0, 0) / s, s * coefficient(1, 1), coefficient(1, 0)}));
  const Theorem gamma =
      book.name("Gamma", {alpha}, scaled_matrix, {alpha_positive},
                "With the ball's velocities times sqrt(alpha), the coefficients form the matrix");
  book.show("collision", "so that a collision is a linear map:",
            equation(column({v_1, s * v_2}), times(Gamma(), column({u_1, s * u_2})),
                     velocities + Theorems{gamma}));
  book.show("Gamma_paper", "eq:Gamma", "As the paper writes it:",
            equation(Gamma(),
                     matrix(2, {(1 - alpha) / (1 + alpha), 2 * s / (1 + alpha), 2 * s / (1 + alpha),
                                -(1 - alpha) / (1 + alpha)}),
                     {gamma}));
  book.show("Gamma_orthogonal", "It is orthogonal,",
            equation(times(Gamma(), transpose(Gamma())), identity(2), {gamma}));
  book.show("Gamma_determinant", "with determinant -1:", equation(det(Gamma()), -1, {gamma}));

  // theta
  const Theorem angle = book.name("theta", {alpha}, 2 * atan(s), {alpha_positive},
                                  "The angle theta:", "def:theta theta-txt");
  show_angle(book, angle, {equation(1 + power(s, 2), 1 + alpha)}, (1 - alpha) / (1 + alpha),
             2 * s / (1 + alpha));
  const Theorem plane = book.name("lambda", {x}, matrix(2, {cos(x), -sin(x), sin(x), cos(x)}), {},
                                  "A rotation of the plane");
  const Theorem mirror = book.name("P_2", {}, matrix(2, {1, 0, 0, -1}), {}, "and a reflection:");
  const Theorems turned_rules{gamma, book["ball.cos_theta"], book["ball.sin_theta"],
                              at(plane, {{x, theta()}}), mirror};
  book.show("Gamma_theta", "def:gamma", "With it Gamma is",
            equation(Gamma(), matrix(2, {cos(theta()), sin(theta()), sin(theta()), -cos(theta())}),
                     turned_rules));
  book.show("Gamma_rotation", "def:gamma", "a rotation after a reflection:",
            equation(Gamma(), times(fun("lambda", {theta()}), fun("P_2", {})), turned_rules));
}
}  // namespace derivation
