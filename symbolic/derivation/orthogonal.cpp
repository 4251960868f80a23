// Orthogonal matrices of the plane and of space: which of them are rotations.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr matrix_of_names(int size, const std::string& name = "o") {
  Exprs names;
  for (int i = 1; i <= size; ++i)
    for (int l = 1; l <= size; ++l)
      names.push_back(real(name + "_" + std::to_string(i) + std::to_string(l)));
  return matrix(size, names);
}
Expr cofactor(Expr m, int i, int l) {
  const auto at = [&](int row, int col) { return entry(m, (i + row) % 3, (l + col) % 3); };
  return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
}
Expr gram(Expr o) { return times(transpose(o), o); }
/// Names of entries by what stands in their places.
Substitution by_entries(Expr names, Expr values) {
  Substitution out;
  for (std::size_t i = 0; i < names.size(); ++i) out[names.arg(i)] = kernel::entries(values)[i];
  return out;
}
/// l = r by steps: each is the product before it, written so that an equation rewrites a part.
Theorem calculation(Expr l, Expr r, const std::vector<std::pair<Expr, Theorem>>& steps) {
  Theorem out = equation(l, l);
  for (const auto& [form, rule] : steps) out = rewrite(rule, restate(eq(l, form), out));
  return restate(eq(l, r), out);
}
/// |- det(O)^2 = 1 from O^T O = 1
Theorem squared_determinant(Expr o, const Theorem& is) {
  const Expr square = power(det(o), 2);
  return linear(eq(square, 1), {rewrite(is, equation(square, det(gram(o))))});
}
/// |- x = 0 from x^2 = 0
Theorem is_0(const Theorem& square) {
  const Expr of = left(square).arg(0);
  const Theorem none = given(neq(of, 0), [&](const Theorem& other) {
    return arithmetic(eq(of, 0), {.equations = {{-1, square}}, .multipliers = {other}});
  });
  return tautology(eq(of, 0), {none});
}
/// t != -1 |- 1 + t != 0
Theorem one_more_not_0(Expr t) {
  return tautology(neq(1 + t, 0), {assume(neq(t, -1)), linear(imp(eq(1 + t, 0), eq(t, -1)))});
}

/// The third axis of the frame F
Expr third_axis() { return column({real("r_13"), real("r_23"), real("r_33")}); }
/// |- name = matrix, for those of the plane and of space
Theorems named_matrices(Book& book) {
  Theorems names;
  const auto named = [&](const std::string& name, Expr m, const std::string& words) {
    names.push_back(define(name, kernel::entries(m), m));  // none of its entries is printed
    book.show("def_" + name, words, names.back());
  };
  named("Q", matrix_of_names(2), "Any matrix of the plane,");
  named("O", matrix_of_names(3), "any matrix of space,");
  named("F", matrix_of_names(3, "r"), "a frame,");
  named("f_3", third_axis(), "its third axis,");
  named("S", matrix_of_names(3, "m"), "a matrix as seen in that frame,");
  names.push_back(book.define("I", {}, identity(3), {}, "and the identity:"));
  return names;
}
/// |- matrix = name
Theorem named(const Theorem& is) { return equation(right(is), left(is), {is}); }
Theorem with_names(const Theorems& names, Theorem t) {
  for (const Theorem& is : names) {
    const Theorem name = named(is);
    for (const Expr& h : t.hypotheses()) {
      const Expr named = rewrite(name, assume(h)).conclusion();
      if (named != h) t = cut(rewrite(is, assume(named)), t);
    }
    t = rewrite(name, t);
  }
  return t;
}

/// O^T O = 1 |- det(O) is 1 or -1
Theorem orthogonal(Book& book, const Theorems& names, int size) {
  const Expr o = matrix_of_names(size), d = det(o);
  const Theorem is = assume(eq(gram(o), identity(size)));
  const Theorem other = given(neq(d, 1), [&](const Theorem& t) {
    // (1 - d)(-1 - d) = d^2 - 1
    return arithmetic(eq(d, -1),
                      {.equations = {{-1, squared_determinant(o, is)}}, .multipliers = {t}});
  });
  book.show(size == 2 ? "plane_determinant" : "space_determinant",
            size == 2 ? "An orthogonal matrix of the plane has the determinant 1 or -1,"
                      : "An orthogonal matrix of space has the determinant 1 or -1, too,",
            with_names(names, tautology(logic_or({eq(d, 1), eq(d, -1)}), {other})));
  return is;
}

