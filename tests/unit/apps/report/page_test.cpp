#include "apps/report/page.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/report/assets.hpp"
#include "apps/report/command.hpp"
#include "apps/report/words.hpp"
#include "render/outputs.hpp"
#include "render/picture/palette.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/apps/report/synthetic.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string page_of(const Report& report) { return report::page(report, "/"); }

TEST(ReportPage, NamesCannotBreakIt) {
  ReportRun run = test::report_run("KF<3> & \"co\"", 1);
  run.run.scene.file = "a&b <\"c\">.toml";
  test::add_reference(
      run, "<script>", [](double) { return 0.01; }, 1);
  Report report{"a&b <\"c\"></script>", {run, run}, {}, {}};
  const std::string html = page_of(report);
  EXPECT_TRUE(has(html, "<title>a&amp;b &lt;&quot;c&quot;&gt;&lt;/script&gt; · Seiche</title>"));
  EXPECT_FALSE(has(html, "KF<3>") || has(html, "<\"c\">") || has(html, "label=\"<"));
  EXPECT_EQ(html.find("<script>"), html.rfind("<script>")) << "there is one script";
}

TEST(ReportPage, AsksTheNetworkForNothing) {
  const std::string html = page_of({"tank", {test::report_run("a", 1)}, {}, {}});
  EXPECT_FALSE(has(html, "http:") || has(html, "https:") || has(html, "@import") || has(html, "url("));
}

TEST(ReportPage, SaysHowEachRunEnded) {
  ReportRun stopped = test::failed_run("b", 0.229, "61 of 1200 fluid particles leaked");
  ReportRun other = test::failed_run("c", 0.3, ""), fast = test::failed_run("f", 0.4, "the speed is beyond the limit");
  other.run.record.ending->failure.reset();
  other.run.record.ending->error = "can't write x.vtu: No space left on device";
  fast.run.record.ending->failure->place = Failure::Particle{Kind::fluid, 550, {0.1, 0.25}};
  fast.run.record.ending->error = "ffmpeg was killed";
  ReportRun interrupted = test::report_run("d", 0.5), going = test::report_run("e", 0.7);
  interrupted.run.record.ending->status = Ending::Status::interrupted;
  going.run.record.ending.reset();
  EXPECT_EQ(report::outcome_text(test::report_run("a", 2)), "survived 2 s");
  EXPECT_EQ(report::outcome_text(stopped), "stopped at 0.229 s: 61 of 1200 fluid particles leaked");
  EXPECT_EQ(report::outcome_text(other), "stopped at 0.3 s: can't write x.vtu: No space left on device");
  EXPECT_EQ(report::outcome_text(fast),
            "stopped at 0.4 s: the speed is beyond the limit (fluid particle 550 at x = 0.1 m, y = 0.25 m); ffmpeg was "
            "killed");
  EXPECT_EQ(report::outcome_text(interrupted), "interrupted at 0.5 s");
  EXPECT_EQ(report::outcome_text(going), "unfinished at 0.7 s");
  const std::string html = page_of({"tank", {test::report_run("a", 2), stopped}, {}, {}});
  EXPECT_TRUE(has(html, "survived <small>2 s</small></td>") && has(html, "stopped <small>at 0.229 s</small></td>"));
  EXPECT_EQ(html.find("61 of 1200"), html.rfind("61 of 1200")) << "told above, so that no column grows";
}

TEST(ReportPage, TellsNothingThatAKilledRunHasNotTold) {
  ReportRun killed = test::report_run("a", 0.32);
  killed.run.record.ending.reset();
  killed.run.record.statistics = {};
  const std::string html = page_of({"tank", {killed}, {}, {}});
  EXPECT_TRUE(has(html, "unfinished at 0.32 s") && has(html, ">Drift<"));
  for (const char* name : {"Steps", "Iterations", "Wall time", "Lost", "Least distance", "Liquid particles"})
    EXPECT_FALSE(has(html, name)) << name;
}

