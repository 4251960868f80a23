// Verdicts on pairs that fell elsewhere, each family with a wrong neighbour; and whatever is called
// equal agrees at random points, far from those that were tried to decide it.
#include "equality/decide.hpp"

#include <algorithm>
#include <cstdlib>
#include <random>

#include "rows.hpp"

using namespace equality;

namespace {

/// Two typed expressions on a typed domain.
struct Pair {
  Pair(const std::string& one, const std::string& other, const std::string& conditions)
      : left(notation::read_typed(one).term), right(notation::read_typed(other).term) {
    std::vector<std::string> unused;
    domain = read_domain(conditions, notation::symbols_of(eq(left, right)), unused);
    verdict = decide(left, right, domain);
  }
  Expr left, right;
  Domain domain;
  Verdict verdict;
};
/// `wanted` may be "certified" or "not certified": equal, and whether the kernel proves it.
/// "different: x = 1": the counterexample. "equal: has no value at x = 1: why": one side alone.
std::string word_of(const std::string& left, const std::string& right, const std::string& domain,
                    const std::string& wanted) {
  try {
    const Verdict verdict = Pair(left, right, domain).verdict;
    std::string found = word(verdict.answer);
    if (verdict.answer == Answer::Equal && wanted.find("certified") != wanted.npos)
      found = verdict.theorem.empty() ? "not certified" : "certified";
    if (wanted.find(": ") == wanted.npos) return found;
    if (verdict.counterexample) return found + ": " + verdict.counterexample->point;
    const std::string note = verdict.notes.empty() ? "alone no gap" : verdict.notes[0];
    return found + ": " + note.substr(note.find("alone ") + 6);
  } catch (const kernel::Refused&) {
    return "no point";
  }
}

/// With terms for F and G.
std::string filled(const std::string& text, const std::string& f, const std::string& g) {
  std::string out;
  for (const char c : text)
    out += c == 'F' ? "(" + f + ")" : c == 'G' ? "(" + g + ")" : std::string(1, c);
  return out;
}
struct Writer {
  std::mt19937 random;

  int below(std::size_t n) { return int(random() % unsigned(n)); }
  template <class T>
  T one_of(const std::vector<T>& all) {
    return all[std::size_t(below(all.size()))];
  }
  /// Of the symbols x and n.
  std::string term(int depth) {
    if (depth == 0) return one_of<std::string>({"x", "n", "2", "3", "1/2", "pi", "x", "n"});
    const std::string f = term(depth - 1), g = term(depth - 1);
    const auto form = one_of<std::string>({"F+G", "F-G", "F*G", "F/G", "F^2", "sqrt(F)", "abs(F)",
                                           "exp(-F)", "log(F)", "atan(F)", "sin(F)", "cos(F)"});
    return filled(form, f, g);
  }
};

}  // namespace

TEST_CASE("Pairs have the verdict that mathematics gives them, a third on either side") {
  auto all = rows_of("symbolic/equality/pairs.tsv", 4);
  std::ranges::copy(rows_of("symbolic/equality/kinds.tsv", 4), std::back_inserter(all));
  REQUIRE(all.size() > 500);
  for (int k = 0; const auto& row : all) {
    CAPTURE(row);
    CHECK(word_of(row[0], row[1], row[2], row[3]) == row[3]);
    if (k++ % 3 == 0) CHECK(word_of(row[1], row[0], row[2], row[3]) == row[3]);
  }
}

TEST_CASE("What is called equal agrees at random points") {
  const int pairs = std::getenv("MAGICMASS_LONG") == nullptr ? 300 : 6'000;
  const auto identities = rows_of("symbolic/equality/identities.tsv", 2);
  Writer writer{std::mt19937(20261125)};
  int equal = 0;
  for (int i = 0; i < pairs; ++i) {
    const std::string f = writer.term(2), g = writer.term(1);
    const auto row = writer.one_of(identities);
    const std::string one = filled(row[0], f, g), other = filled(row[1], f, g);
    const auto domain = writer.one_of<std::string>(
        {"", "0 < x < 1", "x >= 2, n integer, n >= 1", "n integer, 0 <= x < 1.571"});
    CAPTURE(i, one, other, domain);
    std::optional<Pair> pair;
    try {
      pair.emplace(one, other, domain);
    } catch (const kernel::Refused&) {
      continue;
    }
    if (pair->verdict.answer != Answer::Equal) continue;
    ++equal;
    const bool at_whole = std::ranges::any_of(pair->verdict.conditions, [](const auto& condition) {
      return condition.ends_with(" integer");
    });
    for (int k = 0; k < 40; ++k) {
      Point point;
      for (const auto& [symbol, range] : pair->domain.ranges) {
        const int scale = writer.one_of<int>({1, 7, 1000});
        cln::cl_RA value = cln::cl_RA(writer.below(9000) - 3000) / scale;
        if (range.is_integer || at_whole) value = cln::floor1(value);
        if (range.contains(value)) point[symbol] = value;
      }
      if (point.size() < pair->domain.ranges.size()) continue;
      const auto a = value_at(point, pair->left).ball, b = value_at(point, pair->right).ball;
      CHECK_FALSE((a && b && (a->high() < b->low() || b->high() < a->low())));
    }
  }
  CHECK(equal > pairs / 10);
}
