// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

/// What keeps a page from being well-formed XML (tags nest and close, attributes are quoted, no bare & or <), with the
/// place; empty if nothing does. Behind a document type only elements, text, and the five named entities and
/// numeric ones.
std::string xml_error(std::string_view page);
