// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace magicmass::render {

/// A formula as a tree, read from the kernel's text (proof/text.hpp) or from a side that a step shows instead
/// ("Gamma^T Gamma", "det Gamma", "R lambda_3(n*psi) R^T"). It is for showing: nothing is computed with it, and
/// nothing is left out, so that source() gives the text back.
struct Formula {
  /// What it is, and which members then mean something.
  enum class Kind {
    number,    ///< text
    name,      ///< text: alpha, V_CM, c', Gamma_A
    sum,       ///< parts, of which some are `negative`
    negative,  ///< minus parts[0]
    product,   ///< parts with * between them
    adjacent,  ///< parts side by side: matrices, det Gamma
    quotient,  ///< parts[0]/parts[1]
    power,     ///< parts[0]^parts[1]
    call,      ///< text(parts...): cos(psi), a(n - 1), sqrt(alpha), v_A(n; 1/2, e)
    matrix,    ///< parts row by row, `columns` to a row
    list,      ///< (parts, ...)
    absolute,  ///< |parts[0]|
    dot,       ///< parts[0] . parts[1], a scalar product; text is what stands between them
    entry,     ///< (parts[0])_text, an entry of a matrix or a column
    relation,  ///< parts with signs between them
    verbatim,  ///< text that could not be read
  };
  Kind kind = Kind::verbatim;           ///< which one
  std::string text = {};                ///< see Kind
  std::vector<Formula> parts = {};      ///< see Kind
  std::vector<std::string> signs = {};  ///< of a relation, one fewer than parts
  std::size_t columns = 0;              ///< of a matrix

  /// The same tree.
  friend bool operator==(const Formula&, const Formula&) = default;
};

/// Nothing where the text is not in the kernel's notation, or is nested too deeply to be one of its formulas.
std::optional<Formula> read_formula(std::string_view text);

/// The same with relations: "0 < psi <= pi".
std::optional<Formula> read_relation(std::string_view text);

/// A side of a step, `verbatim` where it cannot be read.
Formula formula(std::string_view text);

/// The two sides of a step.
Formula equation(std::string_view from, const std::string& relation, std::string_view to);

/// The text that a formula was read from.
std::string source(const Formula& formula);

/// sum(k, 0, m, T(k)), or sum(T(k'), 0, m) with the kernel's own index k', which is shown as k.
struct SumParts {
  Formula index;  ///< k
  Formula lower;  ///< 0
  Formula upper;  ///< m
  Formula term;   ///< T(k)
};
/// A finite sum in one of these notations.
bool is_sum_over_index(const Formula& formula);
/// Of a formula that is_sum_over_index.
SumParts sum_parts(const Formula& sum);

/// The x between two others, which is a cross product: n_A x n_B.
bool is_cross(const Formula& adjacent, const Formula& part);

/// An element of a sequence, as far as its look tells: a(n - 1), T(2*m), a(N_A), but not psi(alpha_k), lambda_3(psi).
bool is_element(const Formula& formula);

}  // namespace magicmass::render
