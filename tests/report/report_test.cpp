#include "apps/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cli/program.hpp"
#include "tests/report/browser.hpp"
#include "tests/unit/apps/files.hpp"

namespace fs = std::filesystem;

namespace seiche::test {
namespace {

constexpr int right_arrow = 39;

// The quick scene, shorter, in a folder of its own; returns that.
fs::path short_run(const Scratch& scratch, const std::string& name, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{
      "run", SEICHE_SCENES "/quick.toml", "--end", "0.48", "--set", "output.size=640x480", "-o", name, "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  seiche(scratch.folder(), words);
  return scratch / name;
}

// The page of nine runs, two of which stopped, with pictures of the first.
fs::path nine_runs(const Scratch& scratch) {
  const std::vector<std::string> paper{"--set", "preset=paper"};
  const fs::path folders[] = {short_run(scratch, "KF3"), short_run(scratch, "paper", paper),
                              short_run(scratch, "KF2", {"--set", "preset=paper", "--kernel", "KF2"})};
  apps::Report report{"Nine runs", {}, folders[0] / "quick.mp4", {}};
  for (int i = 0; i < 9; ++i) {
    const apps::StoredRun run = apps::read_run(folders[i % 3]);
    report.runs.push_back({run, "run " + std::to_string(i + 1), apps::stored_readings(run)});
  }
  report.stills = apps::report_of(report.runs[0].run).stills;
  apps::write_report(scratch / "report.html", report);
  return scratch / "report.html";
}

struct ReportInABrowser : ::testing::Test {
  Scratch scratch;
  Browser browser{scratch / "profile"};
  const fs::path shots = SHOTS;

  void SetUp() override { browser.resize(1440, 900); }

  // Complains of all that the page did wrong.
  void TearDown() override {
    for (const std::string& complaint : browser.complaints()) ADD_FAILURE() << complaint;
    for (const std::string& request : browser.requests()) ADD_FAILURE() << "asked for " << request;
  }

  std::string text(const std::string& selector) {
    return browser.ask("document.querySelector('" + selector + "').textContent");
  }

  bool is_shown(const std::string& selector) {
    return browser.ask("document.querySelector('" + selector + "').offsetWidth > 0");
  }

  // Waits for an event of the movie that `act` causes.
  void await(const std::string& event, const std::string& act) {
    browser.ask("new Promise(ok => { document.querySelector('video').addEventListener('" + event +
                "', ok, {once: true}); " + act + "; }).then(() => true)");
  }

  // Where the time marks stand, as a share of the time axis; NaN if they differ.
  double mark() {
    return browser.ask(
        "(marks => marks.every(x => x === marks[0]) ? parseFloat(marks[0]) / 100 : 'apart')"
        "([...document.querySelectorAll('.mark')].map(m => m.getAttribute('x1')))");
  }

  // How far the page is wider than its window.
  int overflow() { return browser.ask("document.documentElement.scrollWidth - document.documentElement.clientWidth"); }
};

TEST_F(ReportInABrowser, ItsMoviePlaysAndMovesTheMarks) {
  browser.open(short_run(scratch, "out") / "report.html");
  EXPECT_EQ(mark(), 0);
  await("canplaythrough", "if (document.querySelector('video').readyState === 4) ok()");
  await("ended", "const v = document.querySelector('video'); v.loop = false; document.getElementById('play').click()");
  EXPECT_NEAR(browser.ask("document.querySelector('video').duration").get<double>(), 13 / 25.0, 0.01);
  EXPECT_EQ(mark(), 1) << "the last frame";
  EXPECT_EQ(text("#clock"), "t = 0.48 s");
  EXPECT_EQ(browser.ask("document.getElementById('slider').value"), "12");
  EXPECT_FALSE(is_shown("#still"));
}

TEST_F(ReportInABrowser, TheSliderShowsStillsAndSeeksTheMovie) {
  browser.open(short_run(scratch, "out") / "report.html");
  await("canplaythrough", "if (document.querySelector('video').readyState === 4) ok()");
  browser.ask("document.getElementById('slider').focus()");
  for (int i = 0; i < 3; ++i) browser.press("ArrowRight", right_arrow);
  EXPECT_EQ(text("#clock"), "t = 0.12 s");
  EXPECT_NEAR(mark(), 0.25, 1e-3);
  EXPECT_TRUE(is_shown("#still"));
  EXPECT_FALSE(is_shown("video"));
  EXPECT_EQ(browser.ask("document.getElementById('still').alt"), "The tank at t = 0.12 s");
  EXPECT_TRUE(browser.ask("document.getElementById('still').naturalWidth === 640"));
  EXPECT_NEAR(browser.ask("document.querySelector('video').currentTime").get<double>(), 0.14, 0.021);
}

TEST_F(ReportInABrowser, AClickOnACurveSeeksAll) {
  browser.open(short_run(scratch, "out") / "report.html");
  await("canplaythrough", "if (document.querySelector('video').readyState === 4) ok()");
  const auto box = browser.ask(
      "document.querySelector('.plot').scrollIntoView(), "
      "(b => [b.left, b.top, b.width, b.height])(document.querySelector('.plot').getBoundingClientRect())");
  browser.ask(
      "window.sought = new Promise(ok => document.querySelector('video').addEventListener('seeked', ok)); true");
  browser.click(box[0].get<double>() + 0.5 * box[2].get<double>(), box[1].get<double>() + 0.5 * box[3].get<double>());
  browser.ask("window.sought.then(() => true)");
  EXPECT_NEAR(mark(), 0.5, 1e-3);
  EXPECT_EQ(text("#clock"), "t = 0.24 s");
  EXPECT_EQ(browser.ask("document.getElementById('slider').value"), "6");
  EXPECT_TRUE(is_shown("video"));
}

TEST_F(ReportInABrowser, ItsTableTellsHowTheRunWent) {
  browser.open(short_run(scratch, "out") / "report.html");
  EXPECT_EQ(text("tbody tr:first-child th"), "Outcome");
  EXPECT_EQ(text("tbody tr:first-child td"), "survived 0.48\u00a0s");
  const std::string table = text("table");
  for (const char* row : {"Pressure noise, left bottom [% of ρgh]", "Level drift [%]", "Particles lost",
                          "Least distance [l0]", "Time steps"})
    EXPECT_NE(table.find(row), std::string::npos) << row;
  browser.shoot(shots / "laptop.png");
}

TEST_F(ReportInABrowser, AFailedRunHasOneToo) {
  const fs::path page = short_run(scratch, "out", {"--set", "preset=paper", "--kernel", "KF2"}) / "report.html";
  browser.open(page);
  EXPECT_TRUE(text("tbody tr:first-child td").starts_with("stopped at 0.0")) << text("tbody tr:first-child td");
}

TEST_F(ReportInABrowser, ASceneMayHaveAnyName) {
  const std::string name = "a&b <i>\"c\" #1?";
  write_text(scratch / (name + ".toml"), read_file(SEICHE_SCENES "/quick.toml"));
  ASSERT_EQ(seiche(scratch.folder(), {"run", name + ".toml", "--end", "0.04", "-o", "out", "--quiet"}).code, 0);
  browser.open(scratch / "out/report.html");
  EXPECT_EQ(text("h1"), name);
  EXPECT_EQ(browser.ask("document.querySelector('h1').childElementCount"), 0);
}

TEST_F(ReportInABrowser, NineRunsFitAPhone) {
  browser.open(nine_runs(scratch));
  for (const int width : {375, 320, 768, 1440}) {
    browser.resize(width, 812);
    EXPECT_EQ(overflow(), 0) << "at " << width;
    EXPECT_LE(browser.ask("document.querySelector('.scroll').offsetWidth").get<int>(), width);
    if (width == 375) browser.shoot(shots / "nine-phone.png");
  }
  browser.shoot(shots / "nine-laptop.png");
}

TEST_F(ReportInABrowser, RunsCanBeHidden) {
  browser.open(nine_runs(scratch));
  const std::string lines = "document.querySelectorAll('.plot .v1:not(.off)').length";
  const int before = browser.ask(lines);
  EXPECT_GE(before, 2);
  browser.ask("document.querySelector('.key button[data-run=v1]').click()");
  EXPECT_EQ(browser.ask(lines), 0);
  browser.ask("document.querySelector('.key button[data-run=v1]').click()");
  EXPECT_EQ(browser.ask(lines), before);
}

TEST_F(ReportInABrowser, FollowsTheReadersColoursAndPrintsOnWhite) {
  const std::string paper = "getComputedStyle(document.body).backgroundColor";
  browser.open(nine_runs(scratch));
  browser.show_as("screen", "light");
  EXPECT_EQ(browser.ask(paper), "rgb(255, 255, 255)");
  browser.show_as("screen", "dark");
  EXPECT_EQ(browser.ask(paper), "rgb(19, 21, 25)");
  browser.shoot(shots / "nine-dark.png");
  browser.show_as("print", "dark");
  EXPECT_EQ(browser.ask(paper), "rgb(255, 255, 255)");
  EXPECT_FALSE(is_shown("video") || is_shown("#slider"));
  EXPECT_TRUE(is_shown(".strip li:last-child img"));
  browser.show_as("", "dark");
  browser.print(shots / "nine-print.pdf");
  EXPECT_GT(fs::file_size(shots / "nine-print.pdf"), 10'000u);
}

}  // namespace
}  // namespace seiche::test
