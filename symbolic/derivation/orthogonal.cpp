// SPDX-License-Identifier: GPL-2.0-or-later
// Appendix app:orthogonal, first part: rotations and reflections, and why what keeps lengths is one of them.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::matrix;
using GiNaC::Pi;

namespace {

// A linear transformation, its entries unknown, and what follows once it keeps every length.
struct Transformation {
  matrix entries;
  std::map<std::pair<unsigned, unsigned>, Theorem> columns;  // scalar products of its columns
  Theorem gram;                                              // O^T O = 1
};

ex dot(const ex& x, const ex& y) {
  ex sum = 0;
  for (std::size_t i = 0; i < x.nops(); ++i) sum += x.op(i) * y.op(i);
  return sum;
}

matrix named_matrix(const std::string& name, unsigned rows, unsigned columns) {
  matrix result(rows, columns);
  for (unsigned i = 0; i < rows; ++i)
    for (unsigned j = 0; j < columns; ++j)
      result(i, j) =
          symbol(name + "_" + std::to_string(i + 1) + (columns == 1 ? "" : std::to_string(j + 1)));
  return result;
}

// lambda(phi) in the plane of the two axes that follow axis i, the third kept.
matrix turn_about(unsigned i, const ex& plane) {
  matrix result = ex_to<matrix>(unit(3));
  const unsigned axes[] = {(i + 1) % 3, (i + 2) % 3};
  for (unsigned row = 0; row < 2; ++row)
    for (unsigned column = 0; column < 2; ++column)
      result(axes[row], axes[column]) = plane.op(2 * row + column);
  return result;
}

void rotations(Kernel& kernel, const Paper& paper) {
  const ex phi = symbol("phi"), more = symbol("phi_prime"), n = symbol("n"), t = symbol("t");
  const matrix derived{{kernel.simplified(cos(phi)), kernel.simplified(cos(phi + Pi / 2))},
                       {kernel.simplified(sin(phi)), kernel.simplified(sin(phi + Pi / 2))}};
  kernel.definition({.id = "orthogonal.lambda",
                     .statement = {symbol("lambda"), derived},
                     .words = "its columns: where the unit vectors at angles 0 and pi/2 go"});
  const auto at = [&](const ex& turn, const ex& angle) { return turn.subs(phi == angle).evalm(); };
  kernel.identity({.id = "orthogonal.lambda_turns",
                   .statement = {(derived * matrix{{cos(t)}, {sin(t)}}).evalm(),
                                 matrix{{cos(t + phi)}, {sin(t + phi)}}},
                   .words = "and so every direction is turned by phi",
                   .shown_lhs = "lambda(phi) [[cos(t)], [sin(t)]]"});
  const auto is_rotation = [&](const std::string& name, const std::string& label, const ex& turn) {
    const std::string id = "orthogonal." + name;
    kernel.identity({.id = id + "_paper",
                     .statement = paper.at(label),
                     .words = "as the paper writes it",
                     .label = label});
    kernel.identity(
        {.id = id + "_orthogonal",
         .statement = {(transpose(turn) * turn).evalm(), unit(ex_to<matrix>(turn).rows())},
         .words = "it keeps lengths",
         .shown_lhs = name + "(phi)^T " + name + "(phi)",
         .shown_rhs = "1"});
    kernel.identity({.id = id + "_determinant",
                     .statement = {determinant(turn), 1},
                     .words = "its determinant",
                     .shown_lhs = "det " + name + "(phi)"});
    kernel.identity({.id = id + "_sum",
                     .statement = {(turn * at(turn, more)).evalm(), at(turn, phi + more)},
                     .words = "one turn after another: the angles add",
                     .shown_lhs = name + "(phi) " + name + "(phi_prime)",
                     .shown_rhs = name + "(phi + phi_prime)"});
  };
  is_rotation("lambda", "app:orthogonal, lambda", derived);
  for (unsigned i = 0; i < 3; ++i) {
    const std::string name = "lambda_" + std::to_string(i + 1);
    const matrix turn = turn_about(i, derived);
    const Theorem named =
        kernel.definition({.id = "orthogonal." + name,
                           .statement = {symbol(name), turn},
                           .words = "lambda(phi) in the plane of the two axes that follow"});
    is_rotation(name, "eq:lambda-" + std::to_string(i + 1), turn);
    kernel.matrix_power({.id = "orthogonal." + name + "_power",
                         .statement = {pow(symbol(name), n), at(turn, n * phi)},
                         .words = "by induction: n equal turns",
                         .label = i == 2 ? "app:lam-n" : "",
                         .indices = {{"n", 0}},
                         .shown_lhs = name + "(phi)^n",
                         .shown_rhs = name + "(n*phi)"},
                        named, n);
    matrix P = ex_to<matrix>(unit(3));
    P(i, i) = -1;
    const std::string reflection = "P_" + std::to_string(i + 1);
    kernel.identity({.id = "orthogonal." + reflection,
                     .statement = {(P.transpose() * ex(P)).evalm(), unit(3)},
                     .words = "a reflection keeps lengths too",
                     .label = "app:orthogonal",
                     .shown_lhs = reflection + "^T " + reflection,
                     .shown_rhs = "1"});
    kernel.identity({.id = "orthogonal." + reflection + "_determinant",
                     .statement = {P.determinant(), -1},
                     .words = "and its determinant is -1",
                     .shown_lhs = "det " + reflection});
  }
}

Transformation length_keeping(Kernel& kernel, unsigned size) {
  const std::string dimension = std::to_string(size), id = "orthogonal.d" + dimension;
  const matrix O = named_matrix("o" + dimension, size, size);
  const matrix x = named_matrix("x", size, 1), y = named_matrix("y", size, 1);
  const auto image = [&](const ex& of) { return (ex(O) * of).evalm(); };
  const Theorem length = kernel.hypothesis({.id = id + "_length",
                                            .statement = {dot(image(x), image(x)), dot(x, x)},
                                            .words = "O keeps the length of every vector x",
                                            .shown_lhs = "|O x|^2",
                                            .shown_rhs = "|x|^2"});
  std::map<std::string, Theorem> known{{to_text(x), length}};  // by vector
  const auto length_of = [&](const ex& of) {
    const std::string shown = to_text(of);
    if (const auto found = known.find(shown); found != known.end()) return found->second;
    Kernel::Values values;
    for (unsigned i = 0; i < size; ++i) values.emplace_back(x(i, 0), of.op(i));
    const Theorem here = kernel.instance({.id = id + "_length_" + std::to_string(known.size()),
                                          .statement = {dot(image(of), image(of)), dot(of, of)},
                                          .words = "and so that of " + shown},
                                         length, values);
    known.emplace(shown, here);
    return here;
  };
  const auto scalar = [&](const std::string& name, const ex& u, const ex& v, const char* words) {
    return kernel.consequence({.id = id + "_scalar" + name,
                               .statement = {dot(image(u), image(v)), dot(u, v)},
                               .words = words,
                               .label = "app:orthogonal"},
                              {{length_of((u + v).evalm()), 1 / ex(2)},
                               {length_of(u), -1 / ex(2)},
                               {length_of(v), -1 / ex(2)}});
  };
  scalar("", x, y, "2 x.y = |x + y|^2 - |x|^2 - |y|^2: so scalar products are kept as well");

  std::map<std::pair<unsigned, unsigned>, Theorem> columns;
  std::vector<Theorem> equations;
  for (unsigned i = 0; i < size; ++i)
    for (unsigned j = i; j < size; ++j) {
      const std::string name = "_" + std::to_string(i + 1) + std::to_string(j + 1);
      const ex e_i = GiNaC::sub_matrix(ex_to<matrix>(unit(size)), 0, size, i, 1);
      const ex e_j = GiNaC::sub_matrix(ex_to<matrix>(unit(size)), 0, size, j, 1);
      const Theorem product =
          i == j ? length_of(e_i) : scalar(name, e_i, e_j, "of two unit vectors: columns of O");
      columns.emplace(std::pair{i, j}, product);
      equations.push_back(product);
    }
  const Theorem gram = kernel.rewriting({.id = id + "_gram",
                                         .statement = {(O.transpose() * ex(O)).evalm(), unit(size)},
                                         .words = "O is orthogonal: its transpose is its inverse",
                                         .label = "app:orthogonal",
                                         .shown_lhs = "O^T O",
                                         .shown_rhs = "1"},
                                        equations);
  // det(O)^2 = det(O^T O), whose entries are known.
  matrix product(size, size);
  for (unsigned i = 0; i < size; ++i)
    for (unsigned j = 0; j < size; ++j)
      product(i, j) = symbol("g_" + std::to_string(i) + std::to_string(j));
  GiNaC::exmap entries;
  for (unsigned i = 0; i < size; ++i)
    for (unsigned j = 0; j < size; ++j)
      entries[product(i, j)] = columns.at({std::min(i, j), std::max(i, j)}).lhs();
  const ex det = determinant(O);
  const Theorem of_product =
      kernel.rewriting({.id = id + "_determinant_of_product",
                        .statement = {product.determinant().subs(entries), 1},
                        .words = "the determinant of O^T O",
                        .shown_lhs = "det(O^T O)"},
                       equations);
  kernel.consequence({.id = id + "_determinant",
                      .statement = {(det - 1) * (det + 1), 0},
                      .words = "det(O)^2 = det(O^T O) = 1: the determinant is +1 or -1",
                      .label = "app:orthogonal",
                      .shown_lhs = "(det O - 1)*(det O + 1)"},
                     {{of_product, 1}});
  return {O, columns, gram};
}

// In the plane: given the determinant, the second column follows from the first, and the first from an angle.
void plane(Kernel& kernel, const Transformation& O, const Paper& paper) {
  const ex p = O.entries(0, 0), q = O.entries(0, 1), r = O.entries(1, 0), s = O.entries(1, 1);
  const Theorem &first = O.columns.at({0, 0}), &across = O.columns.at({0, 1});
  const ex phi = symbol("phi_O");
  kernel.definition({.id = "orthogonal.angle",
                     .statement = {phi, 2 * atan(r / (1 + p))},
                     .words = "the angle of the first column (p, r), for p other than -1"});
  const ex scale = (1 + cos(phi)) / (2 * (1 + p));
  const Theorem cosine = kernel.consequence({.id = "orthogonal.angle_cosine",
                                             .statement = {cos(phi), p},
                                             .words = "its cosine, as p^2 + r^2 = 1"},
                                            {{first, -scale}});
  const Theorem sine = kernel.consequence(
      {.id = "orthogonal.angle_sine", .statement = {sin(phi), r}, .words = "and its sine"},
      {{first, -scale * r / (1 + p)}});
  const Theorem behind = kernel.hypothesis(
      {.id = "orthogonal.behind", .statement = {p, -1}, .words = "the one direction left out"});
  const Theorem square = kernel.consequence({.id = "orthogonal.behind_square",
                                             .statement = {pow(r, 2), 0},
                                             .words = "then r^2 = 1 - p^2 = 0"},
                                            {{first, 1}, {behind, 1 - p}});
  const Theorem zero = kernel.vanishing_square(
      {.id = "orthogonal.behind_zero", .statement = {r, 0}, .words = "so r = 0"}, square);
  for (const int sign : {1, -1}) {
    const std::string id = sign > 0 ? "orthogonal.turn" : "orthogonal.mirror";
    const std::string label = sign > 0 ? "app:orthogonal, det 1" : "app:orthogonal, det -1";
    const Theorem det = kernel.hypothesis({.id = id + "_determinant",
                                           .statement = {p * s - q * r, sign},
                                           .words = "one of the two cases",
                                           .shown_lhs = "det O"});
    const Theorem below =
        kernel.consequence({.id = id + "_s",
                            .statement = {s, sign * p},
                            .words = "p (p s - q r) + r (p q + r s) = s (p^2 + r^2)"},
                           {{det, p}, {across, r}, {first, -s}});
    const Theorem beside =
        kernel.consequence({.id = id + "_q",
                            .statement = {q, -sign * r},
                            .words = "p (p q + r s) - r (p s - q r) = q (p^2 + r^2)"},
                           {{across, p}, {det, -r}, {first, -q}});
    kernel.rewriting({.id = id,
                      .statement = paper.at(label),
                      .words = sign > 0 ? "O is a rotation" : "O is a rotation after a reflection",
                      .label = label,
                      .shown_rhs = sign > 0 ? "lambda(phi_O)" : "lambda(phi_O) P_2"},
                     {cosine, sine, below, beside});
    kernel.rewriting({.id = id + "_behind",
                      .statement = {ex(O.entries), paper.at(label).rhs().subs(phi == Pi)},
                      .words = "and where p = -1 the angle is pi",
                      .label = label,
                      .shown_rhs = sign > 0 ? "lambda(pi)" : "lambda(pi) P_2"},
                     {below, beside, zero, behind});
  }
}

// In space: det(O - 1) = 0, so some direction is kept. With G = O^T O, O^T det(O) = G adj(O).
void space(Kernel& kernel, const Transformation& O) {
  const matrix& entries = O.entries;
  const ex det = determinant(entries);
  const Theorem turn = kernel.hypothesis({.id = "orthogonal.space_determinant",
                                          .statement = {det, 1},
                                          .words = "a pure rotation",
                                          .shown_lhs = "det O"});
  Kernel::Combination combination{{turn, 1 - entries.trace()}};
  for (const auto& [at, product] : O.columns) {
    const auto adjoint = [&](unsigned i, unsigned j) {
      return det.diff(ex_to<GiNaC::symbol>(entries(j, i)));
    };
    const auto [i, j] = at;
    combination.emplace_back(product, i == j ? adjoint(i, i) : adjoint(i, j) + adjoint(j, i));
  }
  kernel.consequence({.id = "orthogonal.space_axis",
                      .statement = {determinant((ex(entries) - unit(3)).evalm()), 0},
                      .words = "O - 1 is singular: a rotation in space leaves an axis where it is",
                      .label = "app:orthogonal",
                      .shown_lhs = "det(O - 1)"},
                     combination);
}

}  // namespace

void orthogonal(Kernel& kernel, const Paper& paper) {
  rotations(kernel, paper);
  plane(kernel, length_keeping(kernel, 2), paper);
  space(kernel, length_keeping(kernel, 3));
}

}  // namespace magicmass::derivation
