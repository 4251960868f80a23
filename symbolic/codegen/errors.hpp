// Error analysis: each node's |computed - exact|, from the table of operations alone, as a form:
// a sum of constants times sizes of computed values.
#pragma once

#include <cmath>

#include "codegen/operations.hpp"
#include "codegen/program.hpp"

namespace codegen {
/// |v_1| |v_2| ... of nodes, in order; none: 1.
using Sizes = std::vector<int>;
/// The sum of constants times sizes; none: 0.
using Form = std::map<Sizes, double>;

Sizes joined(Sizes x, const Sizes& y);
/// f + k x |sizes|
void add(Form& f, const Form& x, double k = 1, const Sizes& sizes = {});

/// One term taken into others that are known to be as large, as it is or as parts of a sum in it.
struct Taking {
  struct Part {
    Sizes sizes;
    double by;
    Sizes into;
  };
  Sizes term;
  std::vector<Part> parts;
};
/// Which terms were taken, absorption by absorption.
using Plan = std::vector<std::vector<Taking>>;

/// Makes forms shorter. The first number type to be analysed makes the plan, all others replay it:
/// then one printed form serves all, and only its constants differ.
class Absorber {
public:
  Absorber(const Program& program, Plan& plan) : p(program), plan_(plan) {}
  Form absorbed(Form f);
  /// From now on |small| <= |large| is used of computed values.
  void know(int small, int large) { facts.push_back({small, large}); }
  static constexpr double small_size = 8;  ///< sizes up to that may become constants
  double most(int k) const { return p[k].range.size(); }
  /// f with the sizes that are known to be small as constants; `bounded`: with all of them.
  Form constant(const Form& f, double largest = small_size) const;
  double bounded(const Form& f) const { return constant(f, INFINITY)[{}]; }
  /// Whether |part| <= |whole|: equal, or by a fact, or as part of a sum of numbers of one sign, or
  /// as the difference of those.
  bool is_below(int part, int whole) const;

private:
  const Program& p;
  Plan& plan_;
  std::size_t at = 0;
  std::vector<std::pair<int, int>> facts;

  bool is_difference(int node, int x, int y) const;
  std::optional<double> share(const Sizes& x, const Sizes& y) const;
  const Sizes* taker(const Form& f, const Sizes& x, double k, const Sizes& but) const;
  std::optional<Taking> next(const Form& f) const;
  void take(Form& f, const Taking& t) const;
};

/// |node| as a constant times sizes: scales leave theirs, `spread` products are as their factors.
std::pair<Sizes, double> size_of(const Program& p, int node, const std::set<int>& spread);
/// "2^-73.6 |P| + 2^-143.5"
std::string in_words(const Program& p, const Form& f);
/// The form as C++: from leading parts and constants E[0], E[1], ..., which are appended.
std::string in_code(const Program& p, const Form& f, std::vector<double>& constants);
struct Analysis {
  /// Of each result: what its rounding test is given; above that a sign is certain; 0 of others.
  std::vector<Form> outputs;
  std::vector<std::string> steps;  ///< one line a node, for a reader
};
/// Refused: a bound not known where needed, a fact or a range not known of computed values.
Analysis analyse(const Program& p, const NumberType& type, Plan& plan);
}  // namespace codegen
