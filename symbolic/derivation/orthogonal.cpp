// SPDX-License-Identifier: GPL-2.0-or-later
// Orthogonal matrices of the plane and of space: what keeps lengths, and which of them are
// rotations.
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
Expr determinant(Expr m) {
  if (m.rows() == 2) return entry(m, 0, 0) * entry(m, 1, 1) - entry(m, 0, 1) * entry(m, 1, 0);
  Expr sum = entry(m, 0, 0) * cofactor(m, 0, 0);
  for (int l = 1; l < 3; ++l) sum = sum + entry(m, 0, l) * cofactor(m, 0, l);
  return sum;
}
Expr gram(Expr o) { return times(transpose(o), o); }
Theorem rewritten(const Theorems& equations, Theorem t) {
  for (const Theorem& e : equations) t = rewrite(e, t);
  return t;
}
/// l = r, each entry as `each` proves it.
Theorem entrywise(Expr l, Expr r, const std::function<Theorem(Expr, int, int)>& each) {
  Theorems out;
  for (int i = 0; i < l.rows(); ++i)
    for (int j = 0; j < l.cols(); ++j)
      out.push_back(each(eq(entry(l, i, j), entry(r, i, j)), i, j));
  return restate(eq(l, r), both(out));
}
/// l = r by steps: each is the product before it, written so that an equation rewrites a part.
Theorem calculation(Expr l, Expr r, const std::vector<std::pair<Expr, Theorem>>& steps) {
  Theorem out = equation(l, l);
  for (const auto& [form, rule] : steps) out = rewrite(rule, restate(eq(l, form), out));
  return restate(eq(l, r), out);
}
/// l = r, each entry a linear combination of `facts`.
Theorem by_entries(Expr l, Expr r, const Theorems& facts) {
  return entrywise(l, r, [&](Expr goal, int, int) { return linear(goal, facts); });
}
/// |- det(O)^2 = 1 from O^T O = 1
Theorem squared_determinant(Expr o, const Theorem& is) {
  const Theorem product = equation(power(det(o), 2), determinant(gram(o)));
  return linear(eq(power(det(o), 2), 1), {rewritten(entries(is), product)});
}
/// t != -1 |- 1 + t != 0
Theorem one_more_not_0(Expr t) {
  return tautology(neq(1 + t, 0), {assume(neq(t, -1)), linear(imp(eq(1 + t, 0), eq(t, -1)))});
}

/// Shows theorems of matrices of names with Q, O, F and S for them, and keeps them in full.
class Pages {
public:
  explicit Pages(Book& the_book) : book(the_book) {
    const auto named = [&](const char* name, int size, const char* entry, const char* words) {
      const Expr m = matrix_of_names(size, entry);
      const Theorem is = define(name, kernel::entries(m), m);  // none of its entries is printed
      names.push_back(equation(m, left(is), {is}));
      book.show(std::string("def_") + name, words, is);
    };
    named("Q", 2, "o", "Any matrix of the plane,");
    named("O", 3, "o", "any matrix of space,");
    named("F", 3, "r", "a frame,");
    named("S", 3, "m", "and a matrix as seen in that frame:");
  }
  Book& book;
  Theorem operator[](const std::string& id) const { return book[id]; }
  Theorem in_full(const std::string& name) const { return full.at(name); }
  void show(const std::string& name, const std::string& words, const Theorem& t) {
    show(name, "", words, t);
  }
  void show(const std::string& name, const std::string& label, const std::string& words,
            const Theorem& t) {
    full.emplace(name, t);
    book.show(name, label, words, with_names(t));
  }

private:
  Theorems names;  // |- matrix = name
  std::map<std::string, Theorem> full;

  static Theorem in_entries(const Theorem& name) {
    return equation(right(name), left(name), {name});
  }
  Theorem with_names(Theorem t) const {
    if (t.conclusion().op() == Op::And) {  // of fewer cases each
      Theorems parts;
      for (std::size_t i = 0; i < t.conclusion().size(); ++i)
        parts.push_back(with_names(part(t, i)));
      return both(parts);
    }
    for (const Theorem& name : names) {
      for (const Expr& h : t.hypotheses()) {
        const Expr named = rewrite(name, assume(h)).conclusion();
        if (named != h) t = cut(rewrite(in_entries(name), assume(named)), t);
      }
      t = rewrite(name, t);
    }
    return t;
  }
};

