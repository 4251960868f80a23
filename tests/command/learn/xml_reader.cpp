// SPDX-License-Identifier: GPL-2.0-or-later
#include "xml_reader.hpp"

#include <cctype>
#include <stdexcept>

namespace {

class Reader {
public:
  explicit Reader(const std::string& text) : text_(text) {}

  XmlElement document() {
    if (text_.starts_with("<?xml")) at_ = text_.find("?>") + 2;
    skip_blanks();
    XmlElement root = element();
    skip_blanks();
    if (at_ != text_.size()) fail("something after the root");
    return root;
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("at " + std::to_string(at_) + ": " + what);
  }
  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() {
    while (std::isspace(static_cast<unsigned char>(now())) != 0) ++at_;
  }
  void take(char c) {
    if (now() != c) fail(std::string("expected ") + c);
    ++at_;
  }
  std::string name() {
    std::string result;
    while (std::isalnum(static_cast<unsigned char>(now())) != 0 || now() == '_')
      result += text_[at_++];
    if (result.empty()) fail("a name is expected");
    return result;
  }
  std::string entity() {
    static const std::map<std::string, std::string> known{
        {"&lt;", "<"},   {"&gt;", ">"},  {"&amp;", "&"}, {"&quot;", "\""},
        {"&apos;", "'"}, {"&#39;", "'"}, {"&#x27;", "'"}};
    const std::size_t end = text_.find(';', at_);
    const auto found =
        end == std::string::npos ? known.end() : known.find(text_.substr(at_, end + 1 - at_));
    if (found == known.end()) fail("an unknown entity");
    at_ = end + 1;
    return found->second;
  }
  std::string characters(char end) {
    std::string result;
    while (now() != end && now() != '<' && now() != '\0') {
      if (static_cast<unsigned char>(now()) < 0x20 && now() != '\n' && now() != '\t')
        fail("control");
      if (now() == '&')
        result += entity();
      else
        result += text_[at_++];
    }
    return result;
  }

  XmlElement element() {
    take('<');
    XmlElement result{name(), {}, "", {}};
    for (skip_blanks(); now() != '>'; skip_blanks()) {
      const std::string attribute = name();
      take('=');
      take('"');
      result.attributes[attribute] = characters('"');
      take('"');
    }
    take('>');
    while (!text_.substr(at_, 2).starts_with("</")) {
      if (now() == '\0') fail("the end of " + result.name + " is missing");
      if (now() == '<')
        result.children.push_back(element());
      else
        result.text += characters('<');
    }
    at_ += 2;
    if (name() != result.name) fail("another end than that of " + result.name);
    take('>');
    return result;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<const XmlElement*> XmlElement::all(const std::string& child) const {
  std::vector<const XmlElement*> found;
  for (const XmlElement& one : children)
    if (one.name == child) found.push_back(&one);
  return found;
}

const XmlElement& XmlElement::one(const std::string& child) const {
  const auto found = all(child);
  if (found.size() != 1)
    throw std::runtime_error(name + " has " + std::to_string(found.size()) + " of " + child);
  return *found.front();
}

std::string XmlElement::text_in(const std::string& child) const {
  return one(child).one("text").text;
}

XmlElement read_xml(const std::string& document) { return Reader(document).document(); }
