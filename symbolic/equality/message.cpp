// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/message.hpp"

#include <stdexcept>

namespace magicmass::equality {
namespace {

class Writer {
public:
  void add(const std::string& text) { bytes_ += std::to_string(text.size()) + ":" + text; }
  void add(long value) { add(std::to_string(value)); }
  void add(const std::vector<std::string>& texts) {
    add(static_cast<long>(texts.size()));
    for (const std::string& text : texts) add(text);
  }
  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

class Reader {
public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::string text() {
    const std::size_t colon = bytes_.find(':');
    if (colon == std::string_view::npos) throw std::out_of_range("no length");
    const std::size_t size = std::stoul(std::string(bytes_.substr(0, colon)));
    if (bytes_.size() - colon - 1 < size) throw std::out_of_range("cut off");
    std::string result(bytes_.substr(colon + 1, size));
    bytes_.remove_prefix(colon + 1 + size);
    return result;
  }
  long number() { return std::stol(text()); }
  std::vector<std::string> texts() {
    std::vector<std::string> result;
    for (long i = number(); i > 0; --i) result.push_back(text());
    return result;
  }

private:
  std::string_view bytes_;
};

}  // namespace

std::string packed(const Message& message) {
  Writer body;
  const Verdict& verdict = message.verdict;
  body.add(message.is_final ? 1 : 0);
  body.add(message.is_refusal ? 1 : 0);
  body.add(message.refusal);
  body.add(static_cast<long>(verdict.answer));
  body.add(verdict.proof);
  body.add(verdict.domain);
  body.add(verdict.conditions);
  body.add(verdict.notes);
  body.add(verdict.agreeing_digits);
  body.add(verdict.points);
  body.add(verdict.counterexample ? 1 : 0);
  if (verdict.counterexample) {
    body.add(static_cast<long>(verdict.counterexample->point.size()));
    for (const auto& [name, value] : verdict.counterexample->point) {
      body.add(name);
      body.add(value);
    }
    body.add(verdict.counterexample->left);
    body.add(verdict.counterexample->right);
    body.add(verdict.counterexample->difference);
  }
  Writer whole;
  whole.add(body.bytes());
  return whole.bytes();
}

std::optional<Message> take(std::string& stream) {
  std::string body;
  try {
    Reader outer(stream);
    body = outer.text();
  } catch (const std::logic_error&) {  // not all of it is there
    return std::nullopt;
  }
  stream.erase(0, stream.find(':') + 1 + body.size());
  Reader reader(body);
  Message message;
  Verdict& verdict = message.verdict;
  message.is_final = reader.number() != 0;
  message.is_refusal = reader.number() != 0;
  message.refusal = reader.text();
  verdict.answer = static_cast<Answer>(reader.number());
  verdict.proof = reader.text();
  verdict.domain = reader.texts();
  verdict.conditions = reader.texts();
  verdict.notes = reader.texts();
  verdict.agreeing_digits = static_cast<int>(reader.number());
  verdict.points = static_cast<int>(reader.number());
  if (reader.number() != 0) {
    Counterexample& counterexample = verdict.counterexample.emplace();
    for (long i = reader.number(); i > 0; --i) {
      const std::string name = reader.text();
      counterexample.point[name] = reader.text();
    }
    counterexample.left = reader.text();
    counterexample.right = reader.text();
    counterexample.difference = reader.text();
  }
  return message;
}

}  // namespace magicmass::equality
