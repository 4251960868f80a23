#include "answers/commands.hpp"
#include "answers/motion.hpp"
#include "magicmass/exact/exact.hpp"
#include "magicmass/numbers/accurate.hpp"
#include "magicmass/numbers/counts.hpp"
#include "magicmass/numbers/fast.hpp"

namespace answers {
namespace {

using notation::Alpha;

Cell alpha_cell(const Alpha& alpha) {
  if (const auto* value = std::get_if<double>(&alpha)) return real_cell(*value);
  return text_cell(notation::text(alpha));
}
/// The tier that is asked for; "exact" where digits are.
std::string tier_of(const Request& request) {
  if (!request.has("tier")) return request.has("digits") ? "exact" : "accurate";
  const std::string tier = request.text("tier");
  if (request.has("digits") && tier != "exact")
    throw InvalidInput("--digits belongs to --tier exact, not to --tier " + tier);
  return tier;
}

/// What eval and terminal are asked.
struct Asked {
  const Request& request;
  Alpha alpha = alpha_of(request.text("alpha"));
  std::string tier = tier_of(request);
  std::optional<int> digits = digits_wanted(request);
  bool wants_fractions = tier == "exact" && !digits;
  /// The double that tiers fast and accurate answer for.
  const double* number = tier == "exact" ? nullptr : std::get_if<double>(&alpha);

