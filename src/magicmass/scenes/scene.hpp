// A scene: bodies on a line and what is asked of them, read from TOML; its numbers, exact or balls.
#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balls/ball.hpp"
#include "magicmass/numbers/errors.hpp"
#include "magicmass/simulator/line.hpp"
#include "notation/alpha.hpp"

namespace magicmass::scenes {

using balls::Ball, balls::NotCertain, balls::Surd;
using balls::decimal, balls::exact, balls::nearest_double;

/// A number as a scene writes it, kept as what it is, or a difference of two.
struct Value {
  std::string text;  ///< as it was written
  Surd number = 0;
  /// alpha_k or beta_k where it is no surd: then that, or minus that, is added.
  std::optional<notation::Threshold> ratio = {};
  int sign = 1;

  const Surd* exact() const { return ratio ? nullptr : &number; }
  bool is(const Surd& x) const { return !ratio && number == x; }
  bool is_positive() const;
  /// The nearest double. Throws Undecided where none is near.
  double to_double() const;
};

/// It as a double, or as what it is, which must be exact.
template <class Scalar>
Scalar number_of(const Value& value) {
  if constexpr (std::same_as<Scalar, double>)
    return value.to_double();
  else
    return *value.exact();
}

Value negative(const Value& x);
/// x - y, where it is known to be a value.
std::optional<Value> difference(const Value& x, const Value& y);
/// x / y, where it is known exactly; y is not 0.
std::optional<Surd> quotient(const Value& x, const Value& y);

/// What read_value takes, for messages.
inline constexpr std::string_view allowed_values =
    "a number, or in quotes a fraction 1/7, whole numbers with + - * / ^ and square roots like "
    "sqrt(5)-2, a hex float like 0x1.8p-3, magic:k, -magic:k, deficient:k";

/// A decimal point, an exponent or 0x: the nearest double. Else whole numbers, exactly.
/// Throws InvalidInput, one line that says what was wrong.
Value read_value(std::string_view text);
/// A number that TOML has read.
Value value_of(double number);
Value value_of(const notation::Alpha& ratio);

/// Throws Undecided for a ratio of the paper whose number is above 2^50.
Ball ball_of(const Value& value);

/// What is computed, with ever more bits until it is something. Throws Undecided, so many "bits
/// would be needed" and `otherwise`, above many times the bits of `digits` decimal digits.
auto with_bits(int digits, const auto& compute, const std::string& otherwise = "") {
  const int wanted = 4 * digits;
  const int most = 8192 + 4 * wanted;  // a double near 2^-1074 with its count takes some 3,000
  for (int bits = 128 + wanted; bits <= most; bits *= 2) {
    Ball::bits = bits;
    try {
      if (const auto result = std::optional(compute())) return *result;
    } catch (const NotCertain&) {
    }
  }
  throw Undecided("more than " + std::to_string(most) + " bits would be needed" + otherwise);
}

/// How many of the first `most` have what those after them do not have.
std::int64_t count_of(std::int64_t most, const auto& has) {
  std::int64_t count = 0, more = 1;
  const auto have = [&] { return more <= most - count && has(count + more - 1); };
  for (; have(); more *= 2) count += more;
  for (; more > 0; more /= 2)
    if (have()) count += more;
  return count;
}

/// It, or why it is not there.
template <class T>
struct Found : std::optional<T> {
  std::string why;
  Found(T found) : std::optional<T>(std::move(found)) {}
  Found(std::string reason) : why(std::move(reason)) {}
  Found(const char* reason) : why(reason) {}
};

/// Blocks A, B and a ball C between them; a block A, a ball C and a wall; any bodies.
enum class Kind { three_body, wall, chain };

struct Scene {
  std::string source;  ///< the file, for messages
  Kind kind = Kind::three_body;
  std::vector<Value> masses;  ///< from left to right
  std::vector<Value> positions, velocities;
  std::optional<Value> left_wall, right_wall;
  Value restitution = value_of(1);
  Value V = value_of(1);  ///< velocity of the first body, where `velocities` does not say
  Value L = value_of(1);  ///< from a ball to the next block or wall, where `positions` does not say
  Value gap = value_of(1);     ///< likewise from a block to the next ball in a chain
  std::string walls = "none";  ///< of a chain that is laid out: left, right, both
  std::vector<std::string> outputs = {"counts", "terminal"};
  std::int64_t every = 1;                     ///< of so many collisions one is shown
  std::vector<Value> times;                   ///< of a trajectory
  std::optional<Value> until;                 ///< the run stops after this time
  std::optional<std::int64_t> max_events;     ///< and after so many collisions
  bool is_exact = false;                      ///< in exact numbers, whatever the plan would be
  std::map<std::string, std::int64_t> lines;  ///< of the keys that the file has

  bool wants(const std::string& output) const { return std::ranges::count(outputs, output) != 0; }
  bool has(const std::string& key) const { return lines.count(key) != 0; }
  /// Of collisions that are stepped, or that would never end.
  std::int64_t limit() const { return std::min(max_events.value_or(1'000'000), INT64_MAX / 2); }
  /// At which end a body receives what the only one that moves, at the other end, hands on.
  std::optional<std::size_t> receiver() const;
};

/// Reads a file of at most 8 MiB. What is no scene, or has no meaning, is refused: throws
/// InvalidInput, `file:line: key: what; allowed: ...` on one line.
Scene read_scene(const std::string& path);
Scene parse_scene(std::string_view text, const std::string& source);

Scene mirrored(const Scene& scene);

/// A, C, B, where C is the ball; in a chain 1, 2, ..., of blocks and balls A_1, C_1, A_2, ...
std::string body_name(const Scene& scene, std::size_t body);
/// What the collisions at a gap are called: N_A, N_B for three bodies; by the names beside it else.
std::string gap_name(const Scene& scene, std::size_t gap);

/// Whether all values, be it times, are surds.
bool has_exact_numbers(const Scene& scene);
/// The bodies in doubles, or as Surd where all are exact. Throws Undecided if one fits no double.
template <class Scalar>
simulator::Line<Scalar> line_of(const Scene& scene);

/// Throws InvalidInput with the place of a key.
[[noreturn]] void refuse_key(const Scene& scene, const std::string& key, const std::string& what,
                             std::string_view allowed);
/// "; is gap meant?" of gpa: all but one or two neighbouring letters, or any that were left out,
/// fewer than half, are the same in one of the names; otherwise that.
std::string meant(const std::string& name, const std::vector<std::string>& names,
                  const std::string& otherwise = "");

}  // namespace magicmass::scenes
