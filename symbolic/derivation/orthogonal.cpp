// SPDX-License-Identifier: GPL-2.0-or-later
// Orthogonal matrices of the plane and of space: what keeps lengths, and which of them are
// rotations.
#include <functional>

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
Expr determinant(const Exprs& m) {
  if (m.size() == 4) return m[0] * m[3] - m[1] * m[2];
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}
Expr cofactor(Expr m, int i, int l) {
  const auto at = [&](int row, int col) { return entry(m, (i + row) % 3, (l + col) % 3); };
  return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
}
Expr gram(Expr o) { return times(transpose(o), o); }
Theorem rewritten(const Theorems& equations, Theorem t) {
  for (const Theorem& e : equations) t = rewrite(e, t);
  return t;
}

/// Lengths are kept if and only if O^T O = 1; then det(O) is 1 or -1.
Theorem orthogonal(Book& book, int size) {
  const bool plane = size == 2;
  const std::string where = plane ? "plane" : "space";
  const Expr o = matrix_of_names(size), d = det(o);
  const Exprs all_names{real("v_1"), real("v_2"), real("v_3")};
  const Exprs v(all_names.begin(), all_names.begin() + size);
  const Expr image = times(o, column(v));
  const Expr kept = eq(times(transpose(image), image), times(transpose(column(v)), column(v)));
  Expr always = kept;
  for (int i = size - 1; i >= 0; --i) always = all(v[std::size_t(i)], always);
  const auto along = [&](int i, int l) {  // kept for e_i + e_l, or for e_i
    Theorem t = assume(always);
    for (int m = 0; m < size; ++m) t = specialize(t, m == i || m == l ? 1 : 0);
    return entries(t)[0];
  };
  const Theorem is = assume(eq(gram(o), identity(size)));
  const Theorems products = entries(is);
  Theorems found;
  Certificate back;
  for (int i = 0; i < size; ++i)
    for (int l = 0; l < size; ++l) {
      const Theorem& entry_is = products[std::size_t(i * size + l)];
      found.push_back(linear(entry_is.conclusion(), {along(i, l), along(i, i), along(l, l)}));
      back.equations.push_back({v[std::size_t(i)] * v[std::size_t(l)], entry_is});
    }
  book.show(where, "",
            plane ? "A matrix that keeps all lengths in the plane is orthogonal,"
                  : "In space, too, a matrix that keeps all lengths is orthogonal,",
            restate(is.conclusion(), both(found)));
  book.show(
      where + "_keeps", "", "and an orthogonal one keeps them;",
      restate(kept, arithmetic(eq(entry(kept.arg(0), 0, 0), entry(kept.arg(1), 0, 0)), back)));
  const Theorem squared =
      linear(eq(power(d, 2), 1),
             {rewritten(products, equation(power(d, 2), determinant(kernel::entries(gram(o)))))});
  const Theorem other = assume(neq(d, 1));
  Certificate c;  // (1 - d)(-1 - d) = d^2 - 1
  c.multipliers = {other};
  c.equations = {{-1, squared}};
  book.show(where + "_determinant", "", "its determinant is 1 or -1:",
            tautology(logic_or({eq(d, 1), eq(d, -1)}),
                      {discharge(other.conclusion(), arithmetic(eq(d, -1), c))}));
  return is;
}

