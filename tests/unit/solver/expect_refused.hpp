#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "solver/check_parameters.hpp"

namespace seiche::test {

/// Expects the parameters to be refused with a message that has every one of the words.
inline void expect_refused(const Parameters& p, const std::vector<std::string>& words) {
  try {
    check_parameters(p);
    ADD_FAILURE() << "accepted; expected " << words[0];
  } catch (const BadParameters& error) {
    for (const auto& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << word << " in: " << error.what();
  }
}

}  // namespace seiche::test
