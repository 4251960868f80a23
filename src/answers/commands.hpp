// Commands that answer in numbers or decide, questions in their words, the data of figures.
#pragma once

#include "answers/request.hpp"

namespace answers {

/// Velocities after n cycles: options alpha, n, tier (fast, accurate, exact), digits. Throws
/// InvalidInput for n above N_A, Undecided for exact fractions that would be too long. Columns a
/// and c: just after P_n, in units of V; b and c_prime: just after Q_n.
Answer eval(const Request& request);

Answer count(const Request& request);

/// Terminal velocities in units of V and rho, B's share of the energy: options alpha, tier, digits,
/// restitution. Where collisions never end, collapse_time is when they do, in units of L/V, and the
/// velocities are from then on; exact fractions throw Undecided there.
Answer terminal(const Request& request);

/// The same answers for many rows at once, bit for bit, where a mass ratio is a double and the tier
/// is fast or accurate; others, and those refused, have none here. Columns have names in any case.
Block eval_block(const Rows& rows);
Block count_block(const Rows& rows);
Block terminal_block(const Rows& rows);

/// Magic and deficient mass ratios 1 to count, in radicals, too, where the book has them.
Answer ratios(const Request& request);

/// Are two expressions equal? Two words, and the option domain. The check fails where they differ;
/// undecided has exit code 3. Throws InvalidInput for what cannot be read.
Answer equal(const Request& request);

/// The model that one scene's file needs, and why.
Answer plan(const Request& request);
/// A scene's motion. CSV and JSON Lines are its collisions, a row each, or where it wants no events
/// but a trajectory, that; text and JSON begin with what it comes to. Rows come as they are found.
Answer simulate(const Request& request);

/// A question of an exercise or of the table of the paper's numbers, written as a command's words,
/// "count --alpha 3/25": the cells of the last row of its answer, by their columns' names. Besides
/// commands: "angle --alpha 1", and "extremum --near magic:2 --restitution 9/10" of rho. Throws
/// InvalidInput where the command is none of those that answer in numbers.
std::map<std::string, std::string> answer_to(const std::string& question);

struct Figure {
  std::string name;
  Table (*data)();
};
/// Figures and their data, in the order of the paper.
const std::vector<Figure>& figures();

}  // namespace answers