/// An orthogonal matrix of the plane is a rotation, after a reflection where its determinant is -1.
void in_the_plane(Book& book, const Theorem& is) {
  const Expr o = matrix_of_names(2);
  const Expr p = entry(o, 0, 0), q = entry(o, 0, 1), r = entry(o, 1, 0), s = entry(o, 1, 1);
  const Theorems products = entries(is);
  const Theorem unit = linear(eq(power(r, 2), 1 - power(p, 2)), {products[0]});
  const Theorem other = assume(neq(p, -1));
  const Expr t = r / (1 + p), angle = atan(t), root = sqrt(1 + power(t, 2));
  const Theorem one_more = positive(1 + power(t, 2));
  const Theorem p_more = tautology(
      neq(1 + p, 0), {other, discharge(eq(1 + p, 0), linear(eq(p, -1), {assume(eq(1 + p, 0))}))});
  know(p_more);
  const Theorems half{use("cos atan", {{x, t}}), use("sin atan", {{x, t}}), root_squared(one_more)};
  const auto of_angle = [&](Expr l, Expr value) {
    return equation(l, value, angles({l}, {angle}, false) + half + Theorems{unit},
                    {positive(root, {one_more}), one_more, p_more});
  };
  const Theorem cosine = of_angle(cos(2 * angle), p), sine = of_angle(sin(2 * angle), r);
  const auto turned_by = [&](Expr a) {
    return entries(instantiate(book["ball.lambda"], {{x, a}}));
  };
  const Theorems mirror = entries(book["ball.P_2"]);
  const Theorem at_end = assume(eq(p, -1)), moved = assume(neq(r, 0));
  Certificate c;
  c.multipliers = {moved};
  c.equations = {{-1, unit}, {p - 1, at_end}};
  const Theorem none =
      tautology(eq(r, 0), {discharge(moved.conclusion(), arithmetic(eq(r, 0), c))});
  for (const int sign : {1, -1}) {
    const Theorem d = assume(eq(det(o), sign));
    const Theorem value = restate(eq(p * s - q * r, sign), d);
    Certificate of_s;  // sign p - s = p (p s - q r) - s (p^2 + r^2)
    of_s.equations = {{-s, products[0]}, {p, value}, {r, products[1]}};
    Certificate of_q;
    of_q.equations = {{-q, products[0]}, {-r, value}, {p, products[1]}};
    const Theorem s_is = arithmetic(eq(s, Expr(sign) * p), of_s);
    const Theorem q_is = arithmetic(eq(q, Expr(-sign) * r), of_q);
    const auto form = [&](Expr a) {
      const Expr turn = fun("lambda", {a});
      return sign == 1 ? turn : times(turn, fun("P_2", {}));
    };
    const std::string name = sign == 1 ? "rotation" : "reflection";
    book.show(name, "",
              sign == 1 ? "With determinant 1 it is a rotation of the plane,"
                        : "With determinant -1 it is a rotation after a reflection,",
              matrix_equation(o, form(2 * angle),
                              turned_by(2 * angle) + mirror + Theorems{cosine, sine, s_is, q_is}));
    book.show(
        name + "_half", "", "or half a turn,",
        matrix_equation(o, form(pi()),
                        turned_by(pi()) + mirror +
                            Theorems{axiom("cos pi"), axiom("sin pi"), s_is, q_is, at_end, none}));
  }
}

