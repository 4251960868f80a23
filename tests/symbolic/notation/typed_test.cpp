// SPDX-License-Identifier: GPL-2.0-or-later
// What people type: how it is read, and what is refused because it has two readings.
#include "notation/typed.hpp"

#include "catch.hpp"
#include "refusal.hpp"

using namespace notation;

namespace {
std::string reading(const std::string& typed) {
  const Typed read = read_typed(typed);
  if (read.term.sort() != kernel::Sort::Matrix) return typed_text(read.term);
  std::string out;
  for (kernel::Expr e : kernel::entries(read.term))
    out += (out.empty() ? "" : "; ") + typed_text(e);
  return out;
}
std::string refused(const std::string& typed) {
  return refusal<kernel::Refused>([&] { reading(typed); });
}
}  // namespace

TEST_CASE("Plain text, Unicode and LaTeX are read alike") {
  const auto [typed, as] = GENERATE(table<std::string, std::string>({
      {"-x^2", "-x^2"},
      {"2^-3", "(1/2)^3"},
      {"2(2+alpha)", "2*(2 + alpha)"},
      {"2 alpha V", "2*alpha*V"},
      {"x/y/z", "x/(y*z)"},
      {"1/2 M_1 u_1^2", "M_1*u_1^2/2"},
      {"L/V sin(psi)", "L/V*sin(psi)"},
      {"M1*u1", "M_1*u_1"},
      {"M₁*u₁+aₜ", "M_1*u_1 + a_t"},
      {"c'_n + don't", "c'_n + don'*t"},
      {"c^{\\prime}_n*T_primes", "c'_n*T_primes"},
      {"V_{\\rm CM}", "V_CM"},
      {"V_{\\mathrm{CM}} + V_{\\text{CM}} + V_\\mathrm{CM}", "V_CM + V_CM + V_CM"},
      {"M_{A} + M_{α} + b_{N_B}", "M_A + M_alpha + b_N_B"},
      {"\\cos n\\psi", "cos(n*psi)"},
      {"cos 2 theta", "cos(2*theta)"},
      {"sin^2(x)", "sin(x)^2"},
      {"-1/2 M_1 u_1^2", "-M_1*u_1^2/2"},
      {"1/(1+x) [[1, x], [y, 2]]", "(1/(1 + x))*1; (1/(1 + x))*x; (1/(1 + x))*y; (1/(1 + x))*2"},
      {"log_10^2(x)", "(log(x)/log(10))^2"},
      {"log2(8)", "log(8)/log(2)"},
      {"(x-1)/(x+1) y", "(x - 1)/(x + 1)*y"},
      {"1/(1+x)^2 (y-1)", "(1/(1 + x)^2)*(y - 1)"},
      {"tg(x)*ctg(x) + arctg(x)", "sin(x)/cos(x)*(cos(x)/sin(x)) + atan(x)"},
      {"arcsinh(x)", "log(x + sqrt(x^2 + 1))"},
      {"\\operatorname{arctan}(x) + \\mathrm{sin} x", "atan(x) + sin(x)"},
      {"1/2 \\left(\\begin{array}{c|c} y & x \\\\ \\end{array}\\right)", "y/2; x/2"},
      {"\\left[\\begin{matrix} 1 & 2 \\\\ 3 & 4 \\end{matrix}\\right]", "1; 2; 3; 4"},
      {"|c-2|", "abs(c - 2)"},
      {"||x|-1|", "abs(abs(x) - 1)"},
      {"√2/2", "sqrt(2)/2"},
      {"½x²ⁿ", "x^(2*n)/2"},
      {"αV", "alpha*V"},
      {"\\sqrt[3]{x}", "root(x, 3)"},
      {"\\frac12 x", "x/2"},
      {"x**2", "x^2"},
      {"1E3", "1000"},
      {"0.1", "1/10"},
      {"\xef\xbb\xbfx", "x"},
      {"cos\u2061〖𝜓∕2〗 𝑉\u2062𝐋 ＋ 𝟏⁄2", "cos(psi/2)*V*L + 1/2"},
      {"\\begin{equation*}\\boxed{\\cfrac{x}{y}}\\end{equation*}", "x/y"},
      {"alpha^(1/3)", "alpha^(1/3)"},
      {"n(n+1)/2", "n*(n + 1)/2"},
      {"a - (b - c)", "a - (b - c)"},
      {"[[1, x], [y, 2]]", "1; x; y; 2"},
      {"[1, x; y, 2]", "1; x; y; 2"},
      {"(1, x; y, 2)", "1; x; y; 2"},
      {"1; x", "1; x"},
      {"\\frac{1}{1+\\alpha}\\begin{pmatrix} 1-\\alpha & 2 \\\\[4pt] 3 & 4\\end{pmatrix}",
       "(1/(1 + alpha))*(1 - alpha); (1/(1 + alpha))*2; (1/(1 + alpha))*3; (1/(1 + alpha))*4"},
  }));
  CHECK(reading(typed) == as);
}