/// An orthogonal matrix of the plane is a rotation, after a reflection where its determinant is -1.
/// Returns what is shown for a rotation.
Theorems in_the_plane(Book& book, const Theorems& names, const Theorem& is) {
  const Expr o = matrix_of_names(2);
  const Expr p = entry(o, 0, 0), q = entry(o, 0, 1), r = entry(o, 1, 0), s = entry(o, 1, 1);
  const Theorems products = entries(is);
  const Theorem unit = solved_for(power(r, 2), products[0]);
  const Expr slope = r / (1 + p), angle = atan(slope);
  const Theorem moves = one_more_not_0(p), at_end = assume(eq(p, -1));
  know(moves);
  const auto of_angle = [&](Expr l, Expr value) {
    return equation(l, value,
                    {at("cos atan", {{x, slope}}), at("sin atan", {{x, slope}}), unit, moves},
                    {angle});
  };
  const Theorem cosine = of_angle(cos(2 * angle), p), sine = of_angle(sin(2 * angle), r);
  const Theorem r_is_0 = is_0(equation(power(r, 2), 0, {unit, at_end}));
  Theorems shown;
  for (const int sign : {1, -1}) {
    const Theorem value = restate(eq(p * s - q * r, sign), assume(eq(det(o), sign)));
    // sign p - s = p (p s - q r) - s (p^2 + r^2)
    const Theorem s_is = arithmetic(
        eq(s, Expr(sign) * p), {.equations = {{-s, products[0]}, {p, value}, {r, products[1]}}});
    const Theorem q_is = arithmetic(
        eq(q, Expr(-sign) * r), {.equations = {{-q, products[0]}, {-r, value}, {p, products[1]}}});
    const auto turned_by = [&](Expr a, const Theorems& facts) {
      const Expr turn = fun("lambda", {a});
      return equation(
          o, sign == 1 ? turn : times(turn, fun("P_2", {})),
          Theorems{at(book["ball.lambda"], {{x, a}}), book["ball.P_2"], s_is, q_is} + facts);
    };
    const auto show = [&](const char* kind, const char* words, const Theorem& t) {
      book.show(std::string(sign == 1 ? "rotation" : "reflection") + kind, words,
                with_names(names, t));
      shown.push_back(t);
    };
    show("",
         sign == 1 ? "With determinant 1 it is a rotation of the plane,"
                   : "With determinant -1 it is a rotation after a reflection,",
         turned_by(2 * angle, {cosine, sine}));
    show("_half", "or half a turn,",
         turned_by(pi(), {axiom("cos pi"), axiom("sin pi"), at_end, r_is_0}));
  }
  return shown;
}

