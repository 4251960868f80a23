// What is emitted: DoubleDouble evaluators, templates over a tier and a number type; formulas
// as plain functions of any number type; what generated/manifest.json says of each.
#pragma once

#include "codegen/lower.hpp"

namespace codegen {
using Words = std::vector<std::string>;
constexpr std::size_t columns = 100;
/// Lines, broken at spaces to at most that many columns.
std::string broken(const std::string& lines);
/// A line of code and why it is there: behind it, or above it where both are wider than a line.
std::string commented(const std::string& line, const std::string& why);
std::string joined(const std::vector<std::string>& parts, const std::string& by);
std::string capital(std::string name);
/// Licence, "generated" line, what it is; then `#pragma once` and the includes.
std::string opening(const std::string& what, const std::vector<std::string>& includes);

/// The ids of theorems, by their conclusions.
using Ids = std::map<Expr, std::string>;

/// The ids of what cases are made of, each once, in order; theorems without an id are left out.
Words ids_of(const std::vector<Case>& cases, const Ids& ids);
/// A header, and what is said of it elsewhere.
struct Emitted {
  std::string path;  ///< evaluators/NAME.hpp, plain/FORM.hpp, exact/FORM.hpp
  std::string header;
  Words manifest;           ///< a JSON object a quantity
  std::string errors = {};  ///< of an evaluator: each node's, for a reader
};
/// A JSON object: name, form, header, labels, inputs, outputs, cases. `bounds`: of each case's
/// outputs, "a: 2^-73.6 |P|"; none: each operation is rounded.
std::string manifest_entry(const Quantity& q, const std::string& form, const std::string& header,
                           const Ids& ids, const std::vector<Words>& bounds = {});
std::string as_plain(const Program& p, int k);   ///< an exact node, as a T
std::string as_number(const Program& p, int k);  ///< any node, as an N
std::string right_side(const Program& p, const Node& n);
/// A node's formula, or "for a, b": whose it is a part of; of a result "".
std::string purpose(const Program& p, int k);
/// The line that both functions of an angle come from.
std::string sine_and_cosine(const Program& p, const Node& n);
/// "3 sums, 2 products, ..."
std::string operation_counts(const Program& p);
Emitted emit_evaluator(const Quantity& q, const Ids& ids = {});
/// Values that a theorem names, or used more than once, have a line; others stand where used.
class PlainText {
public:
  explicit PlainText(const Program& program);
  std::set<std::string> functions;  ///< of <cmath>, that were printed

  /// The node where it is used. How strongly an operation binds: 1 a sum, 2 a product, 3 a name.
  std::string use(int k, int binding = 1);
  /// What the node is, whether or not it has a line.
  std::string right_side(int k, int binding = 1);
  std::string lines();

private:
  const Program& p;
  std::vector<int> uses;

  bool has_line(int k) const;
  std::string call(const std::string& function, const std::string& x);
};
/// A quantity to be written as a function QUANTITY_FORM: closed, product, tangent; `exact`: over
/// any field, by rational theorems; `matrices`: each output is one. Its domain is that of the
/// narrow ranges, for numbers of doubles' precision and exponents, or better; for others as float
/// with ends of the same signs whose sizes are at most `most_in_float`, and at least one by it.
struct PlainForm {
  Quantity quantity;
  std::string form;
  double most_in_float = infinity;
};
/// All forms of one name in one header, with the outputs that are wanted (none named: all) and what
/// those need, and more code. Refused: an output that is nowhere; what may over- or underflow.
Emitted emit_plain(const std::vector<PlainForm>& forms, const Ids& ids,
                   const std::set<std::string>& wanted = {}, const std::string& more = "");
}  // namespace codegen
