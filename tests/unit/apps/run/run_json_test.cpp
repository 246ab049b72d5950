#include "apps/run/run_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/scene/options.hpp"
#include "apps/scene/scene_file.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps {
namespace {

using test::read_file;
using test::Scratch;

nlohmann::json written(const RunRecord& record) {
  const Scratch folder;
  write_run_json(folder / "run.json", parse_scene("gravity = 5\n", "a/b.toml", {}), record);
  return nlohmann::json::parse(read_file(folder / "run.json"));
}

TEST(RunJson, SaysThatARunIsStillGoing) { EXPECT_EQ(written({})["run"], (nlohmann::json{{"status", "running"}})); }

TEST(RunJson, TellsHowARunEnded) {
  RunRecord record;
  record.ending = Ending{Ending::Status::failed, Failure{0.24, 36, "it blew up", "much"}, "the disk is full", 7, 0.25};
  record.times = {{{"solve", 1.5}, {"search", 0.5}}, {{"pictures", 0.75}}, 0.25, 4};
  record.statistics.fluid_particles = 300;
  record.statistics.steps = 40;
  record.statistics.iterations = 100;
  const nlohmann::json json = written(record);
  EXPECT_EQ(json["run"],
            (nlohmann::json{{"status", "failed"},
                            {"failure", {{"time_s", 0.24}, {"step", 36}, {"cause", "it blew up"}, {"detail", "much"}}},
                            {"error", "the disk is full"},
                            {"frames", 7},
                            {"time_s", 0.25}}));
  EXPECT_EQ(json["scene"]["name"], "b");
  EXPECT_EQ(json["scene"]["file"], "a/b.toml");
  EXPECT_EQ(json["pressure"]["iterations_per_step"], 2.5);
  EXPECT_EQ(json["seconds"],
            (nlohmann::json{
                {"solve", 1.5}, {"search", 0.5}, {"pictures", 0.75}, {"waited_for_outputs", 0.25}, {"total", 4.0}}));
  EXPECT_EQ(json["speed"],
            (nlohmann::json{{"particle_steps_per_second", 300 * 40 / 2.0}, {"waited_for_outputs_share", 0.0625}}));
}

TEST(RunJson, HasASchemaVersion) { EXPECT_EQ(written({})["schema"], run_schema); }

TEST(RunJson, HoldsEveryKey) {
  const nlohmann::json parameters = written({})["parameters"];
  EXPECT_EQ(parameters["gravity"], 5.0);
  for (const Option& option : options()) {
    const nlohmann::json& at = option.section.empty() ? parameters : parameters[std::string(option.section)];
    EXPECT_TRUE(at.contains(option.key)) << dotted(option);
  }
}

}  // namespace
}  // namespace seiche::apps
