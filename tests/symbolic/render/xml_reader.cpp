// SPDX-License-Identifier: GPL-2.0-or-later
#include "xml_reader.hpp"

#include <regex>
#include <vector>

namespace {

bool entities_are_known(const std::string& text) {
  static const std::regex known("&(amp|lt|gt|quot|apos|#[0-9]+|#x[0-9A-Fa-f]+);");
  return std::regex_replace(text, known, "").find('&') == std::string::npos;
}

}  // namespace

std::string xml_error(std::string_view page) {
  static const std::regex tag(
      "<(/?)([A-Za-z][A-Za-z0-9]*)((\\s+[A-Za-z][A-Za-z-]*=\"[^\"<]*\")*)\\s*(/?)>");
  if (page.starts_with("<!DOCTYPE html>")) page.remove_prefix(15);
  std::vector<std::string> open;
  bool had_root = false;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t begin = std::min(page.find('<', at), page.size());
    const std::string text(page.substr(at, begin - at));
    const std::string place = " near: " + std::string(page.substr(at, 60));
    if (!entities_are_known(text)) return "bare &" + place;
    if (open.empty() && text.find_first_not_of(" \n\t") != std::string::npos)
      return "text outside" + place;
    if (begin == page.size()) break;
    const std::size_t end = page.find('>', begin);
    if (end == std::string_view::npos) return "tag is not closed" + place;
    const std::string whole(page.substr(begin, end + 1 - begin));
    std::smatch parts;
    if (!std::regex_match(whole, parts, tag)) return "bad tag " + whole;
    if (!entities_are_known(parts[3])) return "bare & in " + whole;
    if (parts[1].length() == 0) {
      if (open.empty() && had_root) return "two roots at " + whole;
      had_root = true;
      if (parts[5].length() == 0) open.push_back(parts[2]);
    } else {
      if (open.empty() || open.back() != parts[2]) return whole + " closes nothing" + place;
      open.pop_back();
    }
    at = end + 1;
  }
  return open.empty() ? "" : open.back() + " is never closed";
}
