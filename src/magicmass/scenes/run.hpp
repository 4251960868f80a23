// What a scene needs, and its motion.
#pragma once

#include <functional>
#include <variant>

#include "magicmass/scenes/scene.hpp"
#include "magicmass/simulator/engine.hpp"

namespace magicmass::scenes {

struct Plan {
  std::string model;      ///< "theorem", "transfers" or "events"
  bool is_exact = false;  ///< in exact numbers, else in doubles
  std::string reason;
};

/// complete: no two approach any more. collapse: endless collisions in finite time. limited: else.
enum class Status { complete, limited, collapse };

std::string status_name(Status status);

using Number = std::variant<double, Surd>;
/// It, or what is near it; nothing where that is not finite or subnormal.
std::optional<double> double_of(const Number& number);

/// What a scene comes to.
struct Result {
  Plan plan;
  Status status = Status::complete;
  std::string why;                   ///< where not complete
  bool is_undecided = false;         ///< a decision was closer than could be told
  std::int64_t events = 0;           ///< collisions; nothing is said of them in a collapse
  std::vector<std::int64_t> counts;  ///< of them at each gap
  std::vector<Number> terminal;      ///< velocity of each body
  Number energy_before;              ///< kinetic
  Number energy;                     ///< at the end
  Number transmitted;  ///< the part of energy_before that the scene's receiver has at the end
  std::optional<Number> collapse_time, collapse_position;
  std::optional<simulator::Errors<double>> errors;  ///< in doubles: of all collisions that are sure
  std::optional<Number> known_until;  ///< the time up to which bodies go on so; nothing: for ever
};

using Row = simulator::Collision<Number>;
using Sink = std::function<void(const Row&)>;

/// By theorem where the scene is a Trio or a Cradle. Else it is stepped, in doubles, and again in
/// exact numbers where a decision was closer than doubles can tell. Throws InvalidInput where the
/// scene lacks exact numbers that are asked for, Undecided where they become too long.
Result run(const Scene& scene);
/// The same run once more, every so many of its collisions, in constant memory. A collapse ends
/// where its doubles have the time of its end, in exact numbers, too.
void stream(const Scene& scene, const Plan& plan, const Sink& sink, std::int64_t every = 1);

struct Point {
  Number time;
  std::size_t body;
  Number position;
};
using Points = std::function<void(const Point&)>;

/// All bodies at each of the scene's `times` at which the motion is known. Where the scene has
/// none, the corners of their lines: all bodies at time 0, those that meet at each collision that
/// the scene wants to see, and all where the run ends.
void trajectory(const Scene& scene, const Result& result, const Points& sink);

// What follows is for the files of this room.

/// Kinetic.
template <class X>
X energy(const std::vector<X>& masses, const std::vector<X>& velocities) {
  X sum = 0;
  for (std::size_t i = 0; i < masses.size(); ++i)
    sum = sum + masses[i] * velocities[i] * velocities[i];
  return sum / X(2);
}

inline constexpr const char* at_until = "the scene ends at the time `until`";
std::string at_limit(std::int64_t limit);

/// The run of a trio or a cradle, each number the nearest double; of few exact collisions only the
/// plan, since there numbers may be just between doubles. Nothing for other scenes, and where a
/// collision may be as late as `until`. Throws Undecided for too many of a trio without limits.
Found<Result> by_theorem(const Scene& scene, std::int64_t few = 64);
/// Every so many of its collisions; of a collapse at least the first three, and more while doubles
/// can tell their times apart; throws Undecided for more than 2^16 rows.
void stream_by_theorem(const Scene& scene, std::int64_t every, const Sink& sink);
/// Where its bodies are at a time, or at the last of so many collisions, the most that come
/// before it; nothing: a collapse, after which all go on together.
std::vector<double> places_by_theorem(const Scene& scene, std::optional<std::int64_t> most,
                                      const std::optional<Value>& time = {});

}  // namespace magicmass::scenes
