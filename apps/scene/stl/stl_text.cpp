#include "apps/scene/stl/stl_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "apps/common/errors.hpp"

namespace seiche::apps {
namespace {

constexpr std::string_view spaces = " \t\r\n\f\v";

/// Whether they are the same but for the case of letters; `word` is in lower case.
bool is_word(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// The words of a text, one after the other, and what is refused of them.
class Words {
 public:
  Words(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// The next word; empty at the end.
  std::string_view next() {
    skip_spaces();
    const std::size_t first = at_;
    at_ = std::min(text_.size(), text_.find_first_of(spaces, at_));
    return text_.substr(first, at_ - first);
  }

  std::string_view rest_of_line() {
    const std::size_t end = std::min(text_.size(), text_.find('\n', at_));
    const std::string_view rest = text_.substr(at_, end - at_);
    at_ = end;
    const std::size_t first = rest.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return rest.substr(first, rest.find_last_not_of(spaces) - first + 1);
  }

  void expect(std::string_view word) {
    const std::string_view found = next();
    if (!is_word(found, word)) refuse(found, fmt::format("'{}'", word));
  }

  double number() {
    const std::string_view found = next();
    std::string_view digits = found;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
      refuse(found, "a finite number, as in -1.5e-3,");
    return value;
  }

  [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
    const std::string what = found.empty() ? "the file ends" : fmt::format("'{}'", shortened(found));
    throw BadScene(
        fmt::format("{}:{}: {} where an STL file has {}; it is damaged or no STL file: export or copy it again", file_,
                    line_, what, expected));
  }

 private:
  static std::string shortened(std::string_view word) {
    std::string text(word.substr(0, 30));
    for (char& c : text)
      if (c < ' ' || c > '~') c = '?';
    return word.size() > text.size() ? text + "..." : text;
  }

  void skip_spaces() {
    for (; at_ < text_.size() && spaces.find(text_[at_]) != std::string_view::npos; ++at_) line_ += text_[at_] == '\n';
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

void read_facet(Words& words, StlBuilder& builder) {
  words.expect("normal");
  for (int k = 0; k < 3; ++k)
    if (words.next().empty()) words.refuse({}, "the normal of a facet");
  words.expect("outer");
  words.expect("loop");
  std::array<std::array<double, 3>, 3> corners;
  for (auto& corner : corners) {
    words.expect("vertex");
    for (double& coordinate : corner) coordinate = words.number();
  }
  words.expect("endloop");
  words.expect("endfacet");
  builder.add(corners);
}

}  // namespace

bool is_text_stl(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(spaces);
  return first != std::string_view::npos && is_word(bytes.substr(first, 5), "solid") &&
         bytes.find('\0') == std::string_view::npos;
}

void read_text_stl(std::string_view text, const std::string& file, StlBuilder& builder) {
  Words words(text, file);
  words.expect("solid");
  while (true) {
    builder.begin_solid(words.rest_of_line());
    std::string_view word;
    while (is_word(word = words.next(), "facet")) read_facet(words, builder);
    if (!is_word(word, "endsolid")) words.refuse(word, "'facet' or 'endsolid'");
    words.rest_of_line();
    word = words.next();
    if (word.empty()) return;
    if (!is_word(word, "solid")) words.refuse(word, "'solid' or its end");
  }
}

}  // namespace seiche::apps
