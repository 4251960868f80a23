// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/definitions.hpp"

#include <algorithm>
#include <stdexcept>

#include <ginac/ginac.h>

#include "proof/arctangent.hpp"
#include "proof/names.hpp"
#include "proof/text.hpp"

namespace magicmass::proof {
namespace {

using GiNaC::ex;

ex substitute_until_stable(const ex& e, const GiNaC::exmap& meanings) {
  ex current = e;
  for (;;) {  // ends: a meaning uses earlier names only
    const ex next = current.subs(meanings, GiNaC::subs_options::no_pattern);
    if (next.is_equal(current)) return next.evalm();
    current = next;
  }
}

}  // namespace

struct Definitions::Data {
  std::map<std::string, ex> angles;
  std::set<std::string> names;
  GiNaC::exmap all;
  GiNaC::exmap without_angles;
};

Definitions::Definitions() : data_(std::make_shared<const Data>()) {}
Definitions::~Definitions() = default;

void Definitions::add(const std::string& name, const ex& meaning) {
  const ex named = symbol(name);
  if (contains(name)) throw std::logic_error("the name " + name + " is already defined");
  if (expand_all(meaning).has(named))
    throw std::logic_error("the definition of " + name + " uses " + name);
  auto data = std::make_shared<Data>(*data_);
  data->names.insert(name);
  data->all[named] = meaning;
  if (multiple_of_arctangent(meaning))
    data->angles.emplace(name, meaning);
  else
    data->without_angles[named] = meaning;
  data_ = std::move(data);
}

bool Definitions::contains(const std::string& name) const { return data_->names.contains(name); }

const ex* Definitions::angle(const std::string& name) const {
  const auto found = data_->angles.find(name);
  return found == data_->angles.end() ? nullptr : &found->second;
}

bool Definitions::speaks_of(const std::string& words, const std::string& name) const {
  return proof::speaks_of(words, name) ||
         std::any_of(data_->names.begin(), data_->names.end(), [&](const std::string& defined) {
           return proof::speaks_of(words, defined) && expand_all(symbol(defined)).has(symbol(name));
         });
}

ex Definitions::with_angle_names(const ex& e) const {
  GiNaC::exmap names;
  for (const auto& [name, meaning] : data_->angles)
    if (GiNaC::is_a<GiNaC::function>(meaning)) names[meaning] = symbol(name);
  return e.subs(names, GiNaC::subs_options::no_pattern).evalm();
}

ex Definitions::expand_all(const ex& e) const { return substitute_until_stable(e, data_->all); }

ex Definitions::expand_except_angles(const ex& e) const {
  return substitute_until_stable(e, data_->without_angles);
}

}  // namespace magicmass::proof
