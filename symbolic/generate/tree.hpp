// A folder of files, written whole or compared.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace generate {
using Texts = std::map<std::string, std::string>;  ///< by path below the folder
/// Writes all files beside their places, then renames them all. Throws std::runtime_error, naming
/// the file, where one cannot be written; then none has changed.
void write(const std::string& folder, const Texts& texts);
/// What differs, a line each: "PATH: differs", "PATH: is not there", "PATH: is not generated".
std::vector<std::string> differences(const std::string& folder, const Texts& texts);
}  // namespace generate
