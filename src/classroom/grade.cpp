// The answers of a class: a folder for each student, a file for each answer.
#include "classroom/classroom.hpp"

namespace classroom {
namespace {

/// Letters in UTF-8, such as names of people have: none that directs the text around it.
const std::string letters =
    "([ -~]"
    "|(?!\xD8\x9C)[\xC3-\xDF][\x80-\xBF]"                       // U+00C0, not U+061C
    "|\xE0[\xA0-\xBF][\x80-\xBF]|\xE1[\x80-\xBF]{2}"            // U+0800 to U+1FFF
    "|[\xE3-\xEC][\x80-\xBF]{2}|\xED[\x80-\x9F][\x80-\xBF])*";  // U+3000 to U+D7FF

/// Text of others, if any: in CSV no field begins as a spreadsheet's formula, with ; between, too.
answers::Cell cell_of(const Request& request, std::string text) {
  if (text.empty()) return answers::missing_cell();
  if (request.format != "csv") return text_cell(text);
  if (text.find_first_of("=+-@") == 0) text.insert(0, "'");
  std::ranges::replace(text, ';', ',');
  return text_cell(text);
}

/// Folders, and links to some, of which nothing is read.
std::set<std::filesystem::path> students_of(const std::string& place) {
  std::error_code error;
  std::set<std::filesystem::path> students;
  for (const auto& entry : std::filesystem::directory_iterator(place, error)) {
    std::error_code ignored;  // a link to itself
    if (entry.is_directory(ignored) && !entry.path().filename().string().starts_with('.'))
      students.insert(entry.path());
  }
  if (students.empty())
    throw InvalidInput("learn grade: no folders of students in " + answers::shown_text(place, 200) +
                       (error ? ": " + error.message() : ""));
  if (students.size() > 1000)  // as the command's help says
    throw answers::Undecided("learn grade: " + std::to_string(students.size()) +
                             " students are more than are graded at once; at most 1000");
  return students;
}

}  // namespace

const Exercise& named(const std::vector<Exercise>& all, const std::string& id) {
  const auto found = std::ranges::find(all, id, &Exercise::id);
  if (found != all.end()) return *found;
  throw InvalidInput("learn: no exercise " + answers::shown_text(id) +
                     learn::meant(id, answers::texts_of(all, &Exercise::id), "; see learn list"));
}

Answer grade(const Request& request, const std::vector<Exercise>& all, const learn::Run& run) {
  if (request.words.size() != 2)
    throw InvalidInput("learn grade: give one folder, which has a folder for each student");
  const bool is_why = request.has("why"), is_summary = request.has("summary");
  if (is_why && is_summary) throw InvalidInput("learn grade: --why or --summary, not both");
  const learn::Texts only = learn::split(request.text("only"), ',');
  for (const std::string& id : only) named(all, id);
  std::vector<Exercise> exercises = all;
  if (!only.empty())
    std::erase_if(exercises, [&](const auto& e) { return std::ranges::count(only, e.id) == 0; });
  answers::Table marks{{"student"}, {}};
  answers::Table why{{"student", "id", "verdict", "feedback", "misconception"}, {}};
  answers::Table summary{{"id", "misconception", "students"}, {}};
  for (const Exercise& e : exercises) marks.columns.push_back(e.id);
  std::map<std::pair<std::size_t, std::string>, int> had;  // by exercise and misconception
  for (const std::filesystem::path& student : students_of(request.words[1])) {
    const std::string name = student.filename();
    const bool is_unusual = learn::matched(name, letters).empty();
    const auto shown = cell_of(request, is_unusual ? answers::shown_text(name) : name);
    answers::Row& row = marks.rows.emplace_back(answers::Row{shown});
    for (std::size_t i = 0; i < exercises.size(); ++i) {
      const std::optional<Judgement> said = judged_file(exercises[i], student, run);
      row.push_back(text_cell(said ? word(said->mark) : "missing"));
      if (!said) continue;
      if (!said->misconception.empty()) ++had[{i, said->misconception}];
      why.rows.push_back({shown, text_cell(exercises[i].id), row.back(),
                          cell_of(request, said->feedback), cell_of(request, said->misconception)});
    }
    std::set<std::string> there;  // of what may be a great many
    if (std::error_code error; !std::filesystem::is_symlink(student, error))
      for (const auto& entry : std::filesystem::directory_iterator(student, error))
        if (there.size() < 1000) there.insert(entry.path().filename());
    for (const std::string& file : there)
      if (const auto said = misnamed(file, all))
        why.rows.push_back({shown, cell_of(request, answers::shown_text(file)), text_cell("unread"),
                            cell_of(request, *said), answers::missing_cell()});
  }
  for (const auto& [which, students] : had)
    summary.rows.push_back({text_cell(exercises[which.first].id), cell_of(request, which.second),
                            answers::whole_cell(students)});
  std::ranges::stable_sort(summary.rows, [](const auto& a, const auto& b) {
    return std::stoi(a[2].text) > std::stoi(b[2].text);
  });
  return {is_why ? why : is_summary ? summary : marks, {}};
}

}  // namespace classroom
