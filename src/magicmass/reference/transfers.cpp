// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/transfers.hpp"

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/simulator/contact.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;

/// k of magic:k where the ball has that ratio to blocks of mass 1, else 0. magic:2 is sqrt(5) - 2 as well.
std::int64_t magic_index(const ExactValue& ball) {
  if (ball.secant_of % 2 == 1) return ball.secant_of / 2;
  if (ball.is_rational()) return ball.rational == 1 ? 1 : 0;
  return ball.radicand == 5 && ball.rational == -2 && ball.root == 1 ? 2 : 0;
}

/// Does the ball leave enough room? What chain.room has for the next block's way is L times what the first contact
/// leaves of a block's velocity. Equality is possible for rational ratios alone, or numbers that enclosures show to be
/// apart at some precision.
bool has_room(const ExactValue& ball, const FieldNumber& L, const FieldNumber& ahead) {
  if (magic_index(ball) == 1) return true;  // the next block does not move before the ball rests
  for (long precision = 64; precision <= 4096; precision *= 2) {
    const Interval alpha = enclosure(ball)(precision);
    const Interval left = collide(Interval(1), Interval(1), alpha, Interval(0)).first;
    const Interval moved = L.enclosed(precision) * left;
    const Sign sign = (ahead.enclosed(precision) - moved).sign();
    if (sign != Sign::open) return sign != Sign::negative;
  }
  return false;
}

bool is_same(const ExactValue& x, const ExactValue& y) {
  return x.rational == y.rational && x.root == y.root && x.radicand == y.radicand &&
         x.secant_of == y.secant_of;
}

}  // namespace

std::optional<std::string> why_no_cradle(const ExactLine& line) {
  const std::size_t bodies = line.masses.size();
  if (bodies < 3 || bodies % 2 == 0) return "it has no ball between each two blocks";
  if (!(line.restitution == FieldNumber(1))) return "contacts are not elastic";
  if (line.velocity(0).sign() <= 0) return "the first block does not move to the right";
  for (std::size_t i = 0; i < bodies; ++i) {
    const ExactValue& mass = line.masses[i];
    if (i > 0 && line.velocity(i).sign() != 0) return "more than one body moves";
    if (i % 2 == 0 && !(mass.is_rational() && mass.rational == 1))
      return "the blocks do not all have mass 1";
    if (i % 2 == 1 && magic_index(mass) == 0) return "a ball has no magic ratio";
  }
  struct Room {
    std::size_t ball;
    FieldNumber L, ahead;
  };
  std::optional<Room> known;  // a long chain has many balls of few kinds
  for (std::size_t ball = 1; ball < bodies; ball += 2) {
    const FieldNumber L = line.position(ball + 1) - line.position(ball);
    if (L.sign() <= 0) return "a ball touches the next block";
    const bool last = ball + 2 == bodies;
    if (last && !line.right_wall) continue;
    const FieldNumber next = last ? *line.right_wall : line.position(ball + 2);
    FieldNumber ahead = next - line.position(ball + 1);
    const bool is_as_before = known && known->L == L && known->ahead == ahead &&
                              is_same(line.masses[known->ball], line.masses[ball]);
    if (is_as_before) continue;
    known = Room{ball, L, ahead};
    if (!has_room(line.masses[ball], L, ahead))
      return "a block reaches the next ball before the ball behind it is at rest";
  }
  return std::nullopt;
}

CradleEnd run_cradle(const ExactLine& line, const cl_I& most_contacts) {
  const Line<FieldNumber> g = line.geometry();
  const std::size_t last = line.masses.size() - 1;
  const FieldNumber V = g.velocities[0];
  CradleEnd end;
  // The way of the mover, unfolded: its length at the start of each straight piece.
  FieldNumber way(0);
  FieldNumber from = g.positions[0];
  const auto by = [&](const FieldNumber& length) {
    return !line.until || !(V * *line.until < length);
  };
  for (;;) {
    const bool right = end.direction > 0;
    const bool at_end = end.mover == (right ? last : 0);
    if (at_end) {
      const auto& wall = right ? g.right_wall : g.left_wall;
      if (!wall) {
        end.complete = true;
        return end;
      }
      const FieldNumber length = way + (right ? *wall - from : from - *wall);
      if (end.contacts + 1 > most_contacts || !by(length)) return end;
      way = length;
      from = *wall;
      end.contacts = end.contacts + 1;
      end.direction = -end.direction;
      if (!right) end.round_trips = end.round_trips + 1;
      continue;
    }
    const std::size_t ball = right ? end.mover + 1 : end.mover - 1;
    const cl_I contacts = 2 * cl_I(static_cast<long>(magic_index(line.masses[ball])));
    // To the right it is over before the mover is at the next thing ahead, or 2 L beyond the ball's place; to the left, as
    // the same motion backwards, when the mover is where the ball was at the start.
    const FieldNumber& place = g.positions[ball];
    const FieldNumber beyond = place + FieldNumber(2) * (g.positions[ball + 1] - place);
    const FieldNumber over = !right ? place : ball + 2 <= last ? g.positions[ball + 2] : beyond;
    const FieldNumber length = way + (right ? over - from : from - over);
    if (end.contacts + contacts > most_contacts) return end;
    if (!by(length)) {
      // It begins at the ball: at its place, or to the left where it was left behind, which is not beyond `over` to the right.
      const FieldNumber& rest = ball + 2 <= last ? g.positions[ball + 2] : beyond;
      end.is_whole = !by(way + (right ? place - from : from - rest));
      return end;
    }
    end.contacts = end.contacts + contacts;
    end.transfers = end.transfers + 1;
    end.mover = right ? end.mover + 2 : end.mover - 2;
  }
}

}  // namespace magicmass::reference
