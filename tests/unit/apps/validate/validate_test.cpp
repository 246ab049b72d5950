#include "apps/validate/validate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "apps/common/exit_codes.hpp"
#include "apps/common/output_folder.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::apps::validate {
namespace {

// A coarse still tank for a twentieth of a second, and a limit on its greatest speed.
std::vector<Case> still_water(double limit) {
  return {{"still", "still water", [limit](Bench& bench) {
             Series speed;
             bench.run("still-tank", {"particles.spacing=0.02", "time.end=0.05", "output.frame_rate=100"},
                       [&](const Frame& frame, const RunInfo&) {
                         double most = 0;
                         for (const Float3& v : frame.velocity) most = std::max<double>(most, std::hypot(v[0], v[1]));
                         speed.t.push_back(frame.time);
                         speed.y.push_back(most);
                       });
             EXPECT_EQ(speed.size(), 6u);
             return Findings{{{"greatest speed", speed.y.back(), "m/s", at_most(limit)}},
                             {{"Speed", "t [s]", "speed [m/s]", {{"run", speed.t, speed.y}}}}};
           }}};
}

Request into(const test::Scratch& scratch) {
  Request request;
  request.scenes = SEICHE_SOURCE_DIR "/scenes";
  request.folder = scratch / "out";
  request.threads = 1;
  return request;
}

TEST(Validate, ExitsWith0WhereAllTargetsAreMetAndWritesTheTable) {
  const test::Scratch scratch;
  EXPECT_EQ(validate(into(scratch), still_water(0.1), {}), apps::done);
  EXPECT_NE(test::read_file(scratch / "out/table.md").find("| still | greatest speed |"), std::string::npos);
  EXPECT_NE(test::read_file(scratch / "out/table.csv").find("still,\"greatest speed\","), std::string::npos);
  EXPECT_EQ(test::read_file(scratch / "out/figures.png").substr(1, 3), "PNG");
}

TEST(Validate, ExitsWith3WhereATargetIsMissed) {
  const test::Scratch scratch;
  EXPECT_EQ(validate(into(scratch), still_water(-1), {}), apps::over_threshold);
  EXPECT_NE(test::read_file(scratch / "out/table.md").find("missed by 1"), std::string::npos);
}

TEST(Validate, ExitsWith3ForANewMissAlone) {
  const auto code = [](double worst) {
    const test::Scratch scratch;
    const std::vector<KnownMissOf> known{{"still", "greatest speed", {"it creeps", at_most(worst)}}};
    return validate(into(scratch), still_water(-1), known);
  };
  EXPECT_EQ(code(0.1), apps::done);
  EXPECT_EQ(code(-0.5), apps::over_threshold) << "worse than is known";
}

TEST(Validate, ExitsWith1WhereARunFailsAndGoesOnWithTheOthers) {
  const test::Scratch scratch;
  std::vector<Case> cases{{"blows-up", "", [](Bench& bench) -> Findings {
                             bench.run("pan2008-paper", {"method.kernel=KF2", "particles.spacing=0.02"});
                             return {};
                           }}};
  cases.push_back(still_water(-1).front());
  EXPECT_EQ(validate(into(scratch), cases, {}), apps::failed);
  const std::string table = test::read_file(scratch / "out/table.md");
  EXPECT_NE(table.find("| blows-up | failed: "), std::string::npos);
  EXPECT_NE(table.find("| still | greatest speed |"), std::string::npos);
}

TEST(Validate, RefusesCasesAndFoldersThatAreNotThere) {
  const test::Scratch scratch;
  Request request = into(scratch);
  request.only = {"stil"};
  try {
    validate(request, still_water(1), {});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(test::tells(error.what(), {"'stil'", "'still'?"}));
  }
  request = into(scratch);
  request.scenes = scratch.folder();
  EXPECT_THROW(validate(request, still_water(1), {}), std::invalid_argument);
  request = into(scratch);
  test::write_text(scratch / "out/notes.txt", "mine");
  EXPECT_THROW(validate(request, still_water(1), {}), apps::BadFolder);
}

TEST(Cases, HaveScenesAndReferences) {
  const std::filesystem::path scenes = std::filesystem::path(SEICHE_SOURCE_DIR) / "scenes";
  EXPECT_TRUE(std::filesystem::exists(scenes / "pan2008.toml"));
  const Bench bench(scenes, true, 1, [] { return false; });
  EXPECT_EQ(bench.reference("theory_fnpf_impulsive", "t", "eta_left").size(), 855u);
  EXPECT_THROW(bench.reference("nothing", "t", "y"), std::runtime_error);
}

}  // namespace
}  // namespace seiche::apps::validate
