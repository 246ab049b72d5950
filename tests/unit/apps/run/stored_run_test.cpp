#include "apps/run/stored_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/common/output_folder.hpp"
#include "apps/run/run_info.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/errors_of.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/apps/refusal.hpp"
#include "tests/unit/apps/scene/stl/stl_bytes.hpp"
#include "tests/unit/headers.hpp"

namespace seiche::apps {
namespace {

using test::Scratch;
using test::write_text;

// A folder with run.json, of a scene that has samples of all sorts.
struct StoredRunTest : ::testing::Test {
  Scratch scratch;
  Scene scene;
  RunRecord record;
  const Failure failure{0.24, 36, "it blew up", {}, Failure::Particle{Kind::wall, 12, {NAN, 0.123456789}}};

  void SetUp() override {
    write_text(scratch / "shaker.csv", "t [s],surge [m]\n0,0\n0.1,0.001\n0.2,0.0015\n0.3,0.001\n");
    write_text(scratch / "theory.csv", "t,eta_left\n0,0\n0.1,\n0.2,0.3\n");
    write_text(scratch / "a.toml", R"(
[motion]
type = "file"
file = "shaker.csv"
[time]
end = 0.3
[output]
size = "640x360"
[[sensors.gauge]]
name = "left"
x = 0.1
[[look.reference]]
of = "eta_left"
file = "theory.csv"
)");
    scene = read_scene((scratch / "a.toml").string(), {});
    record.ending = Ending{Ending::Status::failed, failure, "ffmpeg was killed", 3, 0.25};
    record.statistics.steps = 40;
    record.statistics.leaked = 2;
    record.statistics.least_distance = 0.0042;
    record.times.total = 7;
  }

