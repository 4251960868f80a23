// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/rule_words.hpp"

#include <map>

namespace magicmass::render {

std::string rule_words(const std::string& rule) {
  static const std::map<std::string, std::string> sentences{
      {"law", "A law of physics, put in without proof"},
      {"definition", "A definition: a new name for what stands on the right"},
      {"hypothesis", "A supposition: whatever rests on it has it among its conditions"},
      {"identity", "Both sides have the same normal form"},
      {"linear combination", "Equations, multiplied by factors, are added up"},
      {"substitution", "Equations are put in; then both sides have the same normal form"},
      {"cancellation", "A factor that is not zero is divided out"},
      {"special case", "A general theorem with particular values of its symbols"},
      {"component", "One entry of an equation between columns"},
      {"cases", "Each possible case has its own theorem"},
      {"sign", "Each factor and each term has a known sign"},
      {"induction", "Induction: it holds at the first index, and with each index at the next"},
      {"equal cosines on [0, pi]", "Two angles from 0 to pi that have the same cosine are equal"},
      {"one angle in the last cycle",
       "The number of collisions leaves one angle that has this cosine"},
      {"last collision",
       "Collisions go on while the next two bodies approach: the last is found from the sign of a "
       "sine"},
      {"every other collision", "The collisions alternate, and A has the first"},
      {"a square that is zero", "A real number whose square is zero is zero"},
      {"smaller cosine on [0, pi]",
       "Of two angles from 0 to pi the one with the smaller cosine is the larger"},
      {"step by step, each with its own run",
       "Induction over the links, each with its own collisions"},
      {"limit", "The limit, from a form that is rational in what tends to zero"},
      {"signs by induction",
       "Induction: signs at the first index, and with each index at the next"},
      {"sums, term by term", "Two sums are compared term by term"},
      {"sum of what is positive",
       "The larger side minus the smaller one is a sum of terms that are known not to be negative"},
      {"condition proved", "A condition is proved elsewhere, so it is no condition any more"},
      {"the first and all later", "It holds for the first index, and for all later ones"},
      {"strict", "What is not larger and not equal is smaller"},
      {"ceiling", "A ceiling is the one whole number from its argument up to one above"},
      {"angle below pi", "Twice an arctangent, or a part of pi, is less than pi"},
      {"sign of a sine", "The sine is positive between 0 and pi, and negative from there to 2 pi"},
      {"series",
       "Both sides have the same series in sqrt(alpha), up to the last term on the right"},
      {"series of a count",
       "A whole number within one of what grows beyond all bounds grows like it"},
      {"threshold", "A count that is a ceiling changes where its argument is an integer"},
      {"step functions, piece by piece", "Step functions are compared on each piece of one period"},
  };
  const auto sentence = sentences.find(rule);
  return sentence == sentences.end() ? rule : sentence->second;
}

}  // namespace magicmass::render
