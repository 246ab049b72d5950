#include "apps/report/command.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace seiche::apps::report {
namespace {

void add(std::string& command, const std::string& word) {
  command += ' ';
  const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("-._/=,:+@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) {
    command += word;
    return;
  }
  command += '\'';
  for (const char c : word) {
    if (c == '\'')
      command += "'\\''";
    else
      command += c;
  }
  command += '\'';
}

}  // namespace

std::string command_text(const std::vector<std::string>& words, const std::vector<Override>& settings) {
  std::string text = "seiche";
  for (const std::string& word : words) add(text, word);
  for (const Override& setting : settings) {
    const std::size_t space = setting.origin.find(' ');
    add(text, setting.origin.substr(0, space));
    add(text, setting.origin.substr(space + 1));
  }
  return text;
}

}  // namespace seiche::apps::report
