// One collision of two bodies: what the laws say, what follows, and what a spoiled law would do.
#include <cstdio>

#include "derivation/symbols.hpp"
#include "kernel/expr.hpp"
#include "magicmass/simulator/contact.hpp"

using namespace derivation;
using cln::cl_RA;
using magicmass::simulator::Body;

// A body that moves with velocity 1 hits one at rest. Change the masses, or let both move.
void print_collision(const cl_RA& m_1, const cl_RA& m_2) {
  Body<cl_RA> first{m_1, 0, 1};
  Body<cl_RA> second{m_2, 0, 0};
  magicmass::simulator::collide(first, second);
  const cl_RA energy_share = m_2 * second.velocity * second.velocity / m_1;
  std::printf("  %s", kernel::digits(m_1).c_str());
  for (const cl_RA& number :
       {m_2, first.velocity, second.velocity, second.velocity - first.velocity, energy_share})
    std::printf(" | %s", kernel::digits(number).c_str());
  std::printf("\n");
}

// Proves that the relative velocity turns round, from momentum and one more quantity that is kept:
// energy, or another. The certificate is the difference of squares taken apart: energy once, minus
// momentum times u_2 + v_2, is a product with two factors that are not 0.
std::string relative_velocity(int power_kept) {
  const Expr kept = eq(M_1 * power(u_1, power_kept) + M_2 * power(u_2, power_kept),
                       M_1 * power(v_1, power_kept) + M_2 * power(v_2, power_kept));
  const Expr momentum = eq(M_1 * u_1 + M_2 * u_2, M_1 * v_1 + M_2 * v_2);
  Certificate certificate;
  certificate.equations = {{1, assume(kept)}, {-(u_2 + v_2), assume(momentum)}};
  certificate.multipliers = {assume(lt(0, M_1)), assume(neq(v_1, u_1))};
  try {
    return text(arithmetic(eq(u_1 + v_1, u_2 + v_2), certificate).conclusion());
  } catch (const Refused&) {
    return "refused";
  }
}

int main() {
  std::printf("collisions:\n  M_1 | M_2 | v_1 | v_2 | v_2 - v_1 | energy that moved\n");
  for (const cl_RA& mass : {cl_RA(1), cl_RA(1) / 7, cl_RA(1) / 100, cl_RA(7), cl_RA(1000)})
    print_collision(1, mass);
  std::printf("from_energy: %s\n", relative_velocity(2).c_str());
  // Suppose that nature kept M v^4 instead of M v^2.
  std::printf("from_fourth_powers: %s\n", relative_velocity(4).c_str());
}
