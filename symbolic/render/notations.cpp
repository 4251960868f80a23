// The two notations of formulas: LaTeX and MathML.
#include <regex>

#include "render/visitor.hpp"

namespace render {
namespace {
class Latex : public Visitor {
public:
  Latex()
      : Visitor({.number = {},
                 .call = {"", "\\left(", "\\right)"},
                 .fraction = {"\\frac{", "}{", "}"},
                 .root = {"\\sqrt{", "", "}"},
                 .ceiling = {"\\left\\lceil ", "", "\\right\\rceil"},
                 .parentheses = {"\\left(", "", "\\right)"}}) {}
  std::string name(const Name& name) const override {
    static const std::set<std::string> functions{"sin", "cos", "det"};
    const auto& [head, is_primed, index] = name;
    std::string out = greek.contains(head) || functions.contains(head) ? "\\" + head
                      : head == "atan"                                 ? "\\arctan"
                      : head.size() == 1                               ? head
                                                                       : "\\mathrm{" + head + "}";
    if (is_primed) out += "'";
    if (index.empty()) return out;
    std::string words = index.size() > 1 ? "\\mathrm{" + index + "}" : index;
    std::replace(words.begin(), words.end(), '_', ' ');
    return out + "_{" + words + "}";
  }
  std::string indexed(const std::string& base, const std::string& index) const override {
    // A prime comes before the index: c'_{n}. A second index joins the first.
    if (base.back() == '}' && base.find("_{") != std::string::npos)
      return base.substr(0, base.size() - 1) + ", " + index + "}";
    return base + "_{" + index + "}";
  }
  std::string power(const std::string& base, const std::string& exponent) const override {
    const bool is_primed = base.find('\'') != base.npos;  // a prime is a superscript
    return (is_primed ? "{" + base + "}" : base) + "^{" + exponent + "}";
  }
  std::string matrix(const std::vector<Strings>& rows) const override {
    std::string out = "\\begin{pmatrix}";
    for (std::size_t i = 0; i < rows.size(); ++i) {
      out += i == 0 ? "" : " \\\\ ";
      for (std::size_t j = 0; j < rows[i].size(); ++j) out += (j == 0 ? "" : " & ") + rows[i][j];
    }
    return out + "\\end{pmatrix}";
  }
  std::string before_factor(const std::string& factor) const override {
    return factor.find_first_of("0123456789") == 0 ? " \\cdot " : " \\, ";
  }
  std::string word(const std::string& word) const override {
    static const std::map<std::string, std::string> signs{
        {" <= ", " \\le "},    {" != ", " \\ne "},           {"not ", "\\lnot "},
        {" and ", ",\\quad "}, {" implies ", " \\implies "}, {" if and only if ", " \\iff "}};
    if (const auto sign = signs.find(word); sign != signs.end()) return sign->second;
    return is_sign(word) ? word : "\\text{" + word + "}";
  }
};

std::string element(const std::string& tag, const std::string& inside) {
  return "<" + tag + ">" + inside + "</" + tag + ">";
}
std::string row(const std::string& inside) { return element("mrow", inside); }
class Mathml : public Visitor {
public:
  Mathml()
      : Visitor({.number = {"<mn>", "", "</mn>"},
                 .call = {"", "<mo>&#x2061;</mo><mrow><mo>(</mo>", "<mo>)</mo></mrow>"},
                 .fraction = {"<mfrac><mrow>", "</mrow><mrow>", "</mrow></mfrac>"},
                 .root = {"<msqrt>", "", "</msqrt>"},
                 .ceiling = {"<mrow><mo>⌈</mo>", "", "<mo>⌉</mo></mrow>"},
                 .parentheses = {"<mrow><mo>(</mo>", "", "<mo>)</mo></mrow>"}}) {}
  /// Words stay upright.
  std::string name(const Name& name) const override {
    const auto letter = greek.find(name.head);
    const std::string head = letter != greek.end() ? letter->second
                             : name.head == "atan" ? "arctan"
                                                   : name.head;
    std::string out = element("mi", head);
    if (name.is_primed) out = element("msup", out + element("mo", "′"));
    if (name.index.empty()) return out;
    const bool is_number = name.index.find_first_not_of("0123456789") == name.index.npos;
    return indexed(out, element(is_number ? "mn" : "mi", name.index));
  }
  std::string indexed(const std::string& base, const std::string& index) const override {
    static const std::string prime = "<mo>′</mo>";
    const std::size_t at = base.find(prime);  // above the index, not before it
    if (at == base.npos) return element("msub", row(base) + row(index));
    return element("msubsup", base.substr(6, at - 6) + row(index) + prime);
  }
  std::string power(const std::string& base, const std::string& exponent) const override {
    return element("msup", row(base) + row(exponent));
  }
  std::string matrix(const std::vector<Strings>& rows) const override {
    std::string table;
    for (const Strings& r : rows) {
      std::string cells;
      for (const std::string& cell : r) cells += element("mtd", cell);
      table += element("mtr", cells);
    }
    return frames.parentheses.of(element("mtable", table));
  }
  std::string before_factor(const std::string& factor) const override {
    if (factor.starts_with("<mn>")) return "<mo>⋅</mo>";
    static const std::regex call_or_word(
        "(<(msub|msup|msubsup|mrow)>)*<mi>([A-Za-z]{2}|[^<]*</mi><mo>&#x2061;)");
    const bool is_apart =
        std::regex_search(factor, call_or_word, std::regex_constants::match_continuous);
    return is_apart ? "<mo>&#x2062;</mo><mspace width=\"0.17em\"/>" : "<mo>&#x2062;</mo>";
  }
  std::string word(const std::string& word) const override {
    static const std::map<std::string, std::string> signs{
        {"-", "−"},    {" - ", "−"},  {" < ", "&lt;"},    {" <= ", "≤"},
        {" != ", "≠"}, {"not ", "¬"}, {" implies ", "⟹"}, {" if and only if ", "⟺"}};
    if (const auto sign = signs.find(word); sign != signs.end()) return element("mo", sign->second);
    std::string text = word;
    if (is_sign(word)) {
      std::erase(text, ' ');
      return element("mo", text);
    }
    for (std::size_t at = text.find(' '); at != text.npos; at = text.find(' ', at))
      text.replace(at, 1, "&#xa0;");
    return element("mtext", text);
  }
};
}  // namespace

std::string latex(Expr e) { return Latex().text(e); }
std::string latex_name(const std::string& head, const std::string& index) {
  const std::string name = Latex().name({head, false, ""});
  return "$" + (index.empty() ? name : Latex().indexed(name, index)) + "$";
}
std::string mathml(Expr e, bool is_block) {
  return (is_block ? "<math display=\"block\">" : "<math>") + Mathml().text(e) + "</math>";
}
std::string mathml_name(const std::string& head, const std::string& index) {
  const std::string name = Mathml().name({head, false, ""});
  const std::string letters = "<mi>" + index + "</mi>";
  return "<math>" + (index.empty() ? name : Mathml().indexed(name, letters)) + "</math>";
}
}  // namespace render
