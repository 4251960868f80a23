// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/derivation.hpp"

#include <algorithm>
#include <stdexcept>

#include "derivation/chapters.hpp"
#include "derivation/wedge.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::derivation {

const proof::Theorem& Derivation::at(const std::string& id) const {
  for (const proof::Theorem& theorem : theorems)
    if (theorem.id() == id) return theorem;
  throw InvalidInput("no theorem is called " + id);
}

namespace {

// What the chapters hand on.
struct Results {
  std::optional<Contact> contact;
  std::optional<Cycle> cycle;
  std::optional<Rotation> rotation;
  std::optional<Power> power;
  std::optional<Chebyshev> chebyshev;
  std::optional<Counting> counting;
  std::optional<Ratios> ratios;
  std::optional<Terminal> terminal;
  std::optional<Times> times;
  std::optional<Tangent> tangent;
  std::optional<Mapping> mapping;
  std::optional<Table> table;
  std::optional<Unfolding> unfolding;
  std::optional<Restitution> restitution;
  std::optional<Wedge> wedge;
  std::optional<EqualBlocks> equal_blocks;
  std::optional<Collapse> collapse;
};

struct Chapter {
  std::string name;
  void (*derive)(Kernel& kernel, Results& results, const Laws& laws, const Paper& paper);
};

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> all{
      {"orthogonal", [](Kernel& kernel, Results&, const Laws&,
                        const Paper& paper) { orthogonal(kernel, paper); }},
      {"frame",
       [](Kernel& kernel, Results&, const Laws&, const Paper& paper) { frame(kernel, paper); }},
      {"contact", [](Kernel& kernel, Results& r, const Laws& laws,
                     const Paper& paper) { r.contact = contact(kernel, laws, paper); }},
      {"cycle", [](Kernel& kernel, Results& r, const Laws&,
                   const Paper& paper) { r.cycle = cycle(kernel, *r.contact, paper); }},
      {"rotation", [](Kernel& kernel, Results& r, const Laws&,
                      const Paper& paper) { r.rotation = rotation(kernel, *r.cycle, paper); }},
      {"mapping",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         r.mapping = mapping(kernel, *r.contact, *r.cycle, *r.rotation, paper);
       }},
      {"table",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         r.table = table(kernel, *r.contact, *r.rotation, paper);
       }},
      {"multiples",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         multiples(kernel, *r.contact, *r.rotation, *r.table, paper);
       }},
      {"power",
       [](Kernel& kernel, Results& r, const Laws& laws, const Paper& paper) {
         r.power = power(kernel, laws, *r.contact, *r.cycle, *r.rotation, paper);
       }},
      {"chebyshev", [](Kernel& kernel, Results& r, const Laws&,
                       const Paper&) { r.chebyshev = chebyshev(kernel, *r.rotation, *r.power); }},
      {"counting",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         r.counting = counting(kernel, *r.rotation, *r.power, paper);
       }},
      {"ratios",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         r.ratios = ratios(kernel, *r.rotation, *r.power, *r.counting, paper);
       }},
      {"terminal",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         r.terminal = terminal(kernel, *r.power, *r.counting, *r.ratios, paper);
       }},
      {"minima",
       [](Kernel& kernel, Results& r, const Laws&, const Paper&) {
         minima(kernel, *r.rotation, *r.power, *r.counting, *r.terminal);
       }},
      {"small_alpha",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         small_alpha(kernel, *r.rotation, *r.counting, paper);
       }},
      {"times",
       [](Kernel& kernel, Results& r, const Laws& laws, const Paper&) {
         r.times = times(kernel, laws, *r.power, *r.counting, *r.chebyshev);
       }},
      {"tangent",
       [](Kernel& kernel, Results& r, const Laws&, const Paper&) {
         r.tangent = tangent(kernel, *r.rotation, *r.power, *r.times);
       }},
      {"offset", [](Kernel& kernel, Results& r, const Laws&,
                    const Paper&) { offset(kernel, *r.power, *r.counting, *r.terminal); }},
      {"fixed_n",
       [](Kernel& kernel, Results& r, const Laws&, const Paper&) {
         fixed_n(kernel, *r.power, *r.counting, *r.terminal, *r.tangent);
       }},
      {"unfolding",
       [](Kernel& kernel, Results& r, const Laws&, const Paper&) {
         r.unfolding = unfolding(kernel, *r.cycle, *r.power, *r.mapping, *r.times);
       }},
      {"chain", [](Kernel& kernel, Results& r, const Laws&,
                   const Paper&) { chain(kernel, *r.contact, *r.ratios, *r.unfolding); }},
      {"restitution", [](Kernel& kernel, Results& r, const Laws& laws,
                         const Paper&) { r.restitution = restitution(kernel, laws, *r.cycle); }},
      {"wedge", [](Kernel& kernel, Results& r, const Laws& laws,
                   const Paper&) { r.wedge = wedge(kernel, laws, *r.restitution); }},
      {"special_cases",
       [](Kernel& kernel, Results& r, const Laws&, const Paper& paper) {
         r.equal_blocks = special_cases(kernel, *r.wedge, *r.restitution, *r.power, *r.counting,
                                        *r.times, paper);
       }},
      {"collapse", [](Kernel& kernel, Results& r, const Laws&,
                      const Paper&) { r.collapse = collapse(kernel, *r.wedge); }},
      {"inelastic_end", [](Kernel& kernel, Results& r, const Laws&,
                           const Paper&) { inelastic_end(kernel, *r.equal_blocks, *r.collapse); }},
      {"transmission", [](Kernel& kernel, Results& r, const Laws&,
                          const Paper&) { transmission(kernel, *r.equal_blocks, *r.collapse); }},
  };
  return all;
}

}  // namespace