  StoredRun stored() {
    const OutputFolder folder{scratch / "out", scene.name};
    std::filesystem::create_directories(folder.path);
    write_samples(folder.samples(), scene);
    write_run_json(folder.record(), scene, record);
    return read_run(folder.path);
  }
};

TEST_F(StoredRunTest, HasTheSceneThatWasRun) {
  const StoredRun run = stored();
  EXPECT_EQ(scene_hash(run.scene), scene_hash(scene)) << "which covers every key and every sample";
  EXPECT_EQ(run.info.name, "a");
  EXPECT_EQ(run.info.sensors, run_info(scene).sensors);
  EXPECT_EQ(run.info.excursion, run_info(scene).excursion);
  EXPECT_EQ(run.scene.look.width, 640);
  ASSERT_EQ(run.scene.look.references.size(), 1u);
  EXPECT_TRUE(std::isnan(run.scene.look.references[0].series.value[1])) << "a gap";
}

TEST_F(StoredRunTest, HasTheMeshOfItsTank) {
  write_text(scratch / "box.stl", test::stl_box(60, 40, 20));
  write_text(scratch / "b.toml",
             "[tank]\nshape = \"mesh\"\nfile = \"box.stl\"\nunit = \"cm\"\n[fluid]\nfill = 0.5\n"
             "[particles]\nspacing = 0.02\n");
  scene = read_scene((scratch / "b.toml").string(), {});
  const StoredRun run = stored();
  EXPECT_EQ(scene_hash(run.scene), scene_hash(scene));
  EXPECT_EQ(run.scene.parameters.tank.mesh.points, scene.parameters.tank.mesh.points);
  // A corner that isn't there is damage.
  const std::filesystem::path samples = OutputFolder{scratch / "out", scene.name}.samples();
  std::string text = seiche::test::read_file(samples);
  const auto faces = text.find("[[", text.find("\"faces\""));
  write_text(samples, text.replace(faces, 2, "[[99,"));
  EXPECT_THROW(read_run(scratch / "out"), std::exception);
}

TEST_F(StoredRunTest, KnowsHowTheRunEnded) {
  const StoredRun run = stored();
  ASSERT_TRUE(run.record.ending);
  EXPECT_EQ(run.record.ending->status, Ending::Status::failed);
  ASSERT_TRUE(run.record.ending->failure);
  const Failure& why = *run.record.ending->failure;
  EXPECT_EQ(sentence(why), sentence(failure));
  EXPECT_EQ(why.time, failure.time);
  ASSERT_TRUE(why.place);
  EXPECT_EQ(why.place->kind, Kind::wall);
  EXPECT_EQ(why.place->id, 12u);
  EXPECT_TRUE(std::isnan(why.place->position.at(0)));
  EXPECT_EQ(why.place->position.at(1), 0.123456789);
  EXPECT_EQ(run.record.ending->error, "ffmpeg was killed");
  EXPECT_EQ(run.record.ending->time, 0.25);
  EXPECT_EQ(run.record.statistics.steps, 40);
  EXPECT_EQ(run.record.statistics.leaked, 2);
  EXPECT_EQ(run.record.statistics.least_distance, 0.0042);
  EXPECT_EQ(run.record.times.total, 7);
  record = {};
  EXPECT_FALSE(stored().record.ending) << "still going";
  EXPECT_TRUE(std::isinf(stored().record.statistics.least_distance)) << "not measured";
}

TEST_F(StoredRunTest, ReadsProbesUpToTheLastWholeLine) {
  const std::size_t columns = stored().info.sensors.size();
  std::string text = fmt::format("t [s],{}", fmt::join(test::headers(stored().info.sensors), ","));
  for (const char* time : {"0.000000", "0.001000", "0.00"}) {
    text += fmt::format("\n{}", time);
    for (std::size_t k = 0; k < columns; ++k) text += fmt::format(",{}", k);
  }
  write_text(scratch / "out" / "probes.csv", text);
  const StoredRun run = stored();
  const Readings readings = stored_readings(run);
  EXPECT_EQ(readings.time, (std::vector<double>{0, 0.001}));
  EXPECT_EQ(readings.values.size(), 2 * columns);
  const render::Series left = column_of(readings, run.info, "eta_left");
  EXPECT_EQ(left.value.size(), 2u);
  EXPECT_EQ(left.value[0], left.value[1]);
  EXPECT_TRUE(column_of(readings, run.info, "eta_right").time.empty());
}

TEST_F(StoredRunTest, ReadsAnEmptyCellAsAGap) {
  const std::size_t columns = stored().info.sensors.size();
  write_text(scratch / "out" / "probes.csv",
             fmt::format("t [s],{}\n0.000000{}\n", fmt::join(test::headers(stored().info.sensors), ","),
                         std::string(columns, ',')));
  const Readings readings = stored_readings(stored());
  ASSERT_EQ(readings.values.size(), columns);
  for (const double value : readings.values) EXPECT_TRUE(std::isnan(value));
}

TEST_F(StoredRunTest, ListsFramesAndPictures) {
  EXPECT_TRUE(stored_frames(stored()).empty());
  EXPECT_TRUE(stored_pictures(stored()).empty());
  const auto out = scratch / "out";
  write_text(out / "a.vtu.series", R"({"files": [{"name": "vtu/a_000000.vtu", "time": 0},
                                                 {"name": "vtu/a_000012.vtu", "time": 0.24}]})");
  for (const char* name : {"000012.png", "000000.png", "notes.png", "000001.png.part"})
    write_text(out / "frames" / name, "x");
  const auto frames = stored_frames(stored());
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].index, 12);
  EXPECT_EQ(frames[1].time, 0.24);
  EXPECT_EQ(frames[1].file, out / "vtu/a_000012.vtu");
  EXPECT_EQ(stored_pictures(stored()),
            (std::vector<std::filesystem::path>{out / "frames/000000.png", out / "frames/000012.png"}));
}

std::string refusal_of(const std::filesystem::path& folder) {
  return test::refusal([&] { read_run(folder); });
}

TEST_F(StoredRunTest, RefusesWhatIsNoRun) {
  const auto out = scratch / "other";
  EXPECT_TRUE(test::tells(refusal_of(out), {out.string(), "`seiche run`"}));
  std::filesystem::create_directories(out);
  EXPECT_TRUE(test::tells(refusal_of(out), {out.string(), "empty", "`seiche run`"}));
  write_text(out / "x", "");
  EXPECT_TRUE(test::tells(refusal_of(out), {out.string(), "run.json", "`seiche run`"}));
  write_text(out / "run.json", "{\"seiche\": ");
  EXPECT_TRUE(test::tells(refusal_of(out), {(out / "run.json").string(), "byte 12"}));
}

TEST_F(StoredRunTest, RefusesAnotherSchemaVersionAndSaysWhatToDo) {
  const auto out = scratch / "out";
  const std::string remedy = "`seiche run b/x.toml -o " + out.string() + " --overwrite`",
                    file = (out / "run.json").string();
  write_text(out / "run.json", R"({"seiche": "0.1.0", "scene": {"file": "b/x.toml"}})");
  EXPECT_TRUE(test::tells(refusal_of(out), {file, "no schema version", "version 1", remedy}));
  write_text(out / "run.json", R"({"seiche": "9", "schema": 12, "scene": {"file": "b/x.toml"}})");
  EXPECT_TRUE(test::tells(refusal_of(out), {file, "12", "1", remedy}));
}

}  // namespace
}  // namespace seiche::apps