TEST(ReportPage, SaysWhatMakesItAgain) {
  ReportRun first = test::report_run("a", 1), second = first;
  second.run.scene.parameters.motion.harmonic.amplitude = 0.02;
  first.run.info.scene_hash = "8706ad38f22361ef";
  second.run.info.scene_hash = "ac84b25a2e3101ec";
  Report report{"tank", {first, second}, {}, {}};
  report.command = report::command_text({"compare", "my tank.toml", "--vary", "motion.amplitude=0.005,0.02"},
                                        {parse_set("time.end=1"), {"--spacing 0.01", "particles.spacing", "0.01"}});
  EXPECT_EQ(report.command,
            "seiche compare 'my tank.toml' --vary motion.amplitude=0.005,0.02 --set time.end=1 --spacing 0.01");
  const std::string html = page_of(report);
  EXPECT_TRUE(has(html, "<span>--vary</span> <span>motion.amplitude=0.005,0.02</span>"));
  EXPECT_TRUE(has(html, "<dt>Scene</dt><dd>tank.toml</dd>"));
  EXPECT_TRUE(has(html, "<dt>Varied</dt><dd>motion.amplitude = 0.005, 0.02</dd>"));
  EXPECT_TRUE(has(html, "<code>8706ad38f22361ef</code>") && has(html, "<code>ac84b25a2e3101ec</code>"));
  EXPECT_EQ(report::command_text({"run", "it's"}, {}), "seiche run 'it'\\''s'");
}

TEST(ReportPage, GivesTheErrorThatStandsAboveThePanels) {
  ReportRun run = test::report_run("a", 2), stopped = test::failed_run("b", 0.5, "x");
  test::add_reference(
      run, "VOF", [](double t) { return 0.01 * std::sin(2 * std::numbers::pi * t) + 0.0041; }, 2);
  const std::string html = page_of({"tank", {run, stopped}, {}, {}});
  EXPECT_TRUE(has(html, "Off VOF") && has(html, "<span>mm RMS</span>"));
  EXPECT_TRUE(has(html, "</span>4.1 <small>50 %</small></td>"));
  EXPECT_TRUE(has(html, "</span>4.1 <small>to 0.5 s</small></td>")) << "not to be ranked with the other";
  EXPECT_TRUE(has(html, "as above the panels"));
  EXPECT_FALSE(has(page_of({"tank", {run}, {}, {}}), "as above the panels")) << "there are none";
}

TEST(ReportPage, TellsTheTankInWords) {
  const auto sentence = [](const Scene& scene) {
    Report report{"tank", {{}}, {}, {}};
    report.runs[0].run.scene = scene;
    return report::tank_sentence(report);
  };
  Scene scene;
  EXPECT_EQ(sentence(scene),
            "Liquid 0.2\u00a0m deep in a closed tank 0.6\u00a0m long and 0.4\u00a0m high at rest, in 2-D.");
  scene.parameters.motion.type = MotionType::harmonic;
  scene.parameters.motion.harmonic.of = DegreeOfFreedom::roll;
  scene.parameters.motion.harmonic.amplitude = 0.5;
  scene.parameters.motion.harmonic.frequency = 0.8;
  scene.parameters.tank.width = 0.05;
  scene.parameters.tank.closed = false;
  scene.parameters.fluid.column = 0.1;
  EXPECT_EQ(sentence(scene),
            "A column of liquid, 0.1\u00a0m long and 0.2\u00a0m high, in an open tank 0.6\u00a0m long, 0.4\u00a0m high "
            "and 50\u00a0mm wide "
            "that rolls by 0.5° at 0.8\u00a0Hz, in 3-D.");
}

TEST(ReportPage, TellsNothingAsCommonThatVaries) {
  ReportRun still = test::report_run("a", 1), wild = still;
  still.run.scene.parameters.motion.harmonic.amplitude = 0;
  wild.run.scene.parameters.motion.harmonic.amplitude = 0.02;
  wild.run.scene.parameters.fluid.depth = 0.05;
  EXPECT_EQ(
      report::tank_sentence({"tank", {still, wild}, {}, {}}),
      "Liquid 50\u00a0mm\u00a0to 0.2\u00a0m deep in a closed tank 0.6\u00a0m long and 0.4\u00a0m high that surges "
      "by 0\u00a0to 20\u00a0mm at 1\u00a0Hz, in 2-D.");
  wild.run.scene.parameters.motion.type = MotionType::none;
  EXPECT_EQ(
      report::tank_sentence({"tank", {still, wild}, {}, {}}),
      "Liquid 50\u00a0mm\u00a0to 0.2\u00a0m deep in a closed tank 0.6\u00a0m long and 0.4\u00a0m high whose motion "
      "varies, in 2-D.");
}

