// SPDX-License-Identifier: GPL-2.0-or-later
// What the headers' functions do, counted while they run: the number that their comment says, which the intermediate
// representation gave (tests/symbolic/codegen/specialised_test.cpp).
#include <fstream>
#include <regex>
#include <sstream>

#include <catch2/catch.hpp>

#include "counted_number.hpp"
#include "magicmass/a_c_prime.hpp"
#include "magicmass/a_t_b_t_c_t_rho_N_A_N_B_psi.hpp"
#include "magicmass/a_t_rho.hpp"
#include "magicmass/b_psi.hpp"
#include "magicmass/beta_k.hpp"
#include "magicmass/t_s.hpp"

using namespace magicmass;
using counted::Exact;
using counted::Number;
using counted::Operations;

namespace {

template <class Call>
Operations counted_in(const Call& call) {
  counted::made = {};
  call();
  return counted::made;
}

/// The line "// Cost: 5 additions, ..." of a header, with its continuation.
Operations stated(const std::string& name) {
  std::ifstream file(std::string(MAGICMASS_SPECIALISED) + "/" + name + ".hpp");
  std::ostringstream all;
  all << file.rdbuf();
  const std::string text = all.str();
  const std::size_t start = text.find("// Cost: ");
  REQUIRE(start != std::string::npos);
  const std::string cost = text.substr(start, text.find("// Error", start) - start);
  const auto number_before = [&](const char* words) {
    std::smatch found;
    return std::regex_search(cost, found, std::regex(std::string("(\\d+) ") + words))
               ? std::stoi(found[1])
               : 0;
  };
  return {.additions = number_before("addition"),
          .multiplications = number_before("multiplication"),
          .divisions = number_before("division"),
          .roots = number_before("square root"),
          .turns = number_before("sine-cosine pair") + number_before("sines? or cosine"),
          .arctangents = number_before("arctangent")};
}

}  // namespace

TEST_CASE("a header's function makes the operations that it states, no more and no fewer",
          "[exam]") {
  const Exact alpha(0.12), three(3), one(1);
  CHECK(counted_in([&] { generated::a_t_rho::evaluate_in<Number>(alpha, three, one); }) ==
        stated("a_t_rho"));
  CHECK(counted_in([&] {
          generated::a_t_b_t_c_t_rho_N_A_N_B_psi::evaluate_in<Number>(alpha, three, one);
        }) == stated("a_t_b_t_c_t_rho_N_A_N_B_psi"));
  CHECK(counted_in([&] { generated::a_c_prime::evaluate_in<Number>(alpha, three); }) ==
        stated("a_c_prime"));
  CHECK(counted_in([&] { generated::b_psi::evaluate_in<Number>(alpha, three); }) ==
        stated("b_psi"));
  CHECK(counted_in([&] { generated::t_s::evaluate_in<Number>(alpha, three); }) == stated("t_s"));
  CHECK(counted_in([&] { generated::beta_k::evaluate_in<Number>(three); }) == stated("beta_k"));
}

TEST_CASE("two of the terminal quantities cost less than all", "[exam]") {
  const Operations part = stated("a_t_rho"), all = stated("a_t_b_t_c_t_rho_N_A_N_B_psi");
  CHECK(part.multiplications < all.multiplications);
  CHECK(part.additions <= all.additions);
  CHECK(part.turns == 1);
  // from alpha = 1 on there is neither root nor angle
  const Operations first =
      counted_in([] { generated::a_t_rho::evaluate_in<Number>(Exact(3), Exact(1), Exact(1)); });
  CHECK(first.roots + first.turns + first.arctangents == 0);
}

TEST_CASE("the counting sees one superfluous operation", "[exam]") {
  const Operations spoilt = counted_in([] {
    generated::a_t_rho::evaluate_in<Number>(Exact(0.12), Exact(3), Exact(1));
    Number(1.0) * Number(2.0);
  });
  CHECK_FALSE(spoilt == stated("a_t_rho"));
}