const std::vector<std::string>& chapter_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Chapter& chapter : chapters()) all.push_back(chapter.name);
    return all;
  }();
  return names;
}

namespace {

std::size_t place_of(const std::string& chapter) {
  const auto& names = chapter_names();
  const auto found = std::find(names.begin(), names.end(), chapter);
  if (found == names.end()) throw InvalidInput("no chapter is called " + chapter);
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

struct Beginning::Data {
  Kernel kernel{{.positive = {"L", "M", "M_1", "M_2", "V", "M_A", "M_B", "alpha", "e", "h_1", "h_2",
                              "m", "mu_A", "mu_B", "xi", "tan_h", "C"},
                 .integer = {}}};
  Results results;
  std::size_t done = 0;  // chapters

  void go_on(std::size_t end, const Laws& laws, const Paper& paper) {
    for (; done < end; ++done) chapters()[done].derive(kernel, results, laws, paper);
  }
};

Beginning::Beginning(const std::string& next_chapter, const Laws& laws, const Paper& paper) {
  auto data = std::make_shared<Data>();
  data->go_on(place_of(next_chapter), laws, paper);
  data_ = std::move(data);
}

Beginning::Beginning(const Laws& laws, const Paper& paper) {
  auto data = std::make_shared<Data>();
  data->go_on(chapters().size(), laws, paper);
  data_ = std::move(data);
}

const proof::Kernel& Beginning::kernel() const { return data_->kernel; }

Derivation Beginning::up_to(const std::string& chapter, const Laws& laws,
                            const Paper& paper) const {
  const std::size_t end = place_of(chapter) + 1;
  Data data = *data_;
  Derivation result;
  try {
    data.go_on(end, laws, paper);
  } catch (const proof::NotProved& refused) {
    result.refused = refused;
  } catch (const std::runtime_error& stuck) {  // a singular system, a null space that is not a line
    const auto& proved = data.kernel.theorems();
    proof::Step step{.id = "derivation",
                     .rule = "solving",
                     .from = {},
                     .relation = "=",
                     .to = {},
                     .conditions = {},
                     .label = {},
                     .words = "after " + (proved.empty() ? "the start" : proved.back().id()),
                     .verdict = "refused",
                     .premises = {}};
    result.refused = proof::NotProved(step, std::string(stuck.what()) + ", " + step.words);
  }
  result.theorems = data.kernel.theorems();
  return result;
}

Derivation Beginning::completed(const Laws& laws, const Paper& paper) const {
  return up_to(chapter_names().back(), laws, paper);
}

Derivation derive(const Laws& laws, const Paper& paper) {
  return Beginning(chapter_names().front(), laws, paper).completed(laws, paper);
}

Derivation derive_up_to(const std::string& chapter) {
  const Laws laws = conservation_laws();
  const Paper printed = paper();
  return Beginning(chapter_names().front(), laws, printed).up_to(chapter, laws, printed);
}

Derivation derive() { return derive(conservation_laws(), paper()); }

}  // namespace magicmass::derivation
