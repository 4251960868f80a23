#include <filesystem>

#include "command/files.hpp"
#include "host/child.hpp"
#include "host/embedded.hpp"
#include "learn/exercise.hpp"
#include "report/report.hpp"

namespace command {
namespace {

using namespace answers;

std::string script_of(const std::string& figure) {
  return host::embedded().at("figures/" + figure + ".gp");
}

/// What a script says of its figure in lines "# KEY ...": title, description, size.
std::string told(const std::string& script, const std::string& key) {
  const std::string begin = "# " + key + " ";
  std::string text;
  for (const std::string& line : learn::fields(script, '\n'))
    if (line.starts_with(begin)) text += (text.empty() ? "" : " ") + line.substr(begin.size());
  return text;
}

/// What gnuplot prints for a script and its data; both and the picture are passed in memory.
std::string drawn(const std::string& script, const std::string& data, const std::string& format) {
  const std::string input = "format = '" + format + "'\nsize = '" + told(script, "size") + "'\n" +
                            host::embedded().at("terminal.gp") + "$data << END\n" + data + "END\n" +
                            script;
  ::unsetenv("GNUTERM");  // the user's own, as is what -d leaves out
  const host::End said = host::end_of({"gnuplot", "-d", "-"}, input);
  if (said.code == host::not_there)
    throw InvalidInput(
        "figure: drawing needs gnuplot (Debian: gnuplot-nox); allowed without it: --format csv");
  if (said.code != 0)
    throw std::runtime_error("figure: gnuplot could not draw: " + shown_text(said.errors, 200));
  return said.output;
}
/// gnuplot's own title and description, which name its version, give way to the figure's.
std::string described(std::string svg, const std::string& script) {
  const std::string last = "</desc>";
  const std::size_t begin = svg.find("<title>");
  const std::size_t end = svg.find(last);
  const std::size_t root = svg.find("<svg");
  if (root > begin || begin > end || end == std::string::npos)
    throw std::runtime_error("figure: gnuplot wrote an SVG without a title and a description");
  svg.replace(begin, end + last.size() - begin,
              "<title id=\"title\">" + told(script, "title") + "</title>\n<desc id=\"desc\">" +
                  told(script, "description") + "</desc>");
  return svg.insert(root + 4, " role=\"img\" aria-labelledby=\"title desc\"");
}

/// The format that is asked for, or what the file's ending says.
std::string format_of(const Request& request) {
  const std::string ending = std::filesystem::path(request.text("output")).extension();
  std::vector<std::string> allowed{"svg", "png", "pdf", "csv"};
  if (request.has("format")) allowed = {request.format};
  if (ending.empty()) return request.format;
  if (std::count(allowed.begin(), allowed.end(), ending.substr(1)) != 0) return ending.substr(1);
  throw InvalidInput("figure: -o FILE ends in " + shown_text(ending) + "; allowed: ." +
                     joined(allowed, ", ."));
}

std::string picture(const Figure& figure, const Table& data, const std::string& format) {
  std::string rows = written(data, Format::csv);
  if (format == "csv") return rows;
  const std::string script = script_of(figure.name);
  const std::string drawing = drawn(script, rows, format);
  return format == "svg" ? described(drawing, script) : drawing;
}

std::vector<Figure> all_figures() {
  std::vector<Figure> all = answers::figures();
  all.insert(all.end(), report::figures().begin(), report::figures().end());
  return all;
}

/// The figures of the paper and of errors in four formats, and the tables.
generate::Texts files_of(const Table& all) {
  generate::Texts files{{"reproduce.md", page_of(all, "markdown").document},
                        {"reproduce.csv", written(all, Format::csv)},
                        {"ratios.csv", written(ratios({}).table, Format::csv)}};
  for (const Figure& figure : all_figures()) {
    if (figure.name == "speed") continue;  // it is measured
    const Table data = figure.data();
    for (const std::string format : {"svg", "png", "pdf", "csv"})
      files[figure.name + "." + format] = picture(figure, data, format);
  }
  return files;
}

}  // namespace

Answer figure(const Request& request) {
  const std::vector<Figure> all = all_figures();
  const std::vector<std::string> names = texts_of(all, &Figure::name);
  Table list{{"name", "title"}, {}};
  for (const std::string& name : names)
    list.rows.push_back({text_cell(name), text_cell(told(script_of(name), "title"))});
  if (request.has("list") && request.words.empty()) return {list};
  if (request.words.size() != 1 || request.has("list"))
    throw InvalidInput("figure: give one name, or --list; allowed: " + joined(names));
  const auto found = std::ranges::find(all, request.words[0], &Figure::name);
  if (found == all.end())
    throw InvalidInput("figure: no figure " + shown_text(request.words[0]) +
                       "; allowed: " + joined(names));
  const std::string format = format_of(request);  // refused before the data are computed
  return {{}, picture(*found, found->data(), format)};
}

Answer reproduce(const Request& request) {
  const Table all = comparisons(host::embedded().at("paper_numbers.csv"));
  if (request.has("out"))
    write_folder("reproduce: --out", request.text("out"), [&] { return files_of(all); });
  return page_of(all, request.format);
}

}  // namespace command
