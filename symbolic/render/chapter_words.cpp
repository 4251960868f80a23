// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/chapter_words.hpp"

#include <map>

namespace magicmass::render {

ChapterWords chapter_words(const std::string& chapter) {
  static const std::map<std::string, ChapterWords> chapters{
      {"contact",
       {"One contact",
        "Two bodies meet: momentum and kinetic energy are conserved. That makes the velocities "
        "after the contact "
        "a linear function of those before, the matrix Gamma, which is a reflection of the "
        "plane."}},
      {"cycle",
       {"One cycle",
        "A hits C, then C hits B. The two contacts together act on the vector (a, b, sqrt(alpha) "
        "c') as one "
        "rotation of space, Lambda."}},
      {"rotation",
       {"Axis and angle",
        "The axis of Lambda stays where it is; in a frame R that has it as third axis, Lambda "
        "turns by the angle "
        "psi."}},
      {"power",
       {"All velocities",
        "A rotation done n times turns n times as far: that gives Lambda^n, and with the initial "
        "condition every "
        "velocity in closed form."}},
      {"chebyshev",
       {"Velocities as polynomials",
        "The cosines of multiples of psi/2 are polynomials in cos(psi/2), which is rational in "
        "alpha: so the "
        "velocities are rational functions of alpha."}},
      {"counting",
       {"How many collisions",
        "Two bodies meet again while they approach. The approach speeds are sines of multiples of "
        "psi/2, and the "
        "first that is not positive ends the collisions."}},
      {"ratios",
       {"Magic and deficient mass ratios",
        "The mass ratios alpha_k and beta_k at which the counts change are those at which B takes "
        "everything, and "
        "those at which C ends up moving with B."}},
      {"terminal",
       {"After the last collision",
        "The counts confine the angles of the last collisions, and with them the signs of the "
        "sines: who still moves away from whom, and how fast each body ends up."}},
      {"minima",
       {"Why the deficient ratios are minima",
        "On both sides of beta_k block B ends up faster than at beta_k itself. No derivative is "
        "needed: differences of products of cosines are products of sines."}},
      {"restitution",
       {"Contacts that lose energy",
        "Momentum is conserved, and a contact leaves the part e of the relative velocity. One "
        "cycle "
        "is still a linear map, but no rotation: it shrinks as it turns."}},
      {"wedge",
       {"Any masses, any restitution",
        "The approach speeds before one collision after the other obey one recurrence, whatever "
        "the "
        "masses: they are sines of multiples of one angle h, the angle of the wedge, times powers "
        "of sqrt(e)."}},
      {"special_cases",
       {"What the wedge theorem holds",
        "Equal blocks give the paper's inelastic case, e = 1 gives all that was proved before, and "
        "a block of infinite mass is a wall: then collisions count the digits of pi."}},
      {"collapse",
       {"Collisions without end",
        "Where the cosine of the wedge's angle would not be below one, the bodies always approach "
        "again: infinitely many collisions in a finite time."}},
      {"inelastic_end",
       {"The end between equal blocks",
        "What restitution leaves after the last collision, or the time at which collisions have "
        "collapsed, written so that a computer loses no digits."}},
      {"transmission",
       {"What reaches B",
        "The fraction of the energy that B takes when some is lost in every collision, as one "
        "formula for both ways to end."}},
      {"small_alpha",
       {"Light balls",
        "As alpha tends to zero, psi is about 2 sqrt(2 alpha), and the number of collisions grows "
        "as 1/sqrt(alpha)."}},
      {"times",
       {"When and where",
        "From the velocities between collisions follow the times of all collisions and the "
        "distances between the "
        "blocks then."}},
      {"tangent",
       {"One sine and one cosine",
        "With t = tan(psi/4), the sine and the cosine of n psi/2 give all four velocities as "
        "products, and those of j psi/2 the time and the place of collision j."}},
      {"offset",
       {"The last cycle's offset",
        "After the last collision N_A psi/2 is within psi/4 of a quarter turn. In the sine and the "
        "cosine of that small offset the terminal velocities are one formula, whichever collision "
        "is the last."}},
      {"fixed_n",
       {"The first cycles",
        "For a given n the velocities are rational functions of alpha. In factors, each over its "
        "powers of 1 + alpha, they are accurate at their zeros and overflow nowhere."}},
      {"orthogonal",
       {"Orthogonal matrices",
        "What keeps all lengths is a rotation, or a rotation times a reflection."}},
      {"frame",
       {"Triads and rotations about an axis",
        "A right-handed triad makes a matrix, and with it the rotation about any axis."}},
      {"mapping",
       {"The billiard ball",
        "Velocities times the square roots of the masses make the velocity of one billiard ball, "
        "and collisions "
        "are its reflections at the walls of a wedge."}},
      {"table",
       {"The trigonometric table",
        "Cosines, sines and tangents of theta, psi and their parts, in terms of alpha."}},
      {"multiples",
       {"Multiple angles",
        "Cosines and sines of n x as sums of powers, and at half and quarter steps between."}},
      {"unfolding",
       {"The unfolded wedge",
        "Reflect the wedge instead of the ball: the motion becomes one straight line, and when and "
        "where can be "
        "read off it."}},
      {"chain",
       {"A chain of magic balls",
        "Equal blocks with a ball of some magic mass ratio between each two: what comes in at one "
        "end leaves at "
        "the other."}},
  };
  const auto words = chapters.find(chapter);
  return words == chapters.end() ? ChapterWords{chapter, ""} : words->second;
}

}  // namespace magicmass::render
