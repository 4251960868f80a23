// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// What is wrong with `value` by a JSON schema, each complaint with its place ("/0/alpha: ..."); empty if nothing is.
/// Knows the keywords that our schemas use: type, enum, minimum, properties, required, additionalProperties, items,
/// anyOf, $ref to $defs. Throws std::invalid_argument for any other, so that none is silently ignored.
std::vector<std::string> complaints(const nlohmann::json& schema, const nlohmann::json& value);