TEST_CASE("What has two readings is refused with both, slips are named with their column") {
  const auto [typed, why] = GENERATE(table<std::string, std::string>({
      {"sin x^2", "write sin(x^...) or sin(x)^..."},
      {"sin x y", "write sin(x y...) or sin(x)y..."},
      {"cos nψ", "write cos(n psi...) or cos(n)psi..."},
      {"sin^-1(x)", "asin(x) for the inverse function"},
      {"2\\frac{19}{64}", "2 + 19/64 or 2*19/64"},
      {"2\\frac12", "2 + 1/2 or 2*1/2"},
      {"5e−3", "5E-3 for the number"},
      {"2½", "2+1/2 or 2*1/2"},
      {"log^-1(x)", "column 4: log^-1 has two readings: write 1/log(x)"},
      {"1/2(1+alpha)", "above or below the fraction line"},
      {"e^2-2e+1", "2E+1 for the number, 2*e+1"},
      {"0x1F", "a hexadecimal number?"},
      {"0,5", "column 2: unexpected comma; decimals are written 0.5"},
      {"a(n)", "a_n for a(n)"},
      {"f'(x)", "column 1: unknown function f'"},
      {"log_1(x)", "no logarithm to base 1"},
      {"log_2x(8)", "column 1: unknown function log_2x; write log(x)/log(b)"},
      {"log_0.5(x)", "column 1: unknown function log_0; write log(x)/log(b)"},
      {"log2 + 1", "column 1: log2: is log(2) meant?"},
      {"log([1, 2])", "column 4: log of a matrix"},
      {"log_sin(x)", "unknown function log_sin"},
      {"x sin_2(y)", "column 3: unknown function sin_2"},
      {"T_(m+1)", "column 3: an index is a name or a number"},
      {"T_{m+1}", "column 5: an index is a name or a number"},
      {"V_{\\mathrm{CM}", "column 3: the } for a { is missing"},
      {"", "the expression is empty"},
      {"(x", "column 1: the ) for this one is missing"},
      {"x)", "a ( is missing for this )"},
      {"3 4", "an operator is missing before 4"},
      {"x = 1", "without ="},
      {"1..2", "a second decimal point"},
      {"x\\foo", "unknown command \\foo"},
      {"x\\begin{pmatrix", "column 2: a } is missing for this \\begin"},
      {"\\begin}", "column 1: unknown environment"},
      {"\\begin{pmatrix} 1", "column 1: the ] for this one is missing"},
      {"\\begin{cases} x & y\\end{cases}", "column 1: unknown environment cases"},
      {"1 + SQRT(5)", "column 5: unknown function SQRT; is sqrt meant?"},
      {"2^10001", "an exponent with a number above 10000"},
      {"0^0", "a power of 0"},
      {"root(2, 0)", "column 1: division by zero"},
      {"[[1, 2], 3]", "a row is written [a, b, c]"},
      {"[1, [2; 3]]", "a matrix inside of a matrix"},
      {"1 + [1, 2]", "cannot be added"},
  }));
  CHECK_THAT(refused(typed), ContainsSubstring(why));
}

