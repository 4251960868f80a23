// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ginac/ginac.h>

#include "equality/domain.hpp"
#include "proof/normal_form.hpp"

// Inside of the decisions on functions; included by their .cpp files only.
namespace magicmass::equality {

// Trees in the words of the kernel's normal form. Two views of a domain:
//   wide:  a symbol with a low end >= 0 is positive, an integer starts at its low end; other bounds are forgotten;
//   exact: a symbol between a and b is written (a + b t)/(1 + t), above a as a + t, below b as b - t, with t > 0:
//          all of the open interval and nothing else. Ends that belong to a range are left out.
// What the normal form proves on either holds for the domain (exact: for its interior).
class Translation {
public:
  enum class View { wide, exact };
  struct Manner {
    View view = View::wide;
    bool named_constants =
        true;  // cos(pi/5), atan(1/5) become names; else they are translated like functions
    long power =
        1;  // alpha = t^power for each symbol of known sign: roots of it become powers of t
    bool halved_angles =
        false;  // cos x and sin x by x/2: roots of 1 - cos x and 1 + cos x become sines and cosines
    bool kept_inverses =
        false;  // asin and acos stay, to be differentiated; else they are written by atan
  };
  using ex = GiNaC::ex;

  Translation(const Domain& domain, const Manner& manner);

  // Throws proof::NotInClass. Equal to the tree wherever the tree is defined on the domain.
  ex operator()(const Tree& tree);

  proof::NormalForm& form() { return *form_; }
  const std::vector<ex>& variables() const { return variables_; }

  // Whether some symbols of the translation stand for powers such as alpha^n: derivatives do not see through them.
  bool has_opaque_powers() const { return keys_.size() > named_.size(); }

  // Whether e vanishes identically: in normal form or, where constants such as cos(pi/5) are left over, because
  // the coefficient of every function of the symbols is exactly 0.
  bool is_zero(const ex& e);
  // As proof::NormalForm::is_positive, and >= 0: also where squares of unknown sign are left out.
  bool is_positive(const ex& e) { return form_->is_positive(e); }
  bool is_not_negative(const ex& e);

private:
  ex translated(const Tree& tree);
  ex translated_constant(const Tree& tree);
  ex power(const Tree& tree);
  ex exponential(const std::string& key, const ex& base, const ex& exponent);
  ex product_of_exponentials(const ex& base, const ex& exponent);
  ex root(const ex& radicand, long order, const Tree& shown);
  ex square_root(const ex& radicand);
  ex absolute(const Tree& argument);
  ex function(const Tree& tree);
  ex arcsine(const ex& u);
  ex angle(const Tree& tree);
  std::pair<ex, ex> cosine_and_sine(const Tree& argument);
  ex angle_of_constant(const Tree& tree);
  ex without_full_turns(const ex& angle) const;
  bool is_integer_valued(const ex& expanded) const;
  ex named(const std::string& key, const Tree& value);  // a positive symbol for a positive constant
  bool is_constant(const ex& e) const;

  Manner manner_;
  std::map<std::string, ex> values_;   // of the domain's symbols
  std::map<std::string, Tree> named_;  // positive constants by the name of their symbol
  std::map<std::string, std::string> keys_;
  GiNaC::exset integers_;
  std::vector<ex> variables_;
  proof::Domain domain_;
  std::unique_ptr<proof::NormalForm> form_;
};

}  // namespace magicmass::equality
