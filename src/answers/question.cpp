#include <sstream>

#include "answers/commands.hpp"
#include "answers/motion.hpp"

namespace answers {
namespace {

using namespace notation;

Answer angle(const Request& request) {
  const Alpha alpha = alpha_of(request.text("alpha"));
  const auto turns = [&] {
    return Balls{right_side_at("rotation.psi", ball_of(alpha)) / Ball::pi()};
  };
  return {one_row({{"psi_over_pi", rounded(turns)[0]}})};
}

/// Where rho has the extremum that an elastic motion has at `near`, magic:k or deficient:k, for a
/// fraction below 1 as restitution, and the shift in percent. A search finds 7 decimals, no more.
Answer extremum(const Request& request) {
  const Alpha near = alpha_of(request.text("near"));
  const auto* at = std::get_if<Threshold>(&near);
  if (at == nullptr) throw InvalidInput("near: " + text(near) + "; allowed: magic:k, deficient:k");
  const Alpha restitution = alpha_of(request.text("restitution"));
  const auto* e = std::get_if<cln::cl_RA>(&restitution);
  if (e == nullptr || *e >= 1) throw InvalidInput("restitution: allowed: a fraction below 1");
  const auto rho_at = [&](double alpha) { return std::stod(rho(alpha, *e).text); };
  const double scale = std::pow(10, double(request.whole("decimals", 0, 7).value_or(7)));
  const double elastic = nearest(near);
  const double below = nearest(at->is_magic ? deficient(at->k) : magic(at->k + 1));
  double low = std::sqrt(below * elastic);
  double high = elastic / low * elastic;  // the extremum above is farther away than that below
  while (high - low > 1e-9) {             // rho is flat at a maximum: nearer, its last bits decide
    const double third = (high - low) / 3;
    const bool rises = rho_at(low + third) < rho_at(high - third);
    (rises == at->is_magic ? low : high) = rises == at->is_magic ? low + third : high - third;
  }
  const double place = std::round((low + high) / 2 * scale) / scale;
  return {one_row({{"alpha", real_cell(place)},
                   {"elastic", real_cell(elastic)},
                   {"shift", real_cell(std::round(1e5 * (place - elastic) / elastic) / 1e3)}})};
}

}  // namespace

std::map<std::string, std::string> answer_to(const std::string& question) {
  static const std::map<std::string, std::pair<Answer (*)(const Request&), Names>> commands{
      {"angle", {angle, {"alpha"}}},
      {"count", {count, {"alpha"}}},
      {"eval", {eval, {"alpha", "n", "tier", "digits"}}},
      {"extremum", {extremum, {"near", "restitution", "decimals"}}},
      {"ratios", {ratios, {"count", "digits"}}},
      {"terminal", {terminal, {"alpha", "restitution", "tier", "digits"}}}};
  std::istringstream words(question);
  std::string command, option, value;
  words >> command;
  const auto found = commands.find(command);
  if (found == commands.end())
    throw InvalidInput("no numbers answer \"" + question +
                       "\"; allowed: angle, count, eval, extremum, ratios, terminal");
  const auto& [answer, options] = found->second;
  Request request;
  while (words >> option) {
    if (std::ranges::count(options, option.erase(0, 2)) == 0 || !(words >> value))
      throw InvalidInput(command + ": no option, or no value: --" + option + "; allowed: --" +
                         joined(options, ", --"));
    request.options.emplace(option, value);
  }
  const Table table = answer(request).table;
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    cells.emplace(table.columns[i], table.rows.back()[i].text);
  return cells;
}

}  // namespace answers
