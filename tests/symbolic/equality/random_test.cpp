// SPDX-License-Identifier: GPL-2.0-or-later
// Random expressions against rewritings that change nothing, and against such that do.
#include <random>

#include <catch2/catch.hpp>

#include "equality/bounded.hpp"

using namespace magicmass::equality;

namespace {

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}

  long between(long low, long high) {
    return low + static_cast<long>(engine_() % static_cast<unsigned long>(high - low + 1));
  }
  template <typename Table>
  const std::string& one_of(const Table& table) {
    return table[static_cast<std::size_t>(between(0, static_cast<long>(table.size()) - 1))];
  }

  std::string expression(int depth, bool constant) {
    if (depth == 0) {
      if (between(0, 2) == 0) return std::to_string(between(1, 5));
      if (constant) return one_of(constants_);
      return one_of(symbols_);
    }
    const auto inner = [&] { return "(" + expression(depth - 1, constant) + ")"; };
    switch (between(0, 6)) {
      case 0:
      case 1:
        return inner() + "+" + inner();
      case 2:
        return inner() + "-" + inner();
      case 3:
        return inner() + "*" + inner();
      case 4:
        return inner() + "/" + inner();
      case 5:
        return inner() + "^2";
      default:
        return one_of(functions_) + inner();
    }
  }

  // The same value wherever it is defined, the same places where it is defined.
  std::string rewritten(const std::string& typed) {
    const std::string x = "(" + typed + ")";
    switch (between(0, 7)) {
      case 0:
        return x + "+0";
      case 1:
        return "3*" + x + "/3";
      case 2:
        return x + "*(sin(x)^2+cos(x)^2)";
      case 3:
        return "(" + x + "*(1+alpha)-" + x + ")/alpha";
      case 4:
        return x + "+sqrt(alpha)*sqrt(2+alpha)-sqrt(alpha*(2+alpha))";
      case 5:
        return x + "*(sqrt(2)-1)*(sqrt(2)+1)";
      case 6:
        return x + "+2*cos(pi/5)-(1+sqrt(5))/2";
      default:
        return x + "+cos(psi/2)*(1+alpha)-1";
    }
  }

private:
  std::mt19937 engine_;
  std::vector<std::string> symbols_{"alpha", "x", "e"};
  std::vector<std::string> constants_{"sqrt(2)", "cos(pi/5)", "sqrt(3)", "pi", "sin(pi/8)"};
  std::vector<std::string> functions_{"sqrt", "sin", "cos", "atan", "abs", "cbrt", "tan", "acos"};
};

std::optional<Verdict> verdict_on(const std::string& lhs, const std::string& rhs) {
  try {
    return answer_within({lhs, rhs, {}});
  } catch (const Refused&) {  // not defined anywhere, or a division by zero that is seen at once
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("rewriting never makes an expression different, perturbing never equal", "[check]") {
  Random random(20240611);
  int equal = 0;
  int different = 0;
  for (int i = 0; i < 120; ++i) {
    const std::string typed = random.expression(static_cast<int>(random.between(1, 3)), i % 2 == 0);
    const std::string same = random.rewritten(typed);
    INFO(typed << " and " << same);
    if (const auto verdict = verdict_on(typed, same)) {
      if (verdict->counterexample)
        INFO(verdict->counterexample->left << " and " << verdict->counterexample->right);
      CHECK(verdict->answer != Answer::different);
      equal += verdict->answer == Answer::equal ? 1 : 0;
    }
    const std::string wrong = same + "+10^-" + std::to_string(random.between(1, 60));
    INFO("perturbed: " << wrong);
    if (const auto verdict = verdict_on(typed, wrong)) {
      CHECK(verdict->answer != Answer::equal);
      different += verdict->answer == Answer::different ? 1 : 0;
    }
  }
  CHECK(equal > 50);
  CHECK(different > 70);
}