  /// Fractions that so many steps make longer by so many bits of the mass ratio and of `others`
  /// each, or rounded from short ones: these may be halfway between two. Else of balls, where these
  /// can tell. Where fractions are wanted, throws InvalidInput for none, Undecided for long ones.
  Row cells(const cln::cl_I& steps, const std::string& name, const auto& fractions,
            const std::function<Balls()>& balls, int longest = 1 << 22,
            std::size_t others = 0) const {
    const auto fraction = fraction_of(alpha);
    if (!fraction && wants_fractions)
      throw InvalidInput("alpha: velocities at " + notation::text(alpha) +
                         " need not be fractions; add --digits D");
    const std::size_t length = Surd(fraction.value_or(0)).bits();
    const cln::cl_I bits = steps * static_cast<long long>(2 * length + others);
    if (!fraction || (!wants_fractions && bits > 1 << 11)) try {
        return rounded(balls, digits);
      } catch (const Undecided&) {
        if (!fraction || bits > 1 << 14) throw;
      }
    if (bits > longest)
      throw Undecided("exact fractions after " + kernel::digits(steps) + " " + name +
                      " would have some " + kernel::digits(bits) + " bits; add --digits D");
    Row row;
    for (const cln::cl_RA& x : fractions(*fraction))
      row.push_back(wants_fractions ? text_cell(kernel::digits(x))
                    : digits        ? text_cell(*balls::decimal(x, x, *digits))
                                    : real_cell(balls::nearest_double(x, x).value()));
    return row;
  }
};
const Names of_eval{"alpha", "n", "tier", "a", "b", "c", "c_prime"};
const Names of_count{"alpha", "N_A", "N_B"};
const Names of_terminal{"alpha", "N_A", "N_B", "a_t", "b_t", "c_t", "rho"};
const Names with_restitution{"alpha", "restitution", "N_A", "N_B",          "a_t",
                             "b_t",   "c_t",         "rho", "collapse_time"};

Answer answer(Names columns, std::initializer_list<Row> parts) {
  return {{std::move(columns), {concatenated(parts)}, false}, ""};
}

// Many rows at once: what is no number becomes one that the array functions have no answer for.

using Reals = std::vector<double>;
using Wholes = std::vector<std::int64_t>;

/// An option of each row: its field, or what all share; `none` where that is no such number.
template <class Number>
std::vector<Number> option_of(const Rows& rows, const std::string& option,
                              std::optional<Number> (*read)(std::string_view), Number none) {
  const auto at = std::size_t(std::ranges::find(rows.columns, option) - rows.columns.begin());
  const std::string shared = rows.shared.text(option);
  std::vector<Number> all;
  for (const std::vector<std::string>& fields : rows.fields)
    all.push_back(read(at < fields.size() ? fields[at] : shared).value_or(none));
  return all;
}
Reals alphas_of(const Rows& rows) {
  return option_of(rows, "alpha", notation::read_double, std::numeric_limits<double>::quiet_NaN());
}

/// Whether the array functions answer for them.
bool is_of_arrays(const Rows& rows) {
  return !rows.shared.has("digits") && rows.shared.text("tier") != "exact";
}

}  // namespace

Answer eval(const Request& request) {
  const Asked in{request};
  const LargeCounts counts = count_collisions(in.alpha);
  const cln::cl_I& N_A = counts.N_A;
  const bool fits = cln::integer_length(N_A) < 64;
  const std::int64_t n =
      fits ? *request.whole("n", 0, cln::cl_I_to_long(N_A)) : request.size("n", 0, INT64_MAX);
  const auto exactly = [&](const cln::cl_RA& alpha) {
    const auto v = magicmass::generated::velocities_exact(alpha, n);
    return std::vector{v.a, v.b, v.c, v.c_prime};
  };
  Row four;
  if (in.number != nullptr) {
    const auto v = in.tier == "fast" ? magicmass::fast::velocities(*in.number, n)
                                     : magicmass::accurate::velocities(*in.number, n);
    four = real_cells({v.a, v.b, v.c, v.c_prime});
  } else {
    four = in.cells(n, "cycles", exactly, [&] { return velocities(in.alpha, n); });
  }
  Answer all = answer(of_eval, {{alpha_cell(in.alpha), whole_cell(n), text_cell(in.tier)}, four});
  if (n > 0 && n > counts.N_B)
    all.note = "eval: Q_" + std::to_string(n) +
               " does not take place: b and c_prime are values of the formulas alone";
  return all;
}

Answer count(const Request& request) {
  const Alpha alpha = alpha_of(request.text("alpha"));
  return answer(of_count, {{alpha_cell(alpha)}, count_cells(count_collisions(alpha))});
}

/// The restitution of a request, written as a mass ratio is.
Alpha restitution_of(const Request& request) {
  const std::string text = request.text("restitution");
  try {
    const Alpha e = alpha_of(text);
    const auto fraction = fraction_of(e);
    if (fraction && *fraction <= 1) return e;
  } catch (const InvalidInput&) {
  }
  throw InvalidInput("restitution must be a number or a fraction above 0 and at most 1, got " +
                     shown_text(text));
}

/// Nothing where collisions end, or so nearly that no precision tells the time.
std::optional<magicmass::Collapse> collapse_of(double alpha, double e) {
  try {
    return magicmass::accurate::collapse(alpha, e);
  } catch (const Undecided&) {
    return {};
  }
}
/// Counts and velocities at the end; where collisions never end, also when that is.
Row end_of(const Asked& in, const Alpha& restitution) {
  const cln::cl_RA e = *fraction_of(restitution);
  const auto* loss = std::get_if<double>(&restitution);
  const bool is_fast = in.tier == "fast";
  std::optional<magicmass::Terminal> t;  // nothing where counts do not fit 64 bits
  if (in.number != nullptr && e == 1)
    t = is_fast ? magicmass::fast::terminal(*in.number) : magicmass::accurate::terminal(*in.number);
  else if (in.number != nullptr && is_fast && loss != nullptr)
    t = magicmass::fast::terminal(*in.number, *loss);
  if (t)
    return concatenated({count_cells({t->counts.N_A, t->counts.N_B}),
                         real_cells({t->a_t, t->b_t, t->c_t, t->rho})});
  if (e == 1) {
    const LargeCounts counts = count_collisions(in.alpha);
    const auto exactly = [&](const cln::cl_RA& alpha) {
      const auto v = magicmass::generated::terminal_exact(alpha, cln::cl_I_to_long(counts.N_A),
                                                          cln::cl_I_to_long(counts.N_B));
      return std::vector{v.a_t, v.b_t, v.c_t, v.rho};
    };
    const auto balls = [&] { return answers::terminal(in.alpha, counts); };
    const auto* ratio = std::get_if<notation::Threshold>(&in.alpha);
    if (in.wants_fractions && ratio && ratio->is_magic)  // magic.terminal
      return concatenated({count_cells(counts), real_cells({0, 1, 0, 1})});
    return concatenated({count_cells(counts), in.cells(counts.N_A, "cycles", exactly, balls)});
  }
  if (in.number != nullptr && loss != nullptr)
    if (const auto c = collapse_of(*in.number, *loss))
      return concatenated({Row(2, endless_cell()), real_cells({c->v, c->v, c->v, c->rho, c->t})});
  const Trio trio = Trio::equal_blocks(value_of(in.alpha), value_of(e));
  const auto N = trio.count();
  const auto balls = [&] { return answers::terminal(trio, N); };
  if (N) {
    constexpr int longest = 1 << 18;                    // each step reduces its fractions
    const auto exactly = [&](const cln::cl_RA& mass) {  // by the law of one collision
      magicmass::simulator::InTurn<cln::cl_RA> now(1, mass, 1, e);
      while (now.collisions < *N) now.step();
      const auto& [a, c, b] = now.velocities;
      return std::vector{a, b, c, b * b};
    };
    return concatenated({count_cells({(*N + 1) / 2, *N / 2}),
                         in.cells(*N, "collisions", exactly, balls, longest, Surd(e).bits())});
  }
  if (in.wants_fractions)
    throw Undecided(
        "terminal: infinitely many collisions end at a time that may be no fraction; "
        "add --digits D");
  return concatenated({Row(2, endless_cell()), rounded(balls, in.digits)});
}

Answer terminal(const Request& request) {
  const Asked in{request};
  const bool may_lose = request.has("restitution");
  const Names& columns = may_lose ? with_restitution : of_terminal;
  const Alpha e = may_lose ? restitution_of(request) : Alpha(cln::cl_RA(1));
  Row row =
      concatenated({{alpha_cell(in.alpha)}, Row(may_lose ? 1 : 0, alpha_cell(e)), end_of(in, e)});
  row.resize(columns.size(), missing_cell());  // where collisions end: no collapse_time
  return answer(columns, {row});
}

Block eval_block(const Rows& rows) {
  if (!is_of_arrays(rows)) return {of_eval};
  const Reals alpha = alphas_of(rows);
  const Wholes n = option_of(rows, "n", read_whole, std::int64_t{-1});
  std::vector<Reals> v(4, Reals(alpha.size()));
  const magicmass::VelocityColumns columns{v[0], v[1], v[2], v[3]};
  const bool is_fast = rows.shared.text("tier") == "fast";
  if (is_fast)
    magicmass::fast::velocities(alpha, n, columns);
  else
    magicmass::accurate::velocities(alpha, n, columns);
  return {of_eval, {alpha, n, text_cell(is_fast ? "fast" : "accurate"), v[0], v[1], v[2], v[3]}};
}

Block count_block(const Rows& rows) {
  const Reals alpha = alphas_of(rows);
  Wholes N_A(alpha.size()), N_B(alpha.size());
  magicmass::count_collisions(alpha, N_A, N_B);
  return {of_count, {alpha, N_A, N_B}};
}

Block terminal_block(const Rows& rows) {
  if (rows.shared.has("restitution") || std::ranges::count(rows.columns, "restitution") != 0)
    return {with_restitution};
  if (!is_of_arrays(rows)) return {of_terminal};
  const Reals alpha = alphas_of(rows);
  Wholes N_A(alpha.size()), N_B(alpha.size());
  std::vector<Reals> v(4, Reals(alpha.size()));
  const magicmass::TerminalColumns columns{N_A, N_B, v[0], v[1], v[2], v[3]};
  if (rows.shared.text("tier") == "fast")
    magicmass::fast::terminal(alpha, columns);
  else
    magicmass::accurate::terminal(alpha, columns);
  return {of_terminal, {alpha, N_A, N_B, v[0], v[1], v[2], v[3]}};
}

}  // namespace answers
