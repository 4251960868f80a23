// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/breaking.hpp"

namespace magicmass::render {
namespace {

using Kind = Formula::Kind;

class Breaker {
public:
  Breaker(const WidthOf& width, double room) : width_(width), room_(room) {}

  void take(const Formula& formula, const std::string& sign, bool factor) {
    if (width_(formula) <= room_) {
      pieces_.push_back({sign, formula, factor});
      return;
    }
    switch (formula.kind) {
      case Kind::negative:
        if (sign.ends_with('-') || factor) break;
        return take(formula.parts[0], sign.empty() || sign == "+" ? "-" : sign + " -", factor);
      case Kind::sum:
        return factor || sign.ends_with('-') ? take_group(formula, sign)
                                             : take_terms(formula, sign);
      case Kind::product:
        return take_factors(formula, sign);
      case Kind::quotient:
        return take_quotient(formula, sign, factor);
      default:
        break;
    }
    pieces_.push_back({sign, formula, factor});
  }

  std::vector<Piece> result() { return std::move(pieces_); }

private:
  const WidthOf& width_;
  double room_;
  std::vector<Piece> pieces_;

  void take_terms(const Formula& sum, const std::string& sign) {
    bool first = true;
    for (const Formula& term : sum.parts) {
      const bool negative = term.kind == Kind::negative;
      if (first)
        take(term, sign, false);
      else
        take(negative ? term.parts[0] : term, negative ? "-" : "+", false);
      first = false;
    }
  }

  void take_group(const Formula& sum, const std::string& sign) {
    const std::size_t begin = pieces_.size();
    take_terms(sum, "");
    if (!sign.empty()) pieces_[begin].sign = sign;
    ++pieces_[begin].opens;
    ++pieces_.back().closes;
  }

  void take_factors(const Formula& product, const std::string& sign) {
    bool first = true;
    for (const Formula& part : product.parts) {
      take(part, first ? sign : "", true);
      first = false;
    }
  }

  /// What is wide above the line moves behind it.
  void take_quotient(const Formula& quotient, const std::string& sign, bool factor) {
    const Formula& above = quotient.parts[0];
    const Formula& below = quotient.parts[1];
    const Formula one{.kind = Kind::number, .text = "1"};
    if (above.kind == Kind::sum)
      return take_factors({.kind = Kind::product,
                           .parts = {{.kind = Kind::quotient, .parts = {one, below}}, above}},
                          sign);
    if (above.kind == Kind::product) {
      Formula narrow{.kind = Kind::product};
      Formula moved{.kind = Kind::product};
      for (const Formula& part : above.parts)
        (part.kind == Kind::sum && width_(part) > room_ / 3 ? moved : narrow).parts.push_back(part);
      if (!moved.parts.empty()) {
        if (narrow.parts.empty()) narrow.parts.push_back(one);
        const Formula front = narrow.parts.size() == 1 ? narrow.parts[0] : narrow;
        moved.parts.insert(moved.parts.begin(), {.kind = Kind::quotient, .parts = {front, below}});
        return take_factors(moved, sign);
      }
    }
    pieces_.push_back({sign, quotient, factor});
  }
};

}  // namespace

std::vector<Piece> pieces(const Formula& formula, const WidthOf& width, double room) {
  Breaker breaker(width, room);
  if (formula.kind != Kind::relation) {
    breaker.take(formula, "", false);
    return breaker.result();
  }
  for (std::size_t i = 0; i < formula.parts.size(); ++i)
    breaker.take(formula.parts[i], i == 0 ? "" : formula.signs[i - 1], false);
  return breaker.result();
}

}  // namespace magicmass::render