/// In space: with determinant 1 there is an axis, with -1 there is one after the reflection P_3.
void in_space(Book& book, const Theorem& is) {
  const Expr o = matrix_of_names(3), d = det(o);
  Exprs less_1, without;
  const Exprs names = kernel::entries(o), products = kernel::entries(gram(o));
  for (std::size_t i = 0; i < 9; ++i) {
    less_1.push_back(i % 4 == 0 ? names[i] - 1 : names[i]);
    without.push_back(-names[3 * (i % 3) + i / 3] + products[i]);
  }
  const Expr fixed = det(matrix(3, less_1));
  const Theorem product =
      rewritten(entries(is) + Theorems{assume(eq(d, 1))},
                equation(d * fixed, determinant(without)));  // det(O^T) det(O - 1)
  book.show("axis", "",
            "With determinant 1 it has the eigenvalue 1, so that an axis stays as it is:",
            linear(eq(fixed, 0), {product}));
  // O is the matrix of its own cofactors, so O - O^T turns with it.
  const Theorems columns = entries(is);
  Theorems own_cofactors;
  for (int i = 0; i < 3; ++i)
    for (int l = 0; l < 3; ++l) {
      Certificate c;
      c.equations = {{-entry(o, i, l), assume(eq(d, 1))}};
      for (int m = 0; m < 3; ++m)
        c.equations.push_back({cofactor(o, i, m), columns[std::size_t(3 * l + m)]});
      own_cofactors.push_back(arithmetic(eq(entry(o, i, l), cofactor(o, i, l)), c));
    }
  const Expr along = column({names[7] - names[5], names[2] - names[6], names[3] - names[1]});
  Theorems rows;
  for (int i = 0; i < 3; ++i)
    rows.push_back(linear(eq(entry(times(o, along), i, 0), entry(along, i, 0)), own_cofactors));
  book.show("axis_along", "", "which is this one, unless all three differences are 0:",
            restate(eq(times(o, along), along), both(rows)));
  const Theorem mirror = define("P_3", {}, matrix(3, {1, 0, 0, 0, 1, 0, 0, 0, -1}));
  const Expr P_3 = fun("P_3", {});
  book.show("P_3", "", "The reflection of the third axis:", mirror);
  const Expr mirrored = times(o, P_3);
  Theorems mirrored_products;
  for (int i = 0; i < 3; ++i)
    for (int l = 0; l < 3; ++l) {
      const Expr dot = entry(gram(o), i, l);
      const int sign = (i == 2) == (l == 2) ? 1 : -1;
      mirrored_products.push_back(
          chain(equation(entry(gram(mirrored), i, l), Expr(sign) * dot, entries(mirror)),
                linear(eq(Expr(sign) * dot, entry(identity(3), i, l)),
                       {columns[std::size_t(3 * i + l)]})));
    }
  book.show("space_reflection", "",
            "It changes the sign of a determinant, and applied twice it changes nothing, so that "
            "with determinant -1 the matrix is this reflection and then a rotation:",
            both({equation(det(mirrored), -d, entries(mirror)),
                  matrix_equation(o, times(mirrored, P_3), entries(mirror)),
                  restate(eq(gram(mirrored), identity(3)), both(mirrored_products))}));
  const auto turn = [&](const std::string& name, const std::string& label, const Exprs& m) {
    const Theorem t = define(name, {x}, matrix(3, m), 0);
    book.show(name, label, "A rotation about an axis:", t);
    return t;
  };
  const Theorem first_axis =
      turn("lambda_1", "eq:lambda-1", {1, 0, 0, 0, cos(x), -sin(x), 0, sin(x), cos(x)});
  const Theorem second_axis =
      turn("lambda_2", "eq:lambda-2", {cos(x), 0, sin(x), 0, 1, 0, -sin(x), 0, cos(x)});
  const Theorems gamma = entries(book["ball.Gamma_theta"]) + entries(mirror);
  const auto collision = [&](const std::string& name, const std::string& id, const Theorem& turn_is,
                             Expr angle) {
    const Expr l = book[id].conclusion().arg(0);
    book.show(
        name, "Lam-GAM", "A collision is a rotation after a reflection:",
        matrix_equation(
            l, times(substitute(turn_is.conclusion().arg(0), {{x, angle}}), P_3),
            entries(book[id]) + gamma + entries(instantiate(turn_is, {{x, angle}})) +
                Theorems{use("cos minus", {{x, theta()}}), use("sin minus", {{x, theta()}})}));
  };
  collision("Gamma_A", "cycle.Gamma_A", second_axis, -theta());
  collision("Gamma_B", "cycle.Gamma_B", first_axis, theta());
}
/// A sum of cofactors of equations, entry by entry of an equation l = r of 3x3 matrices.
Theorems by_entries(Expr l, Expr r, const std::function<void(Certificate&, int, int)>& cofactors) {
  Theorems out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Certificate c;
      cofactors(c, i, j);
      out.push_back(arithmetic(eq(entry(l, i, j), entry(r, i, j)), c));
    }
  return out;
}
const Theorem& at(const Theorems& of_matrix, int i, int l) {
  return of_matrix[std::size_t(3 * i + l)];
}

