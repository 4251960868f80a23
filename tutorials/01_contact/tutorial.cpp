// SPDX-License-Identifier: GPL-2.0-or-later
// One contact of two bodies: what the laws say, what follows, and what happens
// when a law is spoiled.
#include <cstdio>
#include <string>

#include <cln/rational.h>
#include <cln/rational_io.h>
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/contact.hpp"
#include "proof/names.hpp"

using magicmass::collide;
using magicmass::reference::parse_rational;
using magicmass::reference::to_text;
namespace derivation = magicmass::derivation;
namespace proof = magicmass::proof;

// A body that moves with velocity 1 meets one at rest. Change the masses, or let
// both move.
void print_contact(const std::string& mass, const std::string& other_mass) {
  const cln::cl_RA m_1 = parse_rational(mass), m_2 = parse_rational(other_mass);
  const auto [v_1, v_2] = collide<cln::cl_RA>(m_1, 1, m_2, 0);
  const cln::cl_RA energy_share = m_2 * v_2 * v_2 / m_1;
  std::printf("  %s | %s | %s | %s | %s | %s\n", mass.c_str(), other_mass.c_str(),
              to_text(v_1).c_str(), to_text(v_2).c_str(),
              to_text(v_2 - v_1).c_str(), to_text(energy_share).c_str());
}

// The chapter of the derivation about one contact, from these laws. Returns what
// the proof kernel says.
std::string derived_from(const derivation::Laws& laws) {
  proof::Kernel kernel({.positive = {"M", "M_1", "M_2", "alpha"}, .integer = {}});
  try {
    derivation::orthogonal(kernel,
                           derivation::paper());  // rotations and reflections
    const std::size_t before = kernel.theorems().size();
    derivation::contact(kernel, laws, derivation::paper());
    return std::to_string(kernel.theorems().size() - before) +
           " steps, none refused";
  } catch (const proof::NotProved& refused) {
    return "refused at " + refused.step.id;
  }
}

int main() {
  std::printf(
      "contacts:\n  M_1 | M_2 | v_1 | v_2 | v_2 - v_1 | energy that moved\n");
  print_contact("1", "1");
  print_contact("1", "1/7");
  print_contact("1", "1/100");
  print_contact("1", "7");
  print_contact("1", "1000");

  derivation::Laws laws = derivation::conservation_laws();
  std::printf("with_the_laws: %s\n", derived_from(laws).c_str());

  // Suppose that nature conserved M |v|^4 instead of M v^2.
  const auto sum_of = [](const char* v_1, const char* v_2, int power) -> GiNaC::ex {
    return proof::symbol("M_1") * pow(proof::symbol(v_1), power) +
           proof::symbol("M_2") * pow(proof::symbol(v_2), power);
  };
  laws.energy = {sum_of("u_1", "u_2", 4), sum_of("v_1", "v_2", 4)};
  std::printf("with_fourth_powers: %s\n", derived_from(laws).c_str());
}