TEST_CASE("Sizes are bounded from both sides") {
  const auto nested = [](const std::string& open, int times, const std::string& close) {
    std::string out = "x";
    for (; times > 0; --times) out = open + out + close;
    return out;
  };
  CHECK(reading(nested("(", 199, ")")) == "x");
  for (const auto& [open, close] : {std::pair{"(", ")"}, {"√", ""}, {"x^", ""}})
    CHECK_THAT(refused(nested(open, 6000, close)), ContainsSubstring("nested more than 200 deep"));
  CHECK(reading(std::string(15000, '-') + "x") == "x");
  CHECK_THAT(refused(std::string(20001, '-') + "x"), ContainsSubstring("longer than 20000"));
  CHECK(reading("2^10000") == "2^10000");
}

TEST_CASE("A reading that was chosen is said") {
  CHECK(read_typed("1/2 M_1").notes.size() == 1);
  CHECK(read_typed("\\cos n\\psi").notes ==
        std::vector<std::string>{"cos n psi is read as cos(n psi)"});
  CHECK(read_typed("M1").notes == std::vector<std::string>{"M1 is read as M_1"});
  CHECK(typed_text(read_typed("2M2u2", {"M_2", "u_2"}).term) == "2*M_2*u_2");
  CHECK_THAT(read_typed("e^x").notes.at(0), ContainsSubstring("exp(x)"));
  CHECK_THAT(read_typed("1 - \\ln e").notes.at(0), ContainsSubstring("exp(x)"));
  CHECK(read_typed("e^2 + log(2)").notes.empty());
  CHECK(read_typed("i").notes == std::vector<std::string>{"i is read as a real number of its own"});
  const Typed apart = read_typed("2M_2u_2^2", {"M_2", "u_2"});
  CHECK(typed_text(apart.term) == "2*M_2*u_2^2");
  CHECK(apart.notes == std::vector<std::string>{"M_2u_2 is read as M_2 u_2"});
  CHECK(read_typed("xy + 2xy").notes ==
        std::vector<std::string>{"xy is read as one name; a product is written x*y"});
  CHECK(read_typed("cos(n*psi)*V_CM*Gamma*xy", {"xy"}).notes.empty());
  CHECK(alike("M", {"m"}).empty());
}

TEST_CASE("What is shown of a term is read back as the same term") {
  for (const std::string typed :
       {"a - (b - c)*2", "-(x + y)/z^2", "x^(n + 1)*abs(x)", "1/(2*x)", "(x + 1)^3/(y - 1)^2",
        "sqrt(2)/(1 + exp(-x))", "(-1)^n", "-x^2", "(1/2)^n", "log(x)/log(2)",
        "2*(x^y)^2/x^(y/2)/(x^y^z)^3*c_n'", "500000*x^y"}) {
    const std::string shown = reading(typed);
    CHECK(reading(shown) == shown);
  }
}

TEST_CASE("A column may have commas, in brackets, where one is asked for") {
  CHECK(read_equation("v = (1, 2)/3", {}, true).right.rows() == 2);
  CHECK_THROWS_WITH(read_equation("1, 2", {}, true), ContainsSubstring("written with semicolons"));
  CHECK_THAT(refused("(1, 2)/3"), ContainsSubstring("column 3: unexpected comma"));
}

TEST_CASE("Comparisons come in chains") {
  const std::vector<Comparison> read = read_comparisons("0 < alpha <= 1");
  REQUIRE(read.size() == 2);
  CHECK(read[1].relation == "<=");
  CHECK_THROWS_WITH(read_comparisons("alpha"), ContainsSubstring("a relation is missing"));
}
