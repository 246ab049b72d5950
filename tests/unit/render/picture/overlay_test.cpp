#include "render/picture/overlay.hpp"

#include <gtest/gtest.h>

using namespace seiche::render;

TEST(Wrapped, LinesAreNoWiderThanTheirRoom) {
  const std::string words = "61 of 1200 fluid particles leaked through the walls, more than 5 %";
  const auto lines = wrapped(words, 12);
  EXPECT_GT(lines.size(), 2u);
  std::string together;
  for (const std::string& line : lines) {
    EXPECT_LE(text_width(line), 12) << line;
    together += (together.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(together, words);
  EXPECT_EQ(wrapped(words, 100), std::vector<std::string>{words});
  EXPECT_TRUE(wrapped("", 10).empty());
}

TEST(Wrapped, AUnitStaysWithItsNumber) {
  EXPECT_EQ(wrapped("stopped at 1.216 s", text_width("stopped at 1.216")),
            (std::vector<std::string>{"stopped at", "1.216 s"}));
}
