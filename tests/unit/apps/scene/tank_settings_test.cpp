#include "apps/scene/tank_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/apps/scene/stl/stl_bytes.hpp"

namespace seiche::apps {
namespace {

using std::numbers::pi;

const std::string ball = "[tank]\nshape = \"sphere\"\nradius = 0.25\n[particles]\nspacing = 0.02\n";

std::string error_of(const std::string& text) {
  try {
    parse_scene(text, "x.toml", {});
  } catch (const BadScene& error) {
    return error.what();
  }
  return "no error";
}

double depth_of(const std::string& text) { return parse_scene(text, "x.toml", {}).parameters.fluid.depth; }

TEST(TankSettings, AnyOfFourTellsHowFullTheTankIs) {
  EXPECT_EQ(depth_of(ball + "[fluid]\ndepth = 0.125\n"), 0.125);
  EXPECT_EQ(depth_of(ball + "[fluid]\nfill_height = 0.25\n"), 0.125);
  EXPECT_NEAR(depth_of(ball + "[fluid]\nfill = 0.5\n"), 0.25, 1e-9);
  // A cap of depth h has the volume pi h^2 (R - h/3); the wall's facets lie within it.
  const double cap = pi * 0.125 * 0.125 * (0.25 - 0.125 / 3);
  EXPECT_NEAR(depth_of(ball + "[fluid]\nvolume = " + std::to_string(cap) + "\n"), 0.125, 2e-4 * 0.125);
  EXPECT_NEAR(depth_of("[fluid]\nfill = 0.3\n"), 0.12, 1e-12);
}

TEST(TankSettings, TwoLevelsOrNoneAreRefused) {
  EXPECT_TRUE(
      test::tells(error_of(ball + "[fluid]\ndepth = 0.1\nfill = 0.5\n"), {"x.toml:8:8", "depth", "fill", "leave one"}));
  EXPECT_TRUE(test::tells(error_of(ball), {"x.toml", "[fluid]", "depth, fill, fill_height or volume"}));
  EXPECT_TRUE(test::tells(error_of(ball + "[fluid]\nvolume = 0.07\n"), {"x.toml", "fluid.volume = 0.07 m^3", "0.065"}));
}

TEST(TankSettings, TheCommandLineSLevelTakesThePlaceOfTheFileS) {
  const Scene scene = parse_scene(ball + "[fluid]\nfill = 0.5\n", "x.toml", {parse_set("fluid.depth=0.1")});
  EXPECT_EQ(scene.parameters.fluid.depth, 0.1);
}

TEST(TankSettings, PointsComeFromTheirFile) {
  const std::string prism = "[tank]\nshape = \"prism\"\n[fluid]\nfill = 0.5\n";
  EXPECT_TRUE(test::tells(error_of(prism), {"x.toml", "tank.points", "missing"}));
  EXPECT_TRUE(test::tells(error_of("[tank]\nfile = \"a.csv\"\n"), {"x.toml", "tank.file", "box", "leave it out"}));
  EXPECT_TRUE(test::tells(error_of("[tank]\nshape = \"prism\"\npoints = [[0, 0], [1, 0], [0, 1]]\nfile = \"a.csv\"\n"
                                   "[fluid]\nfill = 0.5\n"),
                          {"x.toml", "tank.points", "tank.file", "leave one"}));
}

TEST(TankSettings, SeedsTakeTheLiquidsDepthOrTheirOwn) {
  const std::string divider = "[[tank.baffle]]\nx = 0.3\nheight = 0.4\n";
  const std::string seeds = "[[fluid.seed]]\nx = 0.1\ny = 0.05\n[[fluid.seed]]\nx = 0.5\ny = 0.05\ndepth = 0.25\n";
  const Parameters::Fluid fluid =
      parse_scene("[fluid]\ndepth = 0.1\n" + divider + seeds, "x.toml", {}).parameters.fluid;
  ASSERT_EQ(fluid.seeds.size(), 2U);
  EXPECT_EQ(fluid.seeds[0].depth, 0.1);
  EXPECT_EQ(fluid.seeds[1].depth, 0.25);
  EXPECT_EQ(fluid.depth, 0.25) << "the greatest";
  EXPECT_TRUE(
      test::tells(error_of("[fluid]\nfill = 0.5\n" + seeds), {"x.toml", "fluid.fill", "[[fluid.seed]]", "depth"}));
  EXPECT_TRUE(test::tells(error_of(ball + seeds), {"x.toml", "[[fluid.seed]]", "x = 0.1", "depth"}));
}

TEST(TankSettings, GravityIsANumberOrAVector) {
  const auto gravity_of = [](const std::string& text) { return parse_scene(text, "x.toml", {}).parameters.gravity; };
  EXPECT_EQ(gravity_of("gravity = 1.6\n").size(), 1.6);
  const Gravity leaning = gravity_of("gravity = [1, -9, 0]\n[fluid]\ndepth = 0.1\n");
  EXPECT_EQ(leaning[0], 1);
  EXPECT_EQ(leaning[1], -9);
  EXPECT_TRUE(gravity_of("gravity = [0, -9.81, 0]\n").is_upright());
  EXPECT_TRUE(test::tells(error_of("gravity = [1, 2]\n"), {"x.toml:1", "gravity", "2 numbers", "list of 3"}));
  EXPECT_TRUE(test::tells(error_of("gravity = [0, -200, 0]\n"), {"x.toml:1", "gravity", "out of range", "-100"}));
}

// Half the height of a box that leans by 45 degrees is half its diagonal's.
TEST(TankSettings, FillHeightIsAgainstGravity) {
  const double depth =
      depth_of("gravity = [5, -5, 0]\n[tank]\nlength = 0.4\nheight = 0.4\n[fluid]\nfill_height = 0.5\n");
  EXPECT_NEAR(depth, 0.2 * std::sqrt(2.0), 1e-12);
}

TEST(TankSettings, AMeshComesFromItsFileInItsUnit) {
  const seiche::test::Scratch scratch;
  seiche::test::write_text(scratch / "box.stl", test::stl_box(600, 400, 200));
  const std::string mesh = "[tank]\nshape = \"mesh\"\nfile = \"box.stl\"\n",
                    rest = "[fluid]\nfill = 0.5\n[particles]\nspacing = 0.02\n";
  const auto scene_of = [&](const std::string& text) { return parse_scene(text, (scratch / "x.toml").string(), {}); };
  const Scene scene = scene_of(mesh + "unit = \"mm\"\n" + rest);
  EXPECT_EQ(scene.parameters.dimension(), 3);
  EXPECT_NEAR(scene.parameters.fluid.depth, 0.2, 1e-7);
  EXPECT_EQ(scene.given.file, "box.stl") << "scene text says where the mesh is from";
  EXPECT_NE(scene_hash(scene), scene_hash(scene_of(mesh + "unit = \"cm\"\n" + rest)));
  try {
    scene_of(mesh + rest);
    FAIL() << "an STL file has no unit of its own";
  } catch (const BadScene& error) {
    EXPECT_TRUE(test::tells(error.what(), {"x.toml", "tank.unit", "missing", "\"mm\"", "box.stl"}));
  }
  EXPECT_TRUE(test::tells(error_of("[tank]\nshape = \"mesh\"\n" + rest), {"x.toml", "tank.file", "missing"}));
  EXPECT_TRUE(test::tells(error_of(ball + "[fluid]\nfill = 0.5\n[tank]\nunit = \"mm\"\n"), {"x.toml"}));
}

TEST(TankSettings, AMeshThatChangedIsAnotherScene) {
  const seiche::test::Scratch scratch;
  const std::string text = "[tank]\nshape = \"mesh\"\nfile = \"box.stl\"\nunit = \"m\"\n[fluid]\nfill = 0.5\n";
  const auto hash_of = [&](float height) {
    seiche::test::write_text(scratch / "box.stl", test::stl_box(0.6F, height, 0.2F));
    return scene_hash(parse_scene(text, (scratch / "x.toml").string(), {}));
  };
  EXPECT_NE(hash_of(0.4F), hash_of(0.41F));
}

}  // namespace
}  // namespace seiche::apps