/// Lengths are kept if and only if O^T O = 1; then det(O) is 1 or -1.
Theorem orthogonal(Pages& book, int size) {
  const bool plane = size == 2;
  const std::string where = plane ? "plane" : "space";
  const Expr o = matrix_of_names(size), d = det(o);
  const Exprs all_names{real("v_1"), real("v_2"), real("v_3")};
  const Exprs v(all_names.begin(), all_names.begin() + size);
  const Expr image = times(o, column(v));
  const Expr kept = eq(times(transpose(image), image), times(transpose(column(v)), column(v)));
  Expr always = kept;
  for (int i = size - 1; i >= 0; --i) always = all(v[std::size_t(i)], always);
  Theorems along;  // kept for e_i + e_l, or for e_i
  for (int i = 0; i < size; ++i)
    for (int l = i; l < size; ++l) {
      Theorem t = assume(always);
      for (int m = 0; m < size; ++m) t = specialize(t, m == i || m == l ? 1 : 0);
      along.push_back(t);
    }
  const Theorem is = assume(eq(gram(o), identity(size)));
  book.show(where,
            plane ? "A matrix that keeps all lengths in the plane is orthogonal,"
                  : "In space, too, a matrix that keeps all lengths is orthogonal,",
            by_entries(gram(o), identity(size), along));
  book.show(where + "_keeps", "and an orthogonal one keeps them;",
            calculation(kept.arg(0), kept.arg(1),
                        {{times(times(transpose(column(v)), gram(o)), column(v)), is}}));
  const Theorem other = given(neq(d, 1), [&](const Theorem& t) {
    // (1 - d)(-1 - d) = d^2 - 1
    return arithmetic(eq(d, -1),
                      {.equations = {{-1, squared_determinant(o, is)}}, .multipliers = {t}});
  });
  book.show(where + "_determinant",
            "its determinant is 1 or -1:", tautology(logic_or({eq(d, 1), eq(d, -1)}), {other}));
  return is;
}

/// An orthogonal matrix of the plane is a rotation, after a reflection where its determinant is -1.
void in_the_plane(Pages& book, const Theorem& is) {
  const Expr o = matrix_of_names(2);
  const Expr p = entry(o, 0, 0), q = entry(o, 0, 1), r = entry(o, 1, 0), s = entry(o, 1, 1);
  const Theorems products = entries(is);
  const Theorem unit = solved_for(power(r, 2), products[0]);
  const Expr t = r / (1 + p), angle = atan(t);
  const Theorem moves = one_more_not_0(p), at_end = assume(eq(p, -1));
  know(moves);
  const auto of_angle = [&](Expr l, Expr value) {
    return equation(l, value, {at("cos atan", {{x, t}}), at("sin atan", {{x, t}}), unit, moves},
                    {angle});
  };
  const Theorem cosine = of_angle(cos(2 * angle), p), sine = of_angle(sin(2 * angle), r);
  const Theorem none = given(neq(r, 0), [&](const Theorem& moved) {
    return arithmetic(eq(r, 0),
                      {.equations = {{-1, unit}, {p - 1, at_end}}, .multipliers = {moved}});
  });
  const Theorem r_is_0 = tautology(eq(r, 0), {none});
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
    const std::string name = sign == 1 ? "rotation" : "reflection";
    book.show(name,
              sign == 1 ? "With determinant 1 it is a rotation of the plane,"
                        : "With determinant -1 it is a rotation after a reflection,",
              turned_by(2 * angle, {cosine, sine}));
    book.show(name + "_half", "or half a turn,",
              turned_by(pi(), {axiom("cos pi"), axiom("sin pi"), at_end, r_is_0}));
  }
}

