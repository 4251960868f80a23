// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

/// An element of an XML document: as much XML as a quiz has.
struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  // entities replaced, without the children's
  std::vector<XmlElement> children;

  /// The children of that name.
  std::vector<const XmlElement*> all(const std::string& child) const;
  /// The one child of that name. Throws std::runtime_error where there is none, or more than one.
  const XmlElement& one(const std::string& child) const;
  /// The text in the one child's <text>.
  std::string text_in(const std::string& child) const;
};

/// Throws std::runtime_error for what is not well-formed.
XmlElement read_xml(const std::string& document);