/// With determinant 1 it is lambda_3(phi) in a frame whose third axis it leaves as it is.
void about_an_axis(Book& book, const Theorem& is) {
  const Expr o = matrix_of_names(3), r = matrix_of_names(3, "r"), one = identity(3);
  const Expr third = column({entry(r, 0, 2), entry(r, 1, 2), entry(r, 2, 2)});
  const Theorems of_o = entries(is), of_r = entries(assume(eq(gram(r), one)));
  const Theorems fixed = entries(assume(eq(times(o, third), third)));
  const Expr d = det(r), s = times(times(transpose(r), o), r), frame = times(r, transpose(r));
  const auto kept = [](Expr m, const Theorems& of_a) {  // (A M)^T A M = M^T M
    return [m, of_a](Certificate& c, int i, int j) {
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          c.equations.push_back({entry(m, k, i) * entry(m, l, j), at(of_a, k, l)});
    };
  };
  Theorem squared = equation(power(d, 2), determinant(kernel::entries(gram(r))));
  squared = linear(eq(power(d, 2), 1), {rewritten(of_r, squared)});
  // d R = cofactors, and d^2 = 1.
  const Theorems of_frame = by_entries(frame, one, [&](Certificate& c, int i, int j) {
    c.equations.push_back({entry(one, i, j) - entry(frame, i, j), squared});
    for (int k = 0; k < 3; ++k)
      for (int m = 0; m < 3; ++m)
        c.equations.push_back({d * entry(r, i, k) * cofactor(r, j, m), at(of_r, k, m)});
  });
  const Theorems of_product = by_entries(gram(times(o, r)), gram(r), kept(r, of_o));
  const Theorems of_s = by_entries(gram(s), gram(times(o, r)), kept(times(o, r), of_frame));
  // The third column and the third row of S = R^T O R are those of 1.
  Theorems column_3, row_3;
  for (int i = 0; i < 3; ++i) {
    Certificate in_column, in_row;
    in_column.equations = {{1, at(of_r, i, 2)}};
    in_row.equations = {{1, at(of_r, 2, i)}};
    for (int l = 0; l < 3; ++l) {
      in_column.equations.push_back({entry(r, l, i), fixed[std::size_t(l)]});
      for (int k = 0; k < 3; ++k) {
        in_row.equations.push_back({-entry(r, l, i) * entry(o, k, l), fixed[std::size_t(k)]});
        in_row.equations.push_back({entry(r, l, i) * entry(r, k, 2), at(of_o, l, k)});
      }
    }
    column_3.push_back(arithmetic(eq(entry(s, i, 2), entry(one, i, 2)), in_column));
    row_3.push_back(arithmetic(eq(entry(s, 2, i), entry(one, 2, i)), in_row));
  }
  // So the rest of S is orthogonal with determinant 1: a rotation of the plane.
  const auto s_ = [&](int i, int l) { return entry(s, i, l); };
  const Expr block = matrix(2, {s_(0, 0), s_(0, 1), s_(1, 0), s_(1, 1)});
  Theorems products;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      Certificate c;
      c.equations = {{1, at(of_s, i, j)},
                     {1, at(of_product, i, j)},
                     {1, at(of_r, i, j)},
                     {-s_(2, j), row_3[std::size_t(i)]}};
      products.push_back(arithmetic(eq(entry(gram(block), i, j), entry(identity(2), i, j)), c));
    }
  Certificate c;
  c.equations = {{1, squared}, {power(d, 2), assume(eq(det(o), 1))}};
  for (int i = 0; i < 3; ++i) c.equations.push_back({-cofactor(s, 2, i), row_3[std::size_t(i)]});
  const Theorem orthogonal_block = restate(eq(gram(block), identity(2)), both(products));
  const Theorem determinant_1 = arithmetic(eq(det(block), 1), c);
  Substitution terms;
  for (int i = 0; i < 2; ++i)
    for (int l = 0; l < 2; ++l) terms[entry(matrix_of_names(2), i, l)] = s_(i, l);
  const Expr m = matrix_of_names(3, "m");
  const Theorems named = entries(assume(eq(s, m)));
  const auto in_case = [&](const std::string& id, Expr angle, Expr given) {
    const Theorem t = cut(orthogonal_block, cut(determinant_1, instantiate(book[id], terms)));
    const Theorems turned_by = entries(instantiate(book["rotation.lambda_3"], {{x, angle}}));
    const Theorems plane = entries(instantiate(book["ball.lambda"], {{x, angle}}));
    const Theorems values = entries(t);
    const Expr turn = lambda_3(angle);
    const Theorems of_turn = by_entries(s, turn, [&](Certificate& e, int i, int l) {
      if (i == 2)
        e.equations = {{1, row_3[std::size_t(l)]}};
      else if (l == 2)
        e.equations = {{1, column_3[std::size_t(i)]}};
      else
        e.equations = {{1, values[std::size_t(2 * i + l)]}, {1, plane[std::size_t(2 * i + l)]}};
      e.equations.push_back({-1, at(turned_by, i, l)});
    });
    const Expr there = times(times(r, turn), transpose(r));
    const Theorems whole = by_entries(o, there, [&](Certificate& e, int i, int j) {
      for (int k = 0; k < 3; ++k) {
        e.equations.push_back({-entry(o, i, k), at(of_frame, k, j)});
        for (int l = 0; l < 3; ++l) {
          e.equations.push_back({entry(r, i, k) * entry(r, j, l), at(of_turn, k, l)});
          e.equations.push_back({-entry(o, k, l) * entry(frame, l, j), at(of_frame, i, k)});
        }
      }
    });
    const Theorem turned_back = restate(eq(o, there), both(whole));
    return rewritten(named, discharge(substitute(given, terms), turned_back));
  };
  const Expr first = entry(matrix_of_names(2), 0, 0);
  const Theorem none = assume(eq(1 + entry(m, 0, 0), 0));
  know(tautology(logic_not(none.conclusion()),
                 {assume(neq(entry(m, 0, 0), -1)),
                  discharge(none.conclusion(), linear(eq(entry(m, 0, 0), -1), {none}))}));
  const Expr angle = 2 * atan(s_(1, 0) / (1 + s_(0, 0)));
  const Exprs read{is.conclusion(), eq(det(o), 1), eq(gram(r), one), eq(times(o, third), third),
                   eq(s, m)};
  book.show("lambda_n", "eq:lambda-n",
            "In a frame R whose third axis stays as it is, it is a rotation about that axis,",
            under(read, both({in_case("orthogonal.rotation", angle, neq(first, -1)),
                              in_case("orthogonal.rotation_half", pi(), eq(first, -1))})));
  const Expr turned_by = times(r, lambda_3(x)),
             image = times(times(turned_by, transpose(r)), third);
  const Theorems turn_columns = entries(book["rotation.lambda_3"]);
  Theorems rows;
  for (int i = 0; i < 3; ++i) {
    Certificate e;
    for (int l = 0; l < 3; ++l) {
      e.equations.push_back({entry(turned_by, i, l), at(of_r, l, 2)});
      e.equations.push_back({entry(r, i, l), at(turn_columns, l, 2)});
    }
    rows.push_back(arithmetic(eq(entry(image, i, 0), entry(third, i, 0)), e));
  }
  book.show("lambda_n_keeps", "", "and any such rotation keeps the third axis of its frame:",
            restate(eq(image, third), both(rows)));
}
}  // namespace

void orthogonal(Book& book) {
  book.chapter("orthogonal", "Orthogonal matrices", {});
  in_the_plane(book, orthogonal(book, 2));
  const Theorem is = orthogonal(book, 3);
  in_space(book, is);
  about_an_axis(book, is);
}
}  // namespace derivation
