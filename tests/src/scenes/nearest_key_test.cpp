// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/scenes/nearest_key.hpp"

#include <string>

#include <catch2/catch.hpp>

using magicmass::edit_distance;
using magicmass::nearest_key;

TEST_CASE("a misspelt key is near to the one that was meant, and to no other", "[exam]") {
  const std::vector<std::string_view> keys{"alpha", "V", "L", "restitution", "outputs"};
  CHECK(nearest_key("alhpa", keys) == "alpha");
  CHECK(nearest_key("restitutoin", keys) == "restitution");
  CHECK(nearest_key("output", keys) == "outputs");
  CHECK(!nearest_key("v", keys));
  CHECK(!nearest_key("colour", keys));
  CHECK(!nearest_key("", keys));
  CHECK(!nearest_key(std::string(1000, 'a'), keys));
  CHECK(!nearest_key("alpha", {}));
}

TEST_CASE("a letter inserted, deleted, replaced or swapped is one change", "[exam]") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("abc", "abxc") == 1);
  CHECK(edit_distance("abc", "ac") == 1);
  CHECK(edit_distance("abc", "abd") == 1);
  CHECK(edit_distance("abc", "acb") == 1);
  CHECK(edit_distance("abc", "cab") == 2);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("one change for each two letters is near, one more is not", "[exam]") {
  CHECK(nearest_key("ab", {"ax"}) == "ax");
  CHECK(!nearest_key("ab", {"xy"}));
  CHECK(nearest_key("abcd", {"abxy"}) == "abxy");
  CHECK(!nearest_key("abcd", {"axyz"}));
  CHECK(nearest_key("abcde", {"abcxy"}) == "abcxy");
  CHECK(!nearest_key("abcde", {"abxyz"}));
}

TEST_CASE("keys of forty letters are compared, and no longer ones", "[exam]") {
  const std::string forty(40, 'a'), more = forty + "a";
  CHECK(nearest_key(forty, {forty}) == forty);
  CHECK(nearest_key(forty, {more}) == more);
  CHECK(!nearest_key(more, {forty}));
}
