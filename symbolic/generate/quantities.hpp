// All that is generated: which theorems, on which intervals; quantities.txt says so.
#pragma once

#include "codegen/emit.hpp"

namespace generate {
using Texts = std::map<std::string, std::string>;  ///< by path below the folder
/// Writes all files beside their places, then renames them all. Throws std::runtime_error, naming
/// the file, where one cannot be written; then none has changed.
void write(const std::string& folder, const Texts& texts);
/// What differs, a line each: "PATH: differs", "PATH: is not there", "PATH: is not generated".
std::vector<std::string> differences(const std::string& folder, const Texts& texts);
/// Theorems of the book, with their ids.
class Source {
public:
  /// "evaluators.def_w def_t terminal.definitions/2": a word without a chapter is of the one before
  /// it, /2 is the theorem's part 2, counted from 0. Each is known by its id from now on.
  kernel::Theorems at(const std::string& words, const kernel::Substitution& terms);
  /// "DEFINITIONS -> OUTPUTS", of these terms in place of variables.
  codegen::Case of(const std::string& name, const std::vector<codegen::Condition>& where,
                   const std::string& words, const kernel::Substitution& terms);

  const kernel::Substitution units{{kernel::real("V"), 1}, {kernel::real("L"), 1}};
  codegen::Ids ids;
};
struct Inventory {
  Source source;
  std::vector<codegen::PlainForm> all;  ///< those of the form "evaluator" in DoubleDouble
};
/// Reads what quantities.txt explains at its head. Refused: an entry or a range of another kind.
Inventory read(const std::string& text);
/// Of quantities.txt.
const Inventory& inventory();
std::vector<codegen::Quantity> evaluators();
/// evaluators/*.hpp, evaluators/errors.txt, plain/*.hpp, exact/*.hpp below magicmass/, and
/// manifest.json. The same bytes from every run.
Texts texts(const std::vector<codegen::PlainForm>& all, const codegen::Ids& ids = {});
/// All of generated/.
Texts generated();
/// One header with the wanted outputs alone, in a plain form: closed, product, tangent, exact,
/// restitution; of these quantities, where some are named; with more code at the end. Throws
/// codegen::Refused for a form or an output that there is none of.
std::string selected(const std::string& form, const std::set<std::string>& outputs,
                     const std::set<std::string>& quantities = {}, const std::string& more = "");
}  // namespace generate
