#include <regex>

#include "render/visitor.hpp"

namespace render {
namespace {
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

std::string mathml(Expr e, bool is_block) {
  return (is_block ? "<math display=\"block\">" : "<math>") + Mathml().text(e) + "</math>";
}
std::string mathml_name(const std::string& head, const std::string& index) {
  const std::string name = Mathml().name({head, false, ""});
  const std::string letters = "<mi>" + index + "</mi>";
  return "<math>" + (index.empty() ? name : Mathml().indexed(name, letters)) + "</math>";
}
}  // namespace render
