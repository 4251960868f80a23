// Programs, held against exact results at just the doubles that they are given.
#include <cmath>
#include <limits>

#include <cln/real.h>

#include "answers/table.hpp"
#include "learn/terms.hpp"

namespace learn {
namespace {

using cln::cl_RA;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A constant's value, to many more bits than doubles down to 1e-300 have.
cl_RA value_of(Expr constant, const std::string& text) {
  return answers::with_place<std::runtime_error, InvalidInput>(
      text + ": ", [&] { return equality::enclosure(constant, 2048).low(); });
}

std::string text_of(double value) {
  if (std::isnan(value)) return "nan";
  return std::isfinite(value) ? answers::real_cell(value).text : "infinite";
}

const std::string next_to = "(above|below) (.*)";
/// "1/7", the nearest double; "above sqrt(5) - 2", the one after it.
double input(const Terms& terms, const std::string& text) {
  const Texts next = matched(text, next_to);
  const std::string exact = next.empty() ? text : next[2];
  const cl_RA value = value_of(terms.in_full(terms.content(exact)), exact);
  const double near = balls::nearest_double(value, value).value();  // subnormal, too
  return next.empty() ? near : std::nextafter(near, next[1] == "above" ? infinity : -infinity);
}

/// "8 ulp or 1e-15": how far a result may be off.
struct Within {
  double ulps = 0, absolute = 0;
  explicit Within(const std::string& text) {
    const std::string number = "([0-9.]+(?:e-?[0-9]+)?)";
    const Texts part = matched(text, number + " ulp(?: or " + number + ")?|" + number);
    if (part.empty()) throw InvalidInput(R"(within: allowed: "4 ulp", "1e-15", "4 ulp or 1e-15")");
    ulps = std::strtod(part[1].c_str(), nullptr);
    absolute = std::strtod((part[2] + part[3]).c_str(), nullptr);
  }
};

const std::string own_results = "solution_code";

struct Cases {
  Rows inputs = {};
  std::vector<std::vector<cl_RA>> expected = {};
};

Cases cases_of(const Exercise& e, const Run& run) {
  Cases cases;
  Exercise plain = e;
  plain.run = "";  // which depends on the case
  const Terms constants(plain);
  for (const Texts& one : e.cases) {
    Exercise at_case = e;
    at_case.symbols = e.inputs;
    Numbers& row = cases.inputs.emplace_back();
    for (std::size_t i = 0; i < one.size(); ++i) {
      row.push_back(input(constants, one[i]));
      at_case.values[e.inputs[i]] = notation::typed_text(Expr(balls::exact(row[i])));
      // The program takes a decimal for the nearest double, and a whole number where one is needed.
      replace_all(at_case.run, "{" + e.inputs[i] + "}", text_of(row[i]));
    }
    const Terms terms(at_case);
    std::vector<cl_RA>& expected = cases.expected.emplace_back();
    for (const std::string& output : e.outputs) {
      const Expr term = output == own_results ? Expr(0) : terms.stated(output);
      expected.push_back(value_of(terms.in_full(term), output));
    }
  }
  if (std::ranges::count(e.outputs, own_results) == 0) return cases;
  const Ran own = run(e, e.solution_code, cases.inputs);
  for (std::size_t i = 0; i < cases.inputs.size(); ++i)
    for (std::size_t k = 0; k < e.outputs.size(); ++k) {
      if (e.outputs[k] != own_results) continue;
      if (i >= own.rows.size() || k >= own.rows[i].size() || !std::isfinite(own.rows[i][k]))
        throw InvalidInput("solution_code gives no result: " + own.unread + own.stopped);
      cases.expected[i][k] = balls::exact(own.rows[i][k]);
    }
  return cases;
}

/// "At alpha = the double above 1/8, n = 3: "; a formula's value is no double.
std::string place(const Exercise& e, std::size_t which) {
  Texts parts;
  for (std::size_t i = 0; i < e.inputs.size(); ++i) {
    const std::string& at = e.cases[which][i];
    const bool is_next = !matched(at, next_to).empty();
    const auto q = is_next ? std::nullopt : notation::rational_value(notation::read_typed(at).term);
    const bool is_exact = q && balls::exact(cln::double_approx(*q)) == *q;
    const std::string nearest = is_next ? "the double " : "the double nearest to ";
    parts.push_back(e.inputs[i] + " = " + (is_exact ? "" : nearest) + at);
  }
  return "At " + answers::joined(parts) + ": ";
}

/// Where the results first differ from what is expected; "" where they do not.
std::string difference(const Exercise& e, const Cases& cases, const Rows& rows) {
  const Within within(e.within);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < e.outputs.size(); ++k) {
      const double got = rows[i].at(k), nearest = cln::double_approx(cases.expected[i].at(k));
      const double size = std::abs(nearest), ulp = std::nextafter(size, infinity) - size;
      double error = infinity;
      if (std::isfinite(got))
        error = cln::double_approx(cln::abs(balls::exact(got) - cases.expected[i][k]));
      if (error <= within.ulps * ulp || error <= within.absolute) continue;
      const cl_RA gap = error < 1e-6 * size ? balls::exact(error) : 0;
      const std::string off = within.ulps > 0 ? text_of(std::ceil(10 * error / ulp) / 10) + " ulp"
                                              : balls::decimal(gap, gap, 2).value();
      return place(e, i) + "your " + e.words[k] + " is " + text_of(got) + "; it should be " +
             text_of(nearest) +
             (error < 1e-6 * size ? ", which is " + off + " off; allowed: " + e.within + "." : ".");
    }
  return {};
}

}  // namespace

Judgement judge_code(const Exercise& e, const std::string& code, const Run& run) {
  if (!run) return {Mark::undecided, "Programs are judged by magicmass learn check alone."};
  const Cases cases = cases_of(e, run);
  Ran ran = run(e, code, cases.inputs);
  if (!ran.unread.empty()) return {Mark::unread, "Not compiled: " + ran.unread};
  const std::size_t done = std::min(ran.rows.size(), cases.inputs.size() - 1);
  const auto is_full = [&](const Numbers& row) { return row.size() == e.outputs.size(); };
  const bool all = ran.rows.size() == cases.inputs.size() && std::ranges::all_of(ran.rows, is_full);
  if (ran.stopped.empty() && !all) ran.stopped = "it gave too many or too few results";
  if (!ran.stopped.empty())
    return {Mark::wrong, place(e, done) + ran.stopped + (ran.stopped.ends_with('?') ? "" : ".")};
  const std::string different = difference(e, cases, ran.rows);
  if (different.empty()) return {Mark::right, "Right, in all cases."};
  const auto is_near = [absolute = Within(e.within).absolute](double x, double y) {
    return x == y || (std::isnan(x) && std::isnan(y)) ||
           std::abs(x - y) <= std::max(absolute, 1e-9 * std::abs(x));
  };
  const auto are_near = [&](auto& l, auto& r) { return std::ranges::equal(l, r, is_near); };
  const auto was_given = [&](const std::string& answer) {
    return std::ranges::equal(run(e, answer, cases.inputs).rows, ran.rows, are_near);
  };
  return mistake(e, was_given, different);
}

}  // namespace learn
