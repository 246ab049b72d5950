#include "apps/report/report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/cli/program.hpp"
#include "tests/report/browser.hpp"
#include "tests/unit/apps/files.hpp"

namespace fs = std::filesystem;

namespace seiche::test {
namespace {

constexpr int right_arrow = 39, space_bar = 32;

const std::string quick = SEICHE_SCENES "/quick.toml";

// The quick scene, shorter, in a folder of its own; returns that.
fs::path short_run(const Scratch& scratch, const std::string& name, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"run", quick, "--end", "0.48", "--set", "output.size=640x480", "-o", name, "--quiet"};
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
    report.runs.push_back({run, "KF3, amplitude " + std::to_string(i + 1) + " mm", apps::stored_readings(run)});
  }
  // All columns that a table can have: two references, three crests.
  for (const char* label : {"potential theory", "VOF"}) {
    render::Reference reference{.of = "eta_left", .label = label, .file = "", .column = "", .series = {}};
    for (int k = 0; k <= 480; ++k) {
      reference.series.time.push_back(0.001 * k);
      reference.series.value.push_back(0.01 * std::sin(2 * std::numbers::pi * 20 * 0.001 * k));
    }
    report.runs[0].run.scene.look.references.push_back(reference);
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

  // How far the table is wider than its room.
  int table_overflow() {
    return browser.ask("(s => s.scrollWidth - s.clientWidth)(document.querySelector('.scroll'))");
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

TEST_F(ReportInABrowser, ItsMovieIsPlayedByClickAndByKeyAndNothingCoversIt) {
  browser.open(short_run(scratch, "out") / "report.html");
  await("canplaythrough", "if (document.querySelector('video').readyState === 4) ok()");
  EXPECT_EQ(browser.ask("document.querySelector('video').controls"), false) << "they would darken the curves";
  browser.ask("document.querySelector('video').loop = true; document.querySelector('video').focus()");
  EXPECT_EQ(browser.ask("document.activeElement.tagName"), "VIDEO");
  bool by_key = true;
  const auto centre = browser.ask(
      "document.querySelector('video').scrollIntoView(), (b => [b.left + b.width / 2, b.top + b.height / 2])"
      "(document.querySelector('video').getBoundingClientRect())");
  for (const char* event : {"play", "pause", "play", "pause"}) {
    browser.ask("window.heard = new Promise(ok => document.querySelector('video').addEventListener('" +
                std::string(event) + "', () => ok(true), {once: true})); true");
    if (by_key)
      browser.press(" ", space_bar);
    else
      browser.click(centre[0], centre[1]);
    EXPECT_EQ(browser.ask("window.heard"), true);
    EXPECT_EQ(text("#play"), event == std::string("play") ? "Pause" : "Play");
    if (event == std::string("pause")) by_key = false;
  }
  browser.ask(
      "new Promise(ok => { document.addEventListener('fullscreenchange', () => ok(true), {once: true}); "
      "document.getElementById('full').click(); })");
  EXPECT_EQ(browser.ask("document.fullscreenElement.className"), "stage");
  EXPECT_TRUE(is_shown("video") && is_shown("#slider"));
  browser.shoot(shots / "full-screen.png");
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
  EXPECT_EQ(text("tbody th"), "This run");
  EXPECT_TRUE(text("tbody td").ends_with("survived 0.48 s")) << text("tbody td");
  const std::string heads = text("thead");
  for (const char* head : {"Pressure, left bottom", "Noisea% of ρgh", "Driftc%", "Lost", "Least distance", "Steps"})
    EXPECT_NE(heads.find(head), std::string::npos) << head << " in " << heads;
  EXPECT_EQ(text(".command"), "seiche run " SEICHE_SCENES "/quick.toml --set output.size=640x480 --end 0.48");
  browser.shoot(shots / "laptop.png");
}

TEST_F(ReportInABrowser, AFailedRunHasOneToo) {
  const fs::path page = short_run(scratch, "out", {"--set", "preset=paper", "--kernel", "KF2"}) / "report.html";
  browser.open(page);
  EXPECT_NE(text("tbody td").find("stopped at 0.0"), std::string::npos) << text("tbody td");
  EXPECT_NE(text(".outcomes").find(" is beyond the limit of "), std::string::npos) << text(".outcomes");
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
    EXPECT_EQ(table_overflow(), 0) << "at " << width;
    EXPECT_EQ(is_shown("thead"), width == 1440) << "cards where its columns find no room";
    EXPECT_EQ(is_shown("td .name"), false) << "an outcome speaks for itself";
    EXPECT_EQ(is_shown("td:nth-of-type(2) .name"), width < 1440) << "at " << width;
    if (width == 375) browser.shoot(shots / "nine-phone.png");
  }
  browser.shoot(shots / "nine-laptop.png");
}

TEST_F(ReportInABrowser, TheTableOfNineIsWholeOnALaptopAndOnPaper) {
  browser.open(nine_runs(scratch));
  EXPECT_EQ(browser.ask("document.querySelectorAll('tbody tr').length"), 11) << "two references";
  EXPECT_EQ(browser.ask("document.querySelectorAll('tbody tr:first-child td').length"), 13);
  const int a4_less_margins = 688, letter_less_margins = 710;
  for (const auto& [media, width] :
       {std::pair{"screen", 1366}, {"print", a4_less_margins}, {"print", letter_less_margins}}) {
    browser.show_as(media, "light");
    browser.resize(width, 900);
    EXPECT_EQ(table_overflow(), 0) << media << " at " << width;
    EXPECT_EQ(overflow(), 0) << media << " at " << width;
    EXPECT_TRUE(is_shown("thead")) << media;
    const auto widest = browser.ask("Math.max(...[...document.querySelectorAll('td.words')].map(c => c.offsetWidth))");
    EXPECT_LT(widest.get<double>(), 150) << "a run that stopped widens no column";
  }
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
