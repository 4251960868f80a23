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
}  // namespace

std::string latex(Expr e) { return Latex().text(e); }
std::string latex_name(const std::string& head, const std::string& index) {
  const std::string name = Latex().name({head, false, ""});
  return "$" + (index.empty() ? name : Latex().indexed(name, index)) + "$";
}
}  // namespace render
