
#include "answers/commands.hpp"
#include "answers/derivation.hpp"
#include "answers/motion.hpp"
#include "derivation/book.hpp"

namespace answers {
namespace {

/// Phi_m for m > 1, whose roots are the primitive m-th roots of 1: the product of
/// (1 - x^(m/e))^mu(e) over the squarefree divisors e of m, as a series up to x^m.
Polynomial cyclotomic(int m) {
  std::vector<std::pair<int, int>> factors{{m, 1}};  // m/e, mu(e)
  for (int rest = m, p = 2; rest > 1; ++p) {
    if (rest % p != 0) continue;
    while (rest % p == 0) rest /= p;
    for (std::size_t i = factors.size(); i-- > 0;)
      factors.emplace_back(factors[i].first / p, -factors[i].second);
  }
  Polynomial phi(std::size_t(m) + 1, 0);
  phi[0] = 1;
  for (const auto& [power, mu] : factors) {
    const auto d = std::size_t(power);
    for (std::size_t i = d; mu < 0 && i < phi.size(); ++i) phi[i] = phi[i] + phi[i - d];
    for (std::size_t i = phi.size(); mu > 0 && i-- > d;) phi[i] = phi[i] - phi[i - d];
  }
  while (phi.back() == 0) phi.pop_back();
  return phi;
}
}  // namespace

// By ratios.* it is sec(2 pi/m) - 1, m = 4k + 2 or 4k + 4. z = e^(2 pi i/m) is a root of the
// cyclotomic polynomial, which is irreducible and reads the same from both ends: it is z^D times a
// sum of z^j + z^-j, and so a polynomial of degree D in y = z + 1/z = 2 cos(2 pi/m), which is
// irreducible as well (D = phi(m)/2 is the degree of y). Then x = 2/y - 1 is a root of the sum of
// c_j 2^j (x + 1)^(D - j), irreducible since x generates the same field.
Polynomial polynomial_of_ratio(int k, bool is_magic) {
  const Polynomial circle = cyclotomic(is_magic ? 4 * k + 2 : 4 * k + 4);
  const std::size_t degree = circle.size() / 2;
  Polynomial next(degree + 1, 0), last(degree + 1, 0);  // by Clenshaw: z^j + z^-j in y
  for (std::size_t j = degree + 1; j-- > 0;) {
    Polynomial now(degree + 1, 0);
    for (std::size_t i = 0; i <= degree; ++i)
      now[i] = (i == 0 ? circle[degree + j] : next[i - 1]) - (j == 0 ? 2 : 1) * last[i];
    last = next;
    next = now;
  }
  Polynomial p{0};
  for (std::size_t j = 0; j <= degree; ++j) {  // times (x + 1), plus the next coefficient
    p.push_back(0);
    for (std::size_t i = p.size() - 1; i > 0; --i) p[i] = p[i] + p[i - 1];
    p[0] = p[0] + cln::ash(next[j], static_cast<long>(j));
  }
  p.pop_back();
  cln::cl_I factor = 0;
  for (const cln::cl_I& c : p) factor = cln::gcd(factor, c);
  if (p.back() < 0) factor = -factor;
  for (cln::cl_I& c : p) c = cln::exquo(c, factor);
  return p;
}

std::string text_of(const Polynomial& p) {
  std::string out;
  for (std::size_t i = p.size(); i-- > 0;) {
    if (p[i] == 0) continue;
    const std::string power = i == 0 ? "" : i == 1 ? "x" : "x^" + std::to_string(i);
    const std::string size = kernel::digits(cln::abs(p[i]));
    out += out.empty() ? (p[i] < 0 ? "-" : "") : (p[i] < 0 ? " - " : " + ");
    out += power.empty() ? size : size == "1" ? power : size + "*" + power;
  }
  return out;
}

Answer ratios(const Request& request) {
  constexpr int rows_at_once = 100;
  const std::optional<int> digits = digits_wanted(request);
  const bool has_polynomials = request.has("polynomials");
  const std::string of = has_polynomials ? " with polynomials" : "";
  const std::int64_t most = has_polynomials ? 200 : 100'000;
  const int count = request.has("count") ? int(request.size("count", 1, most, of)) : 10;
  Names columns{"k", "magic", "deficient", "magic_radicals", "deficient_radicals"};
  if (has_polynomials) columns.insert(columns.end(), {"magic_polynomial", "deficient_polynomial"});
  const auto rows_from = [=](int first) {
    std::vector<Row> rows;
    for (int k = first; k <= std::min(count, first + rows_at_once - 1); ++k) {
      Row numbers, radicals, polynomials;
      for (const bool is_magic : {true, false}) {
        const auto ratio = [&] { return Balls{ball_of(notation::Threshold{is_magic, k})}; };
        numbers.push_back(rounded(ratio, digits)[0]);
        const std::string name = (is_magic ? "alpha_" : "beta_") + std::to_string(k);
        const std::string id = (name == "alpha_1" ? "ratios." : "radicals.") + name;
        radicals.push_back(derivation::is_shown(id) ? text_cell(kernel::text(right_side(id)))
                                                    : missing_cell());
        if (has_polynomials)
          polynomials.push_back(text_cell(text_of(polynomial_of_ratio(k, is_magic))));
      }
      rows.push_back(concatenated({{whole_cell(k)}, numbers, radicals, polynomials}));
    }
    return rows;
  };
  const auto stream = [=, format = format_of(request.format)](const auto& write) {
    Writer writer(format, columns, true);
    for (int first = 1; first <= count; first += rows_at_once) {
      write(writer.rows(rows_from(first)));
      write("");
    }
    write(writer.end());
  };
  return {.table = {columns, rows_from(1)}, .stream = stream};
}

}  // namespace answers
