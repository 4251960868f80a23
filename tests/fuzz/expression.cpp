// SPDX-License-Identifier: GPL-2.0-or-later
// What one types after `equal`: two sides and a domain, a line each. Sizes are bounded, and what is not small is not
// taken further than the comparison at points: proofs take as long as they take, and the program bounds their time.
#include <algorithm>
#include <sstream>

#include "equality/decide.hpp"
#include "equality/form.hpp"
#include "equality/parse.hpp"
#include "equality/typed_text.hpp"
#include "fuzz_target.hpp"

namespace {

using namespace magicmass;
using namespace magicmass::equality;

const Limits bounded{
    .characters = 300, .nesting = 12, .nodes = 40, .bits = 200, .exponent = 6, .symbols = {}};
constexpr std::size_t small = 9;  // nodes

struct FarEnough {};

Tree side(const std::string& typed) {
  Tree tree = parse(plain_text(typed), bounded);
  fuzz::require(symbols_of(parse(to_text(tree))) == symbols_of(tree), "a tree is not read back");
  for (const std::string& form : form_names()) what_lacks_form(tree, form);
  return tree;
}

void compare(const Tree& left, const Tree& right, const std::string& conditions) {
  std::set<std::string> symbols = symbols_of(left);
  collect_symbols(right, symbols);
  const Domain domain = parse_domain({conditions}, symbols, bounded);
  const bool proofs_too = std::max(left->size, right->size) <= small;
  const Verdict verdict = decide(left, right, domain, [&](const Verdict&) {
    if (!proofs_too) throw FarEnough();
  });
  if (identical(left, right))
    fuzz::require(verdict.answer != Answer::different, "a side differs from itself");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream lines(fuzz::text_of(data, size));
  std::string lhs, rhs, conditions;
  std::getline(lines, lhs);
  std::getline(lines, rhs);
  std::getline(lines, conditions);
  try {
    const Tree left = side(lhs);
    compare(left, rhs.empty() ? left : side(rhs), conditions);
  } catch (const NotAnExpression& refusal) {
    fuzz::require_one_line(refusal);
  } catch (const NoQuestion& refusal) {
    fuzz::require_one_line(refusal);
  } catch (const FarEnough&) {
  }
  return 0;
}
