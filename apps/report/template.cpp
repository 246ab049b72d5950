#include "apps/report/template.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace seiche::apps::report {

std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values) {
  std::string result;
  for (std::size_t open; (open = text.find("{{")) != std::string_view::npos;) {
    const std::size_t end = text.find("}}", open);
    if (end == std::string_view::npos) break;
    const std::string_view name = text.substr(open + 2, end - open - 2);
    const auto value = values.find(name);
    if (value == values.end()) throw std::logic_error(fmt::format("a template has {{{{{}}}}}, which is nothing", name));
    result.append(text.substr(0, open)).append(value->second);
    text.remove_prefix(end + 2);
  }
  return result.append(text);
}

}  // namespace seiche::apps::report
