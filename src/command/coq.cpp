#include "answers/derivation.hpp"
#include "command/files.hpp"
#include "coq/files.hpp"
#include "derivation/book.hpp"
#include "host/child.hpp"

namespace command {
namespace {

using namespace answers;

const std::string step = "\nLemma s'";  // one each in the files

coq::Files all_files() {
  std::vector<coq::Chapter> chapters;
  for (const derivation::Chapter& chapter : derivation::the_book().chapters()) {
    chapters.push_back({chapter.name, {}});
    for (const auto& s : chapter.statements) chapters.back().shown.emplace_back(s.id, s.theorem);
  }
  return coq::files(chapters);
}

}  // namespace

Answer derive(const Request& request) {
  if (request.format != "coq") return answers::derive(request);
  if (!request.words.empty() || request.has("from") || request.has("list"))
    throw InvalidInput("derive: --format coq is the whole derivation, without names or --from");
  const std::string folder = request.text("output");
  if (folder.empty() || folder == "-")
    throw InvalidInput("derive: --format coq is a folder of files; allowed: -o FOLDER");
  return write_folder("derive: -o", folder, [] {
    const auto texts = all_files().texts;
    return generate::Texts{texts.begin(), texts.end()};
  });
}

Answer verify(const Request& request) {
  if (request.has("with") && host::end_of({"coqc", "--version"}).code == host::not_there)
    throw InvalidInput("verify: --with coq needs coqc (Debian: coq); allowed: no --with");
  Answer answer = answers::verify(request);
  if (!request.has("with") || answer.check_failed) return answer;
  const coq::Files files = all_files();
  const host::TemporaryFolder folder("verify");
  generate::write(folder.path, {files.texts.begin(), files.texts.end()});
  std::string problem, last;
  std::size_t checked = 0;
  for (const auto& [name, text] : files.texts) {
    const host::End said = host::end_of(
        {"coqc", "-q", "-w", "none", "-R", folder.path, "Magicmass", folder.path + "/" + name});
    last = said.output;
    if (said.code != 0) {
      problem = name + ": " + said.errors;
      break;
    }
    for (auto at = text.find(step); at != text.npos; at = text.find(step, at + 1)) ++checked;
  }
  if (problem.empty()) {
    problem = coq::foreign_assumption(last);
    if (!problem.empty()) checked = 0;  // all rests on it
  }
  answer.check_failed = !problem.empty();
  if (!problem.empty()) answer.note = "verify: not checked by Coq: " + shown_text(problem, 400);
  answer.table.columns.insert(answer.table.columns.end(), {"checked_by_coq", "kernel_only"});
  answer.table.rows[0].push_back(whole_cell(checked));
  answer.table.rows[0].push_back(whole_cell(std::size_t(files.steps) - checked));
  return answer;
}

}  // namespace command
