// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/passes/turned_differences.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace magicmass::codegen {
namespace {

class Turning {
public:
  explicit Turning(const Program& program) : program_(program), uses_(use_counts(program)) {}

  Program run() {
    for (const Output& output : program_.outputs) {
      const int made = copied(output.node);
      result_.outputs.push_back({output.name, made, output.theorem});
    }
    return has_turned_ ? std::move(result_) : program_;
  }

private:
  const Node& node(int number) const { return program_.nodes[static_cast<std::size_t>(number)]; }
  bool is_negative(int number) const { return node(number).op == Op::negate; }

  bool is_difference(int number) const {
    const Node& sum = node(number);
    return sum.op == Op::add && sum.args.size() == 2 &&
           is_negative(sum.args[0]) != is_negative(sum.args[1]);
  }
  bool can_turn(int number) const {
    if (uses_[static_cast<std::size_t>(number)] != 1) return false;
    return is_difference(number) || (node(number).op == Op::multiply && turned_factor(number) >= 0);
  }
  // Which factor of a product, or -1.
  int turned_factor(int number) const {
    const std::vector<int>& factors = node(number).args;
    const auto found = std::find_if(factors.begin(), factors.end(),
                                    [this](int factor) { return can_turn(factor); });
    return found == factors.end() ? -1 : static_cast<int>(found - factors.begin());
  }

  int copied(int number) {
    const auto done = copies_.find(number);
    if (done != copies_.end()) return done->second;
    Node made = node(number);
    int copy = 0;
    if (made.op == Op::negate && is_negative(made.args[0]) &&
        !can_turn(node(made.args[0]).args[0])) {
      copy = copied(node(made.args[0]).args[0]);
      has_turned_ = true;
    } else if (made.op == Op::negate && can_turn(made.args[0])) {
      copy = turned(made.args[0]);
      has_turned_ = true;
      Node& named = result_.nodes[static_cast<std::size_t>(copy)];
      named.name = made.name;
      named.origin = made.origin;
    } else {
      for (int& argument : made.args) argument = copied(argument);
      copy = append(result_, made);
    }
    return copies_[number] = copy;
  }

  // A new node that is minus the old one, and so not what that one's name says.
  int turned(int number) {
    Node made = node(number);
    made.name.clear();
    made.origin.clear();
    if (made.op == Op::add) {
      const bool is_first_less = is_negative(made.args[0]);
      for (int& term : made.args) term = copied(is_negative(term) ? node(term).args[0] : term);
      if (!is_first_less) std::swap(made.args[0], made.args[1]);
      made.args[1] = append(result_, {.op = Op::negate, .args = {made.args[1]}});
    } else {
      const int at = turned_factor(number);
      for (int i = 0; int& factor : made.args) factor = i++ == at ? turned(factor) : copied(factor);
    }
    return append(result_, made);
  }

  const Program& program_;
  const std::vector<int> uses_;
  Program result_;
  std::map<int, int> copies_;
  bool has_turned_ = false;
};

}  // namespace

Program turned_differences(const Program& program) { return Turning(program).run(); }

}  // namespace magicmass::codegen
