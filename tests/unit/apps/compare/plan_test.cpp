#include "apps/compare/plan.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/common/output_folder.hpp"
#include "apps/run/run_info.hpp"
#include "apps/run/run_json.hpp"
#include "apps/scene/scene_file.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/apps/refusal.hpp"

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
  record.ending = Ending{.status = status, .failure = {}, .error = "", .frames = 1, .time = 1, .waited = 0};
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
  const auto planned = [&](const std::vector<Override>& settings) {
    return plan_of(scratch, {"method.kernel=KF3"}, settings).at(0).scene;
  };
  const Scene plain = planned({});
  EXPECT_TRUE(plain.writes(OutputKind::vtu) && plain.writes(OutputKind::probes));
  EXPECT_FALSE(plain.writes(OutputKind::pictures));
  EXPECT_FALSE(plain.writes(OutputKind::movie));
  const Scene asked = planned({parse_set("output.pictures=true"), parse_set("output.movie=gif")});
  EXPECT_TRUE(asked.writes(OutputKind::pictures));
  EXPECT_EQ(asked.output.movie, render::MovieFormat::gif);
}

TEST(Plan, LabelsOnlyWhatVaries) {
  const Scratch scratch;
  const auto runs = plan_of(scratch, {"particles.spacing=0.02", "method.kernel=KF1,KF3"});
  EXPECT_EQ(runs.at(1).label, "KF3");
  EXPECT_EQ(runs.at(1).folder, scratch / "out/spacing-0.02_KF3");
}

std::string refusal_of(const std::vector<std::string>& vary, const std::vector<Override>& settings = {}) {
  const Scratch scratch;
  try {
    plan_of(scratch, vary, settings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Plan, RefusesTheSameRunTwiceAsItWasTyped) {
  EXPECT_TRUE(test::tells(refusal_of({"particles.spacing=0.02,0.020"}),
                          {"--vary", "particles.spacing=0.02", "particles.spacing=0.020"}));
  EXPECT_TRUE(test::tells(refusal_of({"method.kernel=KF1,KF1", "preset=paper"}),
                          {"--vary", "method.kernel=KF1", "preset=paper", "method.kernel=KF1", "preset=paper"}));
}

TEST(Plan, RefusesRunsThatWouldShareAFolder) {
  const Scratch scratch;
  for (const std::string file : {"a_b.csv", "a-b.csv"})
    write_text(scratch / file, fmt::format("t [s],surge [m]\n0,0\n1,0\n2,{}\n3,0\n", file == "a_b.csv" ? 0.1 : 0.2));
  try {
    plan_of(scratch, {"motion.file=a_b.csv,a-b.csv"}, {parse_set("motion.type=file")});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(test::tells(error.what(), {"--vary", "motion.file=a_b.csv", "motion.file=a-b.csv", "folder"}));
  }
}

TEST(Plan, RefusesFlatRunsBesideSolidOnes) {
  EXPECT_TRUE(test::tells(
      refusal_of({"method.kernel=KF1", "tank.width=0,0.2"}),
      {"--vary", "method.kernel=KF1", "tank.width=0", "method.kernel=KF1", "tank.width=0.2", "2-D", "3-D"}));
}

TEST(Plan, RefusesToGoWithoutWhatPicturesAreDrawnFrom) {
  for (const std::string text : {"output.vtu=false", "output.probes=false"})
    EXPECT_TRUE(test::tells(refusal_of({"method.kernel=KF1,KF3"}, {parse_set(text)}), {"--set " + text, "VTU"}));
}

TEST(Plan, AValueThatAKeyRefusesIsTracedToItsVary) {
  const Scratch scratch;
  try {
    plan_of(scratch, {"method.kernel=KF1,KF9"});
    FAIL();
  } catch (const BadScene& error) {
    EXPECT_TRUE(test::tells(error.what(), {"--vary method.kernel=KF9: ", "[method] kernel = 'KF9'"}));
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

// The first run, stored in the folder of the second.
PlannedRun store_misplaced(const std::vector<PlannedRun>& runs) {
  PlannedRun other = runs[0];
  other.folder = runs[1].folder;
  store(other);
  return other;
}

TEST(IsDone, NotWhereTheFolderHoldsAnotherRun) {
  const Scratch scratch;
  const auto runs = plan_of(scratch, {"method.kernel=KF1,KF3"});
  store_misplaced(runs);
  EXPECT_FALSE(is_done(runs[1]));
}

// What check_kept says of a folder; nothing where it lets it be run in.
std::string complaint_of(const PlannedRun& run) {
  return test::refusal([&] { check_kept(run); });
}

TEST(CheckKept, LetsTheSameRunGoOnOrAgain) {
  const Scratch scratch;
  const auto run = plan_of(scratch, {"method.kernel=KF1,KF3"}).at(0);
  EXPECT_EQ(complaint_of(run), "") << "no folder";
  std::filesystem::create_directories(run.folder);
  EXPECT_EQ(complaint_of(run), "") << "empty";
  for (const auto status : {Ending::Status::finished, Ending::Status::failed, Ending::Status::interrupted}) {
    store(run, status);
    EXPECT_EQ(complaint_of(run), "");
  }
  write_run_json(run.folder / "run.json", run.scene, {});
  EXPECT_EQ(complaint_of(run), "") << "was killed";
}

TEST(CheckKept, RefusesARunOfOtherParameters) {
  const Scratch scratch;
  const auto runs = plan_of(scratch, {"method.kernel=KF1,KF3"});
  PlannedRun other = store_misplaced(runs);
  const std::string folder = other.folder.string();
  EXPECT_TRUE(
      test::tells(complaint_of(runs[1]), {folder, " finished", "method.kernel = KF1", "KF3", "-o DIR", "--overwrite"}));
  store(other, Ending::Status::interrupted);
  EXPECT_TRUE(test::tells(complaint_of(runs[1]),
                          {folder, " unfinished", "method.kernel = KF1", "KF3", "-o DIR", "--overwrite"}));
  other = runs[1];
  other.scene.output.frame_rate = 7;
  store(other);
  EXPECT_TRUE(test::tells(complaint_of(runs[1]), {folder, "output.frame_rate = 7", "50", "-o DIR", "--overwrite"}));
  other = runs[1];
  other.scene.parameters.motion.series.time = {0, 1};
  other.scene.parameters.motion.series[DegreeOfFreedom::surge] = {0, 1};
  store(other);
  write_samples(other.folder / "samples.json", other.scene);
  EXPECT_TRUE(test::tells(complaint_of(runs[1]), {folder, " finished", "other parameters", "-o DIR", "--overwrite"}));
}

TEST(CheckKept, RefusesWhatAnotherVersionFinishedAndWhatIsNoRun) {
  const Scratch scratch;
  const auto run = plan_of(scratch, {"method.kernel=KF1,KF3"}).at(0);
  store(run);
  std::string text = test::read_file(run.folder / "run.json");
  const std::string ours = std::string("\"") + version() + "\"";
  write_text(run.folder / "run.json", text.replace(text.find(ours), ours.size(), "\"0.0.1\""));
  EXPECT_TRUE(
      test::tells(complaint_of(run), {run.folder.string(), "seiche 0.0.1", version(), "-o DIR", "--overwrite"}));
  write_text(run.folder / "run.json", "{\"seiche\":");
  EXPECT_TRUE(test::tells(complaint_of(run), {run.folder.string(), "no run", "-o DIR", "--overwrite"}));
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
