// SPDX-License-Identifier: GPL-2.0-or-later
#include "typed_oracle.hpp"

#include <cctype>
#include <cmath>
#include <stdexcept>

namespace {

using Function = long double (*)(long double);

const std::map<std::string, Function>& functions() {
  static const std::map<std::string, Function> all{
      {"sqrt", [](long double x) { return std::sqrt(x); }},
      {"sin", [](long double x) { return std::sin(x); }},
      {"cos", [](long double x) { return std::cos(x); }},
      {"tan", [](long double x) { return std::tan(x); }},
      {"sec", [](long double x) { return 1 / std::cos(x); }},
      {"acos", [](long double x) { return std::acos(x); }},
      {"atan", [](long double x) { return std::atan(x); }}};
  return all;
}

class TypedReader {
public:
  TypedReader(const std::string& text, const Point& point) : text_(text), point_(point) {}

  long double all() {
    const long double value = sum();
    if (next() != '\0') refuse();
    return value;
  }

private:
  [[noreturn]] void refuse() const {
    throw std::runtime_error("the oracle cannot read " + text_ + " from " + std::to_string(at_));
  }
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  bool starts_factor() {
    const char c = next();
    return c == '(' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  }

  long double sum() {
    long double value = take('-') ? -product() : product();
    while (true) {
      if (take('+'))
        value += product();
      else if (take('-'))
        value -= product();
      else
        return value;
    }
  }
  long double product() {
    long double value = factor();
    while (true) {
      if (take('*'))
        value *= factor();
      else if (take('/'))
        value /= factor();
      else if (starts_factor())
        value *= factor();
      else
        return value;
    }
  }
  long double factor() {
    if (take('-')) return -factor();
    const long double base = atom();
    return take('^') ? std::pow(base, factor()) : base;
  }
  long double atom() {
    if (take('(')) {
      const long double value = sum();
      if (!take(')')) refuse();
      return value;
    }
    const std::size_t start = at_;
    if (std::isdigit(static_cast<unsigned char>(next())) != 0) {
      std::size_t length = 0;
      const long double value = std::stold(text_.substr(at_), &length);
      at_ += length;
      return value;
    }
    while (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_') ++at_;
    return named(start, text_.substr(start, at_ - start));
  }
  long double named(std::size_t start, std::string name) {
    if (const auto found = functions().find(name); found != functions().end())
      return found->second(factor());  // atan sqrt(2): the argument needs no parentheses
    if (const auto found = point_.find(name); found != point_.end()) return found->second;
    while (!name.empty() && !point_.contains(name)) name.pop_back();  // M_2u_2 is M_2 and u_2
    if (name.empty()) refuse();
    at_ = start + name.size();
    return point_.at(name);
  }

  const std::string text_;
  const Point& point_;
  std::size_t at_ = 0;
};

}  // namespace

long double oracle_value(const std::string& typed, Point point) {
  point["pi"] = std::acos(-1.0L);
  if (point.contains("alpha")) {
    const long double alpha = point["alpha"];
    point["psi"] = 2 * std::acos(1 / (1 + alpha));
    point["theta"] = 2 * std::atan(std::sqrt(alpha));
    if (point.contains("V")) point["V_CM"] = point["V"] / (2 + alpha);
  }
  if (point.contains("u_1") && !point.contains("e")) {  // an elastic contact: mirrored at the mean
    const long double mean =
        (point["M_1"] * point["u_1"] + point["M_2"] * point["u_2"]) / (point["M_1"] + point["M_2"]);
    point["v_1"] = 2 * mean - point["u_1"];
    point["v_2"] = 2 * mean - point["u_2"];
  }
  return TypedReader(typed, point).all();
}
