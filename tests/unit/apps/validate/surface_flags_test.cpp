#include "apps/validate/surface_flags.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace seiche::apps::validate {
namespace {

// Fluid particles by their ids, a capital letter where the flag is up; a wall particle with its flag up ends each
// frame.
Frame frame(double time, const std::string& particles) {
  Frame f;
  f.time = time;
  for (const char c : particles) {
    f.id.push_back(static_cast<std::uint32_t>(std::tolower(c) - 'a'));
    f.free_surface.push_back(std::isupper(c) ? 1 : 0);
    f.kind.push_back(Kind::fluid);
  }
  f.id.push_back(100);
  f.free_surface.push_back(time > 1.5);
  f.kind.push_back(Kind::wall);
  f.position.resize(f.id.size());
  return f;
}

TEST(SurfaceFlags, AShareOfThoseThatBearOneInEitherFrame) {
  SurfaceFlags flags;
  flags.see(frame(0, "ABCDefgh"));
  EXPECT_TRUE(std::isnan(flags.changing(0, 9))) << "no pair yet";
  flags.see(frame(1, "ABCDefgh"));
  EXPECT_EQ(flags.changing(0, 9), 0);
  flags.see(frame(2, "ABCdEfgh"));  // D leaves and E joins: 2 of A-E
  EXPECT_EQ(flags.changing(1, 2), 2.0 / 5);
  flags.see(frame(3, "abcdefGH"));  // none stays, A-C, E, G and H change
  EXPECT_EQ(flags.changing(2, 3), 1);
  EXPECT_EQ(flags.changing(0, 9), (0 + 2 + 6) / (4 + 5 + 6.0));
}

TEST(SurfaceFlags, PairsCountWhereTheirMiddleLies) {
  SurfaceFlags flags;
  for (const auto& [time, particles] : {std::pair{0.0, "Ab"}, {1.0, "aB"}, {2.0, "aB"}})
    flags.see(frame(time, particles));
  EXPECT_EQ(flags.changing(0.5, 1.4), 1);
  EXPECT_EQ(flags.changing(0.6, 1.5), 0);
  EXPECT_EQ(flags.changing(0.5, 1.5), 2.0 / 3);
  EXPECT_TRUE(std::isnan(flags.changing(1.6, 9)));
}

TEST(SurfaceFlags, ParticlesThatLeaveOrComeDontCount) {
  SurfaceFlags flags;
  flags.see(frame(0, "ABCf"));
  flags.see(frame(1, "BcDf"));
  EXPECT_EQ(flags.changing(0, 1), 1.0 / 2);
}

TEST(SurfaceFlags, WaterWithoutASurfaceHasNoShare) {
  SurfaceFlags flags;
  flags.see(frame(0, "ab"));
  flags.see(frame(1, "ab"));
  EXPECT_TRUE(std::isnan(flags.changing(0, 1)));
}

}  // namespace
}  // namespace seiche::apps::validate