/// |- each entry of det(O) O is that of its cofactors, from O^T O = 1
Theorems cofactor_rule(Expr o, const Theorem& is) {
  Exprs all;
  for (int i = 0; i < 9; ++i) all.push_back(cofactor(o, i / 3, i % 3));
  const Expr cofactors = matrix(3, all);
  return entries(calculation(times(times(cofactors, transpose(o)), o), cofactors,
                             {{times(cofactors, gram(o)), is}}));
}
/// In space: with determinant 1 there is an axis, with -1 there is one after the reflection P_3.
void in_space(Pages& book, const Theorem& is) {
  const Expr o = matrix_of_names(3), d = det(o), one = identity(3);
  const Theorem d_is_1 = assume(eq(d, 1));
  Exprs less_1, without;
  const Exprs names = kernel::entries(o), products = kernel::entries(gram(o));
  for (std::size_t i = 0; i < 9; ++i) {
    less_1.push_back(i % 4 == 0 ? names[i] - 1 : names[i]);
    without.push_back(-names[3 * (i % 3) + i / 3] + products[i]);
  }
  const Expr fixed = det(matrix(3, less_1));
  const Theorem product =
      rewritten(entries(is) + Theorems{d_is_1},
                equation(d * fixed, determinant(matrix(3, without))));  // det(O^T) det(O - 1)
  book.show("axis", "With determinant 1 it has the eigenvalue 1, so that an axis stays as it is:",
            linear(eq(fixed, 0), {product}));
  const Theorem mirror = book.book.name("P_3", {}, matrix(3, {1, 0, 0, 0, 1, 0, 0, 0, -1}), {},
                                        "The reflection of the third axis:");
  const Expr P_3 = fun("P_3", {}), mirrored = times(o, P_3);
  const Expr columns = matrix(3, {names[0], names[1], -names[2], names[3], names[4], -names[5],
                                  names[6], names[7], -names[8]});
  book.show(
      "space_reflection",
      "It changes the sign of a determinant, and applied twice it changes nothing, so that "
      "with determinant -1 the matrix is this reflection and then a rotation:",
      both({equation(det(mirrored), -d, {mirror}), equation(o, times(mirrored, P_3), {mirror}),
            rewrite(equation(columns, mirrored, {mirror}), by_entries(gram(columns), one, {is}))}));
  const auto turn = [&](const std::string& name, const std::string& label, const std::string& axis,
                        const Exprs& m) {
    return book.book.name(name, {x}, matrix(3, m), {},
                          "A rotation about the " + axis + " axis:", label);
  };
  const Theorem first_axis =
      turn("lambda_1", "eq:lambda-1", "first", {1, 0, 0, 0, cos(x), -sin(x), 0, sin(x), cos(x)});
  const Theorem second_axis =
      turn("lambda_2", "eq:lambda-2", "second", {cos(x), 0, sin(x), 0, 1, 0, -sin(x), 0, cos(x)});
  const auto collision = [&](const std::string& name, const std::string& id, const Theorem& turn_is,
                             Expr angle, const std::string& bodies) {
    const Expr l = left(book[id]);
    book.show(name, "Lam-GAM", bodies,
              equation(l, times(substitute(left(turn_is), {{x, angle}}), P_3),
                       {book[id], book["ball.Gamma_theta"], mirror, at(turn_is, {{x, angle}})},
                       {theta()}));
  };
  collision("Gamma_A", "cycle.Gamma_A", second_axis, -theta(),
            "The collision of A and C is a rotation after a reflection,");
  collision("Gamma_B", "cycle.Gamma_B", first_axis, theta(), "and so is that of C and B:");
}
/// With determinant 1 it is lambda_3(phi) in a frame whose third axis it leaves as it is.
void about_an_axis(Pages& book, const Theorem& is) {
  const Expr o = matrix_of_names(3), r = matrix_of_names(3, "r"), one = identity(3), d = det(r);
  const Expr e_3 = column({0, 0, 1}), back = transpose(r);
  const Expr third_axis = column({entry(r, 0, 2), entry(r, 1, 2), entry(r, 2, 2)});
  const Theorem of_r = assume(eq(gram(r), one));
  const Theorem fixed = assume(eq(times(o, third_axis), third_axis));
  const Expr s = times(times(back, o), r), frame = times(r, back);
  // d R = cofactors, and d^2 = 1, so R R^T = 1.
  const Theorem squared = squared_determinant(r, of_r);
  const Theorems times_d = cofactor_rule(r, of_r);
  const Theorem of_frame = entrywise(frame, one, [&](Expr goal, int i, int j) {
    Certificate c;
    c.equations = {{entry(one, i, j) - entry(frame, i, j), squared}};
    for (int k = 0; k < 3; ++k)
      c.equations.push_back({d * entry(r, i, k), times_d[std::size_t(3 * j + k)]});
    return arithmetic(goal, c);
  });
  // S = R^T O R is orthogonal; its third column and third row are those of 1.
  const Theorem of_s =
      calculation(gram(s), one,
                  {{times(times(transpose(times(o, r)), frame), times(o, r)), of_frame},
                   {times(times(back, gram(o)), r), is},
                   {gram(r), of_r}});
  const Theorem column_3 =
      calculation(times(s, e_3), e_3,
                  {{times(back, times(o, third_axis)), fixed}, {times(gram(r), e_3), of_r}});
  const Theorem row_3 = calculation(times(transpose(e_3), s), transpose(e_3),
                                    {{times(times(transpose(third_axis), o), r),
                                      by_entries(third_axis, times(o, third_axis), {fixed})},
                                     {times(times(transpose(third_axis), gram(o)), r), is},
                                     {times(transpose(e_3), gram(r)), of_r}});
  const Theorems row = entries(row_3), gram_s = entries(of_s);
  // So the rest of S is orthogonal with determinant 1: a rotation of the plane.
  const auto s_ = [&](int i, int l) { return entry(s, i, l); };
  const Expr block = matrix(2, {s_(0, 0), s_(0, 1), s_(1, 0), s_(1, 1)});
  Substitution terms;
  const Theorem orthogonal_block =
      entrywise(gram(block), identity(2), [&](Expr goal, int i, int j) {
        terms[entry(matrix_of_names(2), i, j)] = s_(i, j);
        return arithmetic(goal, {.equations = {{1, gram_s[std::size_t(3 * i + j)]},
                                               {-s_(2, j), row[std::size_t(i)]}}});
      });
  Certificate c;
  c.equations = {{1, squared}, {power(d, 2), assume(eq(det(o), 1))}};
  for (int i = 0; i < 3; ++i) c.equations.push_back({-cofactor(s, 2, i), row[std::size_t(i)]});
  const Theorem determinant_1 = arithmetic(eq(det(block), 1), c);
  const Expr m = matrix_of_names(3, "m");
  const Theorem named = assume(eq(s, m));
  const auto in_case = [&](const std::string& id, Expr angle, Expr given_angle) {
    const Theorem plane =
        cut(orthogonal_block, cut(determinant_1, instantiate(book.in_full(id), terms)));
    const Expr turn = lambda_3(angle), there = times(times(r, turn), back);
    const Theorem of_turn =
        by_entries(s, turn,
                   {plane, column_3, row_3, at(book["ball.lambda"], {{x, angle}}),
                    at(book["rotation.lambda_3"], {{x, angle}})});
    const Theorem is_turn =
        calculation(o, there,
                    {{times(times(one, o), one), by_entries(one, frame, {of_frame})},
                     {times(times(r, s), back), of_turn}});
    return rewritten(entries(named), discharge(substitute(given_angle, terms), is_turn));
  };
  const Expr first = entry(matrix_of_names(2), 0, 0);
  know(one_more_not_0(entry(m, 0, 0)));
  book.show("lambda_n", "eq:lambda-n",
            "In a frame F whose third axis stays as it is, it is a rotation about that axis:",
            under({is.conclusion(), eq(det(o), 1), of_r.conclusion(), fixed.conclusion(),
                   named.conclusion()},
                  both({in_case("rotation", 2 * atan(s_(1, 0) / (1 + s_(0, 0))), neq(first, -1)),
                        in_case("rotation_half", pi(), eq(first, -1))})));
}
}  // namespace

void orthogonal(Book& book) {
  book.chapter("orthogonal", "Orthogonal matrices", {});
  Pages chapter(book);
  in_the_plane(chapter, orthogonal(chapter, 2));
  const Theorem is = orthogonal(chapter, 3);
  in_space(chapter, is);
  about_an_axis(chapter, is);
}
}  // namespace derivation
