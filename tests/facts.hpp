#pragma once
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace seiche::test {

/// Whether a message names all facts (file, line, key, value), in this order, whatever the words between them.
inline ::testing::AssertionResult tells(const std::string& message, std::initializer_list<std::string_view> facts) {
  std::size_t from = 0;
  for (const std::string_view fact : facts) {
    const std::size_t at = message.find(fact, from);
    if (at == std::string::npos)
      return ::testing::AssertionFailure()
             << "\"" << message << "\" doesn't tell \"" << fact << "\", or not in its place";
    from = at + fact.size();
  }
  return ::testing::AssertionSuccess();
}

}  // namespace seiche::test
