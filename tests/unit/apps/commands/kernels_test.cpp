#include "apps/commands/kernels.hpp"

#include <gtest/gtest.h>

#include "solver/operators/kernels.hpp"

namespace seiche::apps {
namespace {

TEST(Kernels, TextHasEveryEntryOfTheTable) {
  const std::string text = kernels_text();
  for (const auto& kernel : solver::kernel_table(1.0)) {
    std::visit([&](const auto& w) { EXPECT_NE(text.find(w.formula), std::string::npos) << w.name; }, kernel);
  }
  EXPECT_NE(text.find("KF3    0.9477   0.7383   0.3125"), std::string::npos);
}

}  // namespace
}  // namespace seiche::apps
