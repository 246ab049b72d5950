#include "apps/report/html.hpp"

#include <gtest/gtest.h>

namespace seiche::apps::report {
namespace {

TEST(Html, EscapesWhatHasAMeaning) {
  EXPECT_EQ(escaped("a & b < \"c\" > d's"), "a &amp; b &lt; &quot;c&quot; &gt; d's");
  EXPECT_EQ(escaped("ρ g h"), "ρ g h");
}

TEST(Html, EncodesAsRfc4648Says) {
  const std::string head = "data:x/y;base64,";
  EXPECT_EQ(data_url("x/y", ""), head);
  EXPECT_EQ(data_url("x/y", "f"), head + "Zg==");
  EXPECT_EQ(data_url("x/y", "fo"), head + "Zm8=");
  EXPECT_EQ(data_url("x/y", "foo"), head + "Zm9v");
  EXPECT_EQ(data_url("x/y", "foobar"), head + "Zm9vYmFy");
  EXPECT_EQ(data_url("x/y", "\xff\xfe"), head + "//4=");
}

TEST(Html, WritesPathsAsUrls) {
  EXPECT_EQ(url_of("runs/a-1_b.mp4"), "runs/a-1_b.mp4");
  EXPECT_EQ(url_of("a b#c?d%.mp4"), "a%20b%23c%3Fd%25.mp4");
}

}  // namespace
}  // namespace seiche::apps::report