/// |- each entry of det(O) O is that of its cofactors, from O^T O = 1
Theorems cofactor_rule(Expr o, const Theorem& is) {
  Exprs all;
  for (int i = 0; i < 9; ++i) all.push_back(cofactor(o, i / 3, i % 3));
  const Expr cofactors = matrix(3, all);
  return entries(calculation(times(times(cofactors, transpose(o)), o), cofactors,
                             {{times(cofactors, gram(o)), is}}));
}
/// Of O with determinant 1: O X = X for X of cofactors of O - 1, O = 1 where none of its trace is
/// positive; and a frame with an axis of length 1 as its third one.
struct Axes {
  Theorem X, kept, only, frame_is;
  Expr trace, frame;
};
Axes axis(Book& book, const Theorems& names, const Theorem& is) {
  const Expr o = matrix_of_names(3), one = identity(3);
  const Exprs all = kernel::entries(o), products = kernel::entries(gram(o));
  const Theorem d_is_1 = assume(eq(det(o), 1));
  Exprs less_1, without, cofactors;
  for (std::size_t i = 0; i < 9; ++i) {
    less_1.push_back(i % 4 == 0 ? all[i] - 1 : all[i]);
    without.push_back(-all[3 * (i % 3) + i / 3] + products[i]);
  }
  const Expr rest = matrix(3, less_1), fixed = det(rest);
  for (int i = 0; i < 9; ++i) cofactors.push_back(cofactor(rest, i % 3, i / 3));
  const Theorem product =
      rewritten(entries(is) + Theorems{d_is_1},
                equation(det(o) * fixed, det(matrix(3, without))));  // det(O^T) det(O - 1)
  const Theorem none = linear(eq(fixed, 0), {product});
  book.show("axis", "With determinant 1 it has the eigenvalue 1,", with_names(names, none));
  const Theorem X = define("X", all, matrix(3, cofactors));
  book.show("def_X", "and with the cofactors of O - 1,", X);
  const Theorem kept = linear(eq(times(o, right(X)), right(X)), {none});
  book.show("axis_kept", "each column of X stays as it is: an axis,",
            with_names(names + Theorems{X}, kept));
  // The squares of the entries of O - 1 have the sum 6 - 2 tr(O) = 2 tr(X).
  const Expr trace = cofactors[0] + cofactors[4] + cofactors[8];
  Theorems facts = entries(is) + Theorems{assume(le(trace, 0))};
  for (const Expr& entry : less_1) facts.push_back(not_negative(power(entry, 2)));
  const Theorems times_d = cofactor_rule(o, is);
  for (std::size_t i = 0; i < 9; i += 4)
    facts.push_back(arithmetic(eq(all[i], cofactor(o, int(i / 3), int(i / 3))),
                               {.equations = {{1, times_d[i]}, {-all[i], d_is_1}}}));
  Theorems zeros;
  for (const Expr& entry : less_1) zeros.push_back(is_0(linear(eq(power(entry, 2), 0), facts)));
  const Theorem only = linear(eq(o, one), zeros);
  const Theorem X_is_0 = rewrite(X, assume(eq(left(X), matrix(3, Exprs(9, 0)))));
  book.show("axis_only", "and if X is 0, every line is one:",
            with_names(names, cut(linear(le(trace, 0), {X_is_0}), only)));
  const Expr p = real("r_13"), q = real("r_23"), s = real("r_33");
  const Expr per = 1 / (1 + s), across = -p * q * per;
  const Theorem unit = assume(eq(power(p, 2) + power(q, 2) + power(s, 2), 1));
  const Theorem divides = one_more_not_0(s);
  know(divides);
  const Expr frame =
      matrix(3, {1 - power(p, 2) * per, across, p, across, 1 - power(q, 2) * per, q, -p, -q, s});
  const Theorem frame_is = equation(eq(gram(frame), one), {solved_for(power(p, 2), unit), divides});
  book.show("frame", "An axis of length 1, or else its reverse, is the third one of a frame:",
            with_names(names, frame_is));
  return {X, kept, only, frame_is, trace, frame};
}
/// With determinant -1 a reflection comes first.
void in_space(Book& book, const Theorems& names, const Theorem& is) {
  const Expr o = matrix_of_names(3), d = det(o), one = identity(3);
  const Theorem mirror = book.name("P_3", {}, matrix(3, {1, 0, 0, 0, 1, 0, 0, 0, -1}), {},
                                   "The reflection of the third axis:");
  const Expr P_3 = fun("P_3", {}), mirrored = times(o, P_3);
  const Theorem kept = rewrite(named(mirror), linear(eq(gram(times(o, right(mirror))), one), {is}));
  book.show("space_reflection",
            "It changes the sign of a determinant, and applied twice it changes nothing, so that "
            "with determinant -1 the matrix is this reflection and then a rotation:",
            both({with_names(names, equation(det(mirrored), -d, {mirror})),
                  with_names(names, equation(o, times(mirrored, P_3), {mirror})),
                  with_names(names, kept)}));
  const Theorem first_axis =
      book.name("lambda_1", {x}, matrix(3, {1, 0, 0, 0, cos(x), -sin(x), 0, sin(x), cos(x)}), {},
                "A rotation about the first axis:", "eq:lambda-1");
  const Theorem second_axis =
      book.name("lambda_2", {x}, matrix(3, {cos(x), 0, sin(x), 0, 1, 0, -sin(x), 0, cos(x)}), {},
                "A rotation about the second axis:", "eq:lambda-2");
  const auto collision = [&](const std::string& name, const std::string& id, const Theorem& turn_is,
                             Expr angle, const std::string& bodies) {
    const Theorem is_collision = book[id];
    book.show(name, "Lam-GAM", bodies,
              equation(left(is_collision), times(substitute(left(turn_is), {{x, angle}}), P_3),
                       {is_collision, book["ball.Gamma_theta"], mirror, at(turn_is, {{x, angle}})},
                       {theta()}));
  };
  collision("Gamma_A", "cycle.Gamma_A", second_axis, -theta(),
            "The collision of A and C is a rotation after a reflection,");
  collision("Gamma_B", "cycle.Gamma_B", first_axis, theta(), "and so is that of C and B:");
}
/// With determinant 1 it is lambda_3(phi) in a frame whose third axis it leaves as it is.
Theorems about_an_axis(Book& book, const Theorems& names, const Theorem& is,
                       const Theorems& in_plane) {
  const Expr o = matrix_of_names(3), r = matrix_of_names(3, "r"), m = matrix_of_names(3, "m");
  const Expr one = identity(3), d = det(r), e_3 = column({0, 0, 1}), back = transpose(r);
  const Expr s = times(times(back, o), r), frame = times(r, back);
  const Theorem of_r = assume(eq(gram(r), one)), d_is_1 = assume(eq(det(o), 1));
  const Theorem fixed = assume(eq(times(o, third_axis()), third_axis())), named = assume(eq(s, m));
  // d R = cofactors, and d^2 = 1, so R R^T = 1.
  const Theorem squared = squared_determinant(r, of_r);
  const Theorems times_d = cofactor_rule(r, of_r);
  Theorems products;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Expr l = entry(frame, i, j), value = entry(one, i, j);
      Certificate c{.equations = {{value - l, squared}}};
      for (int k = 0; k < 3; ++k)
        c.equations.push_back({d * entry(r, i, k), times_d[std::size_t(3 * j + k)]});
      products.push_back(arithmetic(eq(l, value), c));
    }
  const Theorem of_frame = restate(eq(frame, one), both(products));
  // S = R^T O R is orthogonal; its third column is that of 1, and so is its third row.
  const Theorem of_s =
      calculation(gram(s), one,
                  {{times(times(transpose(times(o, r)), frame), times(o, r)), of_frame},
                   {times(times(back, gram(o)), r), is},
                   {gram(r), of_r}});
  const Theorem column_3 =
      calculation(times(s, e_3), e_3,
                  {{times(back, times(o, third_axis())), fixed}, {times(gram(r), e_3), of_r}});
  // So the rest of S is orthogonal with determinant 1: a rotation of the plane.
  Theorem shape = named;
  const Theorems last_column = entries(rewrite(named, column_3));
  for (int i = 0; i < 3; ++i)
    shape = rewrite(solved_for(entry(m, i, 2), last_column[std::size_t(i)]), shape);
  for (int i = 0; i < 2; ++i)
    shape = rewrite(linear(eq(entry(m, 2, i), 0), {rewrite(shape, of_s)}), shape);
  const Expr block = matrix(2, {entry(m, 0, 0), entry(m, 0, 1), entry(m, 1, 0), entry(m, 1, 1)});
  const Theorem product = equation(det(s), det(o) * power(d, 2));
  const Theorem determinant_1 =
      linear(eq(det(block), 1), {rewritten({shape, squared, d_is_1}, product)});
  const auto in_case = [&](const Theorem& in_the_plane, Expr given_angle) {
    const Theorem plane =
        cut(linear(eq(gram(block), identity(2)), {rewrite(shape, of_s)}),
            cut(determinant_1, instantiate(in_the_plane, by_entries(matrix_of_names(2), block))));
    const Expr angle = right(plane).arg(0), turn = lambda_3(angle);
    const Theorem of_turn =
        linear(eq(right(shape), turn), {plane, at(book["ball.lambda"], {{x, angle}}),
                                        at(book["rotation.lambda_3"], {{x, angle}})});
    const Theorem is_turn =
        calculation(o, times(times(r, turn), back),
                    {{times(times(one, o), one), linear(eq(one, frame), {of_frame})},
                     {times(times(r, s), back), rewrite(of_turn, shape)}});
    return discharge(given_angle, is_turn);
  };
  const Expr first = entry(m, 0, 0);
  know(one_more_not_0(first));
  const Theorems cases{in_case(in_plane[0], neq(first, -1)), in_case(in_plane[1], eq(first, -1))};
  book.show("lambda_n", "eq:lambda-n",
            "In a frame F whose third axis stays as it is, it is a rotation about that axis:",
            both({with_names(names, cases[0]), with_names(names, cases[1])}));
  return cases;
}
/// All of it together: there are a frame and an angle.
void some_axis(Book& book, const Theorems& names, const Theorem& is, const Axes& axes,
               const Theorems& in_frame) {
  const Expr o = matrix_of_names(3), r = matrix_of_names(3, "r"), phi = real("phi");
  const Expr F = fun("F", kernel::entries(r)), f_3 = third_axis();
  const Expr seen = times(times(transpose(axes.frame), o), axes.frame);
  const Exprs f = kernel::entries(f_3), X = kernel::entries(left(axes.X));
  const auto square = [](const Exprs& v) {
    return power(v[0], 2) + power(v[1], 2) + power(v[2], 2);
  };
  const Theorem unit = assume(eq(square(f), 1)), fixed = assume(eq(times(o, f_3), f_3));
  const Theorem of_r = assume(eq(gram(r), identity(3)));
  const Theorem F_is = rewritten({named(names[2]), named(names[5])}, of_r);
  Expr never = imp(F_is.conclusion(), neq(o, times(times(F, lambda_3(phi)), transpose(F))));
  const Exprs each = kernel::entries(r), quantified = each + Exprs{phi};
  for (auto v = quantified.rbegin(); v != quantified.rend(); ++v) never = all(*v, never);
  const Expr some = logic_not(never), down = eq(f[2], -1);
  Theorems facts{F_is};
  for (const Theorem& in_case : in_frame) {
    facts.push_back(rewrite(named(names[2]), in_case));
    Theorem none = assume(never);
    for (const Expr& value : each + Exprs{right(facts.back()).arg(1).arg(0).arg(1).arg(0)})
      none = specialize(none, value);
    facts.push_back(discharge(never, none));
  }
  Substitution to_frame = by_entries(r, axes.frame);
  to_frame.merge(by_entries(matrix_of_names(3, "m"), seen));
  const Theorem other = cut(axes.frame_is, cut(equation(seen, matrix(3, kernel::entries(seen))),
                                               instantiate(tautology(some, facts), to_frame)));
  const auto about = [&](const Theorem& t, const Exprs& axis, const Theorems& of_axis) {
    return at(t, {{f[0], axis[0]}, {f[1], axis[1]}, {f[2], axis[2]}}, of_axis);
  };
  const Theorem back = given(down, [&](const Theorem& is_down) {  // -f_3 is another axis
    return cut(linear(neq(-f[2], -1), {is_down}),
               about(other, {-f[0], -f[1], -f[2]}, {unit, fixed}));
  });
  const Theorem of_unit = tautology(some, {discharge(logic_not(down), other), back});
  // A column of X over its length, if its entry in the diagonal is positive; else O is 1.
  const Theorems kept = entries(rewrite(named(axes.X), axes.kept));
  Theorems diagonal = entries(axes.X);
  for (std::size_t l = 0; l < 3; ++l) {
    const Theorem is_positive = assume(lt(0, X[4 * l]));
    const Known here({is_positive});
    Exprs axis{X[l], X[l + 3], X[l + 6]};
    const Expr per = 1 / sqrt(square(axis));
    Theorems of_axis;
    for (std::size_t i = 0; i < 3; ++i) {
      const Theorem& e = kept[3 * i + l];
      of_axis.push_back(arithmetic(eq(left(e) * per, right(e) * per), {.equations = {{per, e}}}));
      axis[i] = axis[i] * per;
    }
    of_axis.push_back(equation(square(axis), 1));
    const Theorem turns = discharge(is_positive.conclusion(), about(of_unit, axis, of_axis));
    diagonal.push_back(follows(le(X[4 * l], 0), {turns, assume(never)}));
  }
  const Theorem is_1 = cut(linear(le(axes.trace, 0), diagonal), axes.only);
  const Theorem turns = tautology(some, {discharge(never, about(of_unit, {0, 0, 1}, {is_1}))});
  book.show(
      "space_rotation",
      "So with determinant 1 it is a rotation about an axis: there are a frame and an angle, as "
      "not all of them make another matrix,",
      with_names(names, turns));
  const Theorem mirror = book["orthogonal.P_3"];
  const Expr m = matrix(3, kernel::entries(times(o, right(mirror))));
  const Theorem m_turns = cut(
      linear(eq(gram(m), identity(3)), {is}),
      cut(linear(eq(det(m), 1), {assume(eq(det(o), -1))}), instantiate(turns, by_entries(o, m))));
  book.show(
      "space_mirror", "and with determinant -1 it is a reflection and then such a rotation:",
      both({with_names(names, rewrite(equation(m, times(o, left(mirror)), {mirror}), m_turns)),
            part(book["orthogonal.space_reflection"], 1)}));
}
}  // namespace

void orthogonal(Book& book) {
  book.chapter("orthogonal", "Orthogonal matrices", {});
  const Theorems names = named_matrices(book);
  const Theorems rotations = in_the_plane(book, names, orthogonal(book, names, 2));
  const Theorem is = orthogonal(book, names, 3);
  const Axes axes = axis(book, names, is);
  in_space(book, names, is);
  some_axis(book, names, is, axes, about_an_axis(book, names, is, rotations));
}
}  // namespace derivation
