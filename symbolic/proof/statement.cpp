// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/statement.hpp"

#include <ginac/ginac.h>

namespace magicmass::proof {

struct Statement::Data {
  GiNaC::ex lhs;
  Relation relation;
  GiNaC::ex rhs;
};

Statement::Statement(const GiNaC::ex& lhs, const GiNaC::ex& rhs)
    : Statement(lhs, Relation::equal, rhs) {}

Statement::Statement(const GiNaC::ex& lhs, Relation relation, const GiNaC::ex& rhs)
    : data_(std::make_shared<const Data>(Data{lhs.evalm(), relation, rhs.evalm()})) {}

const GiNaC::ex& Statement::lhs() const { return data_->lhs; }
const GiNaC::ex& Statement::rhs() const { return data_->rhs; }
Relation Statement::relation() const { return data_->relation; }

}  // namespace magicmass::proof
