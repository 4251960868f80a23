// The one place where chapters are put in order.
#include <algorithm>

#include "derivation/wedge.hpp"

namespace derivation {
namespace {
constexpr WriteChapter* in_order[] = {
    contact,     cycle,           cycle_matrix, rotation,   powers,     table,     counting,
    constraints, multiples,       ratios,       magic,      deficient,  radicals,  terminal,
    minima,      small_alpha,     restitution,  chebyshev,  wedge,      collapse,  from_any_start,
    motion,      losses,          transmission, ends,       wall,       places,    encounters,
    cradle,      billiard,        unfolded,     orthogonal, evaluators, end_forms, ratio_forms,
    heavy,       collision_forms, exact_forms,  bodies,     loss_forms};

// A chapter may be written in several parts, one after the other.
bool is_finished(const std::string& chapter, const Book& book) {
  const auto& all = book.chapters();
  return !all.empty() && all.back().name != chapter &&
         std::any_of(all.begin(), all.end(), [&](const Chapter& c) { return c.name == chapter; });
}
Book& proved_book() {
  static Book book;
  return book;
}
// Up to `id`, or the end of its chapter; all of them for "".
const Book& proved_until(const std::string& id) {
  static std::size_t proved = 0;
  Book& book = proved_book();
  static Theorems facts = assumed({alpha_positive, V_positive});
  const Known while_deriving;
  for (const Theorem& fact : facts) know_for_good(fact);
  const std::string chapter = id.substr(0, id.find('.'));
  const auto is_decided = [&] { return book.has(id) || is_finished(chapter, book); };
  for (; proved < std::size(in_order) && !is_decided(); ++proved) in_order[proved](book);
  suppose({});
  facts = known();
  return book;
}
}  // namespace

const Book& the_book() { return proved_until(""); }
const Book& proved_so_far() { return proved_book(); }
bool is_shown(const std::string& id) { return proved_until(id).has(id); }
Theorem shown(const std::string& id) { return proved_until(id)[id]; }
}  // namespace derivation
