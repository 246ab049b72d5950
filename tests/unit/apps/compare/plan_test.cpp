#include "apps/compare/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "apps/run_json.hpp"
#include "apps/scene_file.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps::compare {
namespace {

using test::Scratch;
using test::write_text;

std::vector<PlannedRun> plan_of(const Scratch& scratch, const std::vector<std::string>& vary,
                                const std::vector<Override>& settings = {}) {
  write_text(scratch / "x.toml", "[time]\nend = 1\n");
  return plan(scratch / "x.toml", vary, settings, scratch / "out");
}

// As `seiche run` leaves it, but for the particles.
void store(const PlannedRun& run, Ending::Status status = Ending::Status::finished) {
  RunRecord record;
  record.ending = Ending{.status = status, .reason = "", .frames = 1, .time = 1, .waited = 0};
  write_run_json(run.folder / "run.json", run.scene, record);
  write_text(run.folder / "x.vtu.series", R"({"files": [{"name": "vtu/x_000000.vtu", "time": 0}]})");
}

TEST(Plan, HasOneRunForEachVariant) {
  const Scratch scratch;
  const auto runs = plan_of(scratch, {"method.kernel=KF1,KF3", "particles.spacing=0.02,0.01"});
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[3].label, "KF3, 10 mm");
  EXPECT_EQ(runs[3].folder, scratch / "out/KF3_spacing-0.01");
  EXPECT_EQ(runs[3].scene.parameters.method.kernel, "KF3");
  EXPECT_EQ(runs[3].scene.parameters.particles.spacing, 0.01);
}

TEST(Plan, VariantsWriteVtuFilesAndPicturesOnlyWhereAskedTo) {
  const Scratch scratch;
  const auto output = [&](const std::vector<Override>& settings) {
    return plan_of(scratch, {"method.kernel=KF3"}, settings).at(0).scene.output;
  };
  const Output plain = output({parse_set("output.vtu=false"), parse_set("output.probes=false")});
  EXPECT_TRUE(plain.vtu && plain.probes);
  EXPECT_FALSE(plain.pictures);
  EXPECT_EQ(plain.movie, "none");
  const Output asked = output({parse_set("output.pictures=true"), parse_set("output.movie=gif")});
  EXPECT_TRUE(asked.pictures);
  EXPECT_EQ(asked.movie, "gif");
}

TEST(Plan, RefusesTheSameRunTwice) {
  const Scratch scratch;
  try {
    plan_of(scratch, {"particles.spacing=0.02,0.020"});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "--vary: 20 mm and 20 mm are the same run; leave one out");
  }
}

TEST(Plan, AValueThatAKeyRefusesIsTracedToItsVary) {
  const Scratch scratch;
  try {
    plan_of(scratch, {"method.kernel=KF1,KF9"});
    FAIL();
  } catch (const BadScene& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("--vary method.kernel=KF9: [method] kernel = 'KF9'"))
        << error.what();
  }
}

TEST(SimulatedHash, IsTheSameWhateverTheLook) {
  const auto hash = [](const std::string& setting) {
    return simulated_hash(parse_scene("", "x.toml", {parse_set(setting)}));
  };
  const std::string plain = simulated_hash(parse_scene("", "x.toml", {}));
  EXPECT_EQ(hash("look.colour_map=turbo"), plain);
  EXPECT_EQ(hash("output.movie=gif"), plain);
  EXPECT_NE(hash("output.frame_rate=10"), plain);
  EXPECT_NE(hash("output.probe_rate=10"), plain);
  EXPECT_NE(hash("method.kernel=KF5"), plain);
}

TEST(IsDone, WhereTheSameRunHasEnded) {
  const Scratch scratch;
  const auto runs = plan_of(scratch, {"method.kernel=KF1,KF3"});
  EXPECT_FALSE(is_done(runs[0])) << "no folder";
  store(runs[0]);
  EXPECT_TRUE(is_done(runs[0]));
  store(runs[0], Ending::Status::failed);
  EXPECT_TRUE(is_done(runs[0])) << "it would fail again";
  store(runs[0], Ending::Status::interrupted);
  EXPECT_FALSE(is_done(runs[0]));
  store(runs[0]);
  std::filesystem::remove(runs[0].folder / "x.vtu.series");
  EXPECT_FALSE(is_done(runs[0])) << "nothing to draw";
  write_text(runs[0].folder / "run.json", "{\"seiche\":");
  EXPECT_FALSE(is_done(runs[0])) << "half of it";
}

TEST(IsDone, NotWhereTheFolderHoldsAnotherRun) {
  const Scratch scratch;
  const auto runs = plan_of(scratch, {"method.kernel=KF1,KF3"});
  PlannedRun other = runs[0];
  other.folder = runs[1].folder;
  store(other);
  EXPECT_FALSE(is_done(runs[1]));
}

TEST(RunsAtATime, AreAsManyAsCoresAndMemoryAllow) {
  EXPECT_EQ(runs_at_a_time(5, 2, 1e9, 1e10), 2);
  EXPECT_EQ(runs_at_a_time(3, 8, 1e9, 1e10), 3);
  EXPECT_EQ(runs_at_a_time(5, 8, 1e9, 2.5e9), 2);
  EXPECT_EQ(runs_at_a_time(5, 8, 1e9, 1e6), 1);
  EXPECT_EQ(runs_at_a_time(0, 8, 0, 1e6), 1);
}

TEST(Memory, GrowsWithTheParticles) {
  const Scene coarse = parse_scene("", "x.toml", {parse_set("particles.spacing=0.01")});
  const Scene fine = parse_scene("", "x.toml", {parse_set("particles.spacing=0.0005")});
  EXPECT_GT(memory_of(fine), 5 * memory_of(coarse));
  EXPECT_GT(free_memory(), 0);
}

}  // namespace
}  // namespace seiche::apps::compare
