#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "solver/make_simulation.hpp"
#include "tests/unit/apps/files.hpp"

// The scenes that come with the program, and what is said of them, must not fall behind it.
namespace seiche::apps {
namespace {

const std::filesystem::path source = SEICHE_SOURCE_DIR;

TEST(Scenes, AreAllGoodAndNamedInTheReadme) {
  const std::string readme = test::read_file(source / "scenes/README.md");
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    EXPECT_NO_THROW(read_scene(entry.path().string(), {})) << entry.path();
    const std::string name = entry.path().lexically_relative(source / "scenes").string();
    EXPECT_NE(readme.find(fmt::format("`{}`", name)), std::string::npos) << entry.path();
  }
  EXPECT_GE(count, 5);
}

// What their timings are divided by.
TEST(Scenes, ThoseToBeTimedTakeStepsOfOneLengthAndWriteNothing) {
  for (const auto& [name, particles, steps] : {std::tuple("dam-10mm", 2500, 1000), std::tuple("dam-5mm", 10000, 100)}) {
    const Scene scene = read_scene((source / "scenes/bench" / name).string() + ".toml", {});
    const Parameters& p = scene.parameters;
    EXPECT_NEAR(p.fluid.column * p.fluid.depth / (p.particles.spacing * p.particles.spacing), particles, 1e-6) << name;
    EXPECT_NEAR(p.time.end / p.time.step, steps, 1e-9) << name;
    EXPECT_NEAR(p.time.end * scene.output.frame_rate, 1, 1e-12) << name << ": no frame but the first and the last";
    EXPECT_FALSE(scene.draws() || scene.samples() || scene.writes(OutputKind::vtu)) << name;
  }
}

// A tank's size must not be in the method's defaults.
TEST(Scenes, TheLargeStillTankIsTheSmallOneMadeLargerAndHasNoKeysOfItsOwnBeside) {
  const Scene small = read_scene((source / "scenes/still-tank.toml").string(), {});
  Scene large = read_scene((source / "scenes/still-lng.toml").string(), {});
  Parameters &p = large.parameters, q = small.parameters;
  EXPECT_NEAR(p.fluid.depth / p.particles.spacing, q.fluid.depth / q.particles.spacing, 1e-9);
  EXPECT_NEAR(p.tank.length / p.particles.spacing, q.tank.length / q.particles.spacing, 1e-9);
  EXPECT_NEAR(p.tank.length / q.tank.length, 40, 1e-9);
  p.fluid.depth = q.fluid.depth;
  p.tank = q.tank;
  p.particles = q.particles;
  p.time.end = q.time.end;
  large.output.frame_rate = small.output.frame_rate;
  EXPECT_EQ(scene_text(large), scene_text(small));
}

// What the README says of the columns, and what `seiche validate` reads.
TEST(Scenes, Pan2008HasTheDefaultSensorsAndOneWhereVofIsGood) {
  const Scene scene = read_scene((source / "scenes/pan2008.toml").string(), {});
  const std::vector<Column> columns = sensor_columns(scene.parameters);
  for (const char* column : {"p_left_bottom", "eta_left", "eta_right", "eta_left_20mm"})
    EXPECT_LT(find_column(columns, column), columns.size()) << column;
  for (const render::Reference& reference : scene.look.references) {
    const bool rings = reference.label == "VOF" && reference.of == "p_left_bottom";
    EXPECT_EQ(reference.series.time.front(), rings ? 0.5 : 0) << reference.of << ", " << reference.label;
  }
}

}  // namespace
}  // namespace seiche::apps