TEST(ReportPage, LeavesOutColumnsThatNothingIsKnownOf) {
  ReportRun run = test::report_run("a", 1);
  EXPECT_FALSE(has(page_of({"tank", {run}, {}, {}}), "Off ")) << "no reference";
  run.readings = {};
  const std::string html = page_of({"tank", {run}, {}, {}});
  EXPECT_FALSE(has(html, "Noise") || has(html, "Drift") || has(html, "<h2>Curves"));
  EXPECT_TRUE(has(html, "survived 1 s") && has(html, "Steps"));
  run.run.info.sensors.clear();
  EXPECT_TRUE(has(page_of({"tank", {run}, {}, {}}), "survived 1 s")) << "of a run without sensors, too";
}

TEST(ReportPage, MarksTheParametersThatDiffer) {
  ReportRun first = test::report_run("a", 1), second = first;
  first.run.info.parameters = "kernel = \"KF1\"\norder = 2\n";
  second.run.info.parameters = "kernel = \"KF5\"\norder = 2\n";
  const std::string html = page_of({"tank", {first, second}, {}, {}});
  EXPECT_TRUE(has(html, "<mark>kernel = &quot;KF5&quot;</mark>\norder = 2\n"));
  EXPECT_FALSE(has(html, "<mark>kernel = &quot;KF1"));
}

TEST(ReportPage, ColoursRunsAsPicturesDo) {
  for (std::size_t i = 0; i < 5; ++i) {
    const auto [r, g, b] = render::line_colours[i];
    EXPECT_TRUE(has(report::style, fmt::format("--v{}: #{:02x}{:02x}{:02x};", i, r, g, b))) << i;
  }
}

TEST(ReportPage, EmbedsTheMovieOrLinksALargeOne) {
  const test::Scratch scratch;
  const fs::path movie = scratch / "runs" / "a b.mp4";
  test::write_text(movie, "foobar");
  const Report report{"tank", {test::report_run("a", 1)}, movie, {}};
  EXPECT_TRUE(has(report::page(report, scratch.folder()), "src=\"data:video/mp4;base64,Zm9vYmFy\""));
  EXPECT_TRUE(has(report::page(report, scratch.folder()), "<video class=\"movie\" controls")) << "for want of a script";
  fs::resize_file(movie, 41'000'000);
  const std::string html = report::page(report, scratch.folder());
  EXPECT_TRUE(has(html, "src=\"runs/a%20b.mp4\"") && has(html, ">runs/a b.mp4</a>"));
  EXPECT_LT(html.size(), 1'000'000u);
}

TEST(ReportPage, HasRoomForManyStills) {
  const test::Scratch scratch;
  render::Image image{1280, 720, std::vector<std::uint8_t>(std::size_t{4} * 1280 * 720)};
  unsigned seed = 1;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    seed = seed * 1664525 + 1013904223;
    image.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(seed >> 24);
  }
  render::write_png(scratch / "0.png", image, {});
  Report report{"tank", {test::report_run("a", 1)}, {}, {}};
  for (int i = 0; i < 13; ++i) report.stills.push_back({scratch / "0.png", 0.08 * i});
  const std::string html = page_of(report);
  EXPECT_LT(html.size(), 6'000'000u) << "of pictures of noise, 2.8 MB each";
  EXPECT_TRUE(has(html, "--wide:1280;--high:720"));
}

TEST(EvenStills, AreSpacedEvenlyWithBothEnds) {
  std::vector<fs::path> pictures;
  for (int i = 0; i <= 100; ++i) pictures.emplace_back(fmt::format("frames/{:06}.png", i));
  const auto stills = even_stills(pictures, 0.02, 1.995, 5);
  ASSERT_EQ(stills.size(), 5u);
  EXPECT_EQ(stills[0].file, pictures[0]);
  EXPECT_EQ(stills[1].file, pictures[25]);
  EXPECT_EQ(stills[1].time, 0.5);
  EXPECT_EQ(stills[4].file, pictures[100]);
  EXPECT_EQ(stills[4].time, 1.995) << "cut short";
  EXPECT_EQ(even_stills({pictures[0]}, 0.02, 2).size(), 1u);
  EXPECT_TRUE(even_stills({}, 0.02, 2).empty());
}

}  // namespace
}  // namespace seiche::apps
