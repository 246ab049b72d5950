// What the program says and exits with before it computes anything.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/cli/program.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/files.hpp"

namespace seiche::test {
namespace {

const std::string quick = SEICHE_SCENES "/quick.toml";

TEST(Usage, HelpListsVerbsOutputsAndExitCodes) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), {"--help"});
  EXPECT_EQ(result.code, 0);
  for (const char* text : {"run ", "render ", "movie ", "check ", "info ", "kernels ", "validate ", "probes.csv",
                           "Exit codes:", "Examples:"}) {
    EXPECT_NE(result.out.find(text), std::string::npos) << text;
  }
}

TEST(Usage, EachVerbHasItsOwnHelpWithExamples) {
  const Scratch scratch;
  for (const std::string verb : {"run", "compare", "render", "movie", "check", "info", "kernels", "validate"}) {
    const Result result = seiche(scratch.folder(), {verb, "--help"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("Examples:\n  seiche " + verb), std::string::npos) << result.out;
  }
}

TEST(Usage, WithoutOsmesaItNamesThePackageAndStartsNothing) {
  const Scratch scratch;
  // The loader takes the first library of the name, and an empty file is none.
  std::ofstream(scratch.folder() / "libOSMesa.so.8").flush();
  const Result result = seiche(scratch.folder(), {"run", quick}, {"LD_LIBRARY_PATH=" + scratch.folder().string()});
  EXPECT_EQ(result.code, 4);
  EXPECT_TRUE(test::tells(result.err, {"seiche: ", "OSMesa", "package libosmesa6"}));
  EXPECT_EQ(result.out, "");
  EXPECT_FALSE(std::filesystem::exists(scratch.folder() / "out"));
}

TEST(Usage, VersionIsOneLine) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), {"--version"});
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out.substr(0, 7), "seiche ");
}

TEST(Usage, WrongUsageExitsWith2) {
  const Scratch scratch;
  const auto error_of = [&](const std::vector<std::string>& arguments) {
    const Result result = seiche(scratch.folder(), arguments);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_TRUE(test::tells(error_of({"rnu", quick}), {"seiche: ", "'rnu'", "'run'?", "--help"}));
  EXPECT_TRUE(test::tells(error_of({"run"}), {"seiche: ", "scene", "--help"}));
  EXPECT_TRUE(test::tells(error_of({"run", quick, "--fast"}), {"seiche: ", "--fast", "--help"}));
  EXPECT_EQ(error_of({}).substr(0, 8), "seiche: ");
  EXPECT_TRUE(test::tells(error_of({"run", quick, "--threads", "0"}), {"seiche: ", "--threads", "0"}));
  EXPECT_TRUE(std::filesystem::is_empty(scratch.folder()));
}

TEST(Usage, ABadSceneIsRefusedBeforeAnythingIsWritten) {
  const Scratch scratch;
  write_text(scratch / "x.toml", "[motion]\n  amplitde = 0.1\nfrequency = nan\n");
  for (const std::string verb : {"run", "check"}) {
    const Result result = seiche(scratch.folder(), {verb, "x.toml"});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(test::tells(result.err, {"x.toml:2:3: ", "[motion] amplitde", "'amplitude'?\n",
                                         "x.toml:3:13: ", "[motion] frequency", "nan", "0 to 100 [Hz]\n"}));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2);
    EXPECT_EQ(result.out, "");
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST(Usage, EachBadSceneExitsWith2AndNamesTheFault) {
  const Scratch scratch;
  const auto error_of = [&](const std::string& toml, std::vector<std::string> flags = {}) {
    write_text(scratch / "x.toml", toml);
    flags.insert(flags.begin(), {"run", "x.toml"});
    const Result result = seiche(scratch.folder(), flags);
    EXPECT_EQ(result.code, 2);
    EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
    return result.err;
  };
  EXPECT_TRUE(test::tells(error_of("[fluid]\ndepth = 0.5\n"), {"x.toml", "fluid.depth", "0.5", "tank.height", "0.4"}));
  EXPECT_TRUE(test::tells(error_of("", {"--end", "-1"}), {"--end", "-1", "[time]", "end", "-1", "0", "100000", "[s]"}));
  EXPECT_EQ(error_of("[fluid\n").substr(0, 9), "x.toml:1:");
  EXPECT_TRUE(test::tells(error_of("", {"--kernel", "KF9"}),
                          {"--kernel", "KF9", "[method]", "kernel", "'KF9'", "KF1", "KF2", "KF3", "KF4", "KF5"}));
  EXPECT_TRUE(test::tells(error_of("", {"--range", "1"}), {"--range", "1", "[look]", "range", "'1'", "-100,3000"}));
  EXPECT_TRUE(test::tells(error_of("", {"--set", "tank.lenght=1"}),
                          {"--set", "tank.lenght=1", "'tank.lenght'", "'tank.length'?"}));
  EXPECT_TRUE(test::tells(
      error_of("", {"--set", "look.curves=eta_lft"}),
      {"--set", "look.curves=eta_lft", "[look]", "curves", "'eta_lft'", "p_left_bottom", "eta_left", "eta_right",
       "force_x", "force_y", "kinetic_energy", "potential_energy", "x_mass", "y_mass", "'eta_left'?"}));
  EXPECT_TRUE(test::tells(error_of("[look]\ncurves = \"eta_left, p_roof\"\n"),
                          {"x.toml:2:10", "[look]", "curves", "'p_roof'"}));
  EXPECT_TRUE(test::tells(error_of("[motion]\ntype = \"surge\"\ncolumns = \"roll\"\n"),
                          {"x.toml: ", "surge", "motion.columns", "motion.type = file"}));
  EXPECT_TRUE(test::tells(error_of("[look]\ncurves = \"a, b, c, d\"\n"),
                          {"x.toml:2:10", "[look]", "curves", "'a", "d'", "3", "eta_left", "p_left_bottom"}));
  write_text(scratch / "bad.csv", "t,eta_left\n0,0\n0.1,wet\n");
  EXPECT_TRUE(test::tells(error_of("[[look.reference]]\nof = \"eta_left\"\nfile = \"bad.csv\"\n"),
                          {"bad.csv:3", "eta_left", "'wet'", "-1.5e-3"}));
  EXPECT_TRUE(test::tells(error_of("[output]\nsize = \"641x480\"\n"), {".mp4", "641", "480"}));
  EXPECT_TRUE(test::tells(seiche(scratch.folder(), {"check", "y.toml"}).err, {"y.toml: ", "'x.toml'?"}));
}

TEST(Usage, ABadMotionFileIsRefusedBeforeAnythingIsWritten) {
  const Scratch scratch;
  write_text(scratch / "x.toml", "[motion]\ntype = \"file\"\nfile = \"m.csv\"\n");
  write_text(scratch / "m.csv", "t [s],roll [deg]\n0,0\n0.1,\n");
  for (const std::string verb : {"run", "check"}) {
    const Result result = seiche(scratch.folder(), {verb, "x.toml"});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(test::tells(result.err, {"m.csv:3: ", "roll [deg]"}));
  }
  write_text(scratch / "m.csv", "t [s],roll [deg]\n0,0\n1,1\n2,0\n3,1\n");
  const Result result = seiche(scratch.folder(), {"run", "x.toml", "--end", "3.5"});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(test::tells(result.err, {"x.toml: ", "motion.file", "3 s", "3.5 s", "time.end"}));
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST(Usage, CheckSummarisesAGoodScene) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), {"check", quick});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("300 fluid particles"), std::string::npos) << result.out;
}

TEST(Usage, CheckTakesTheFlagsOfRun) {
  const Scratch scratch;
  const Result finer = seiche(scratch.folder(), {"check", quick, "--spacing", "0.01"});
  EXPECT_EQ(finer.code, 0) << finer.err;
  EXPECT_NE(finer.out.find("1200 fluid particles"), std::string::npos) << finer.out;
  const Result full = seiche(scratch.folder(), {"check", quick, "--set", "fluid.depth=9"});
  EXPECT_EQ(full.code, 2);
  EXPECT_TRUE(test::tells(full.err, {"fluid.depth", "9"}));
}

TEST(Usage, CheckDrawsAGoodSceneAndNoOther) {
  const Scratch scratch;
  const Result drawn = seiche(scratch.folder(), {"check", quick, "--picture", "start.png"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(test::tells(drawn.out, {"start.png"}));
  EXPECT_EQ(read_file(scratch / "start.png").substr(1, 3), "PNG");
  write_text(scratch / "x.toml", "[fluid]\ndepth = 0.5\n");
  EXPECT_EQ(seiche(scratch.folder(), {"check", "x.toml", "--picture", "bad.png"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(scratch / "bad.png"));
  EXPECT_EQ(seiche(scratch.folder(), {"check", quick, "--picture", "x.toml/start.png"}).code, 1);
}

TEST(Usage, ADryRunPrintsAWholeSceneAndWritesNothing) {
  const Scratch scratch;
  const Result first = seiche(scratch.folder(), {"run", quick, "--dry-run", "--range", "-100,3000"});
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_TRUE(std::filesystem::is_empty(scratch.folder()));

  write_text(scratch / "quick.toml", first.out);
  EXPECT_EQ(seiche(scratch.folder(), {"run", "quick.toml", "--dry-run"}).out, first.out);
}

TEST(Usage, AFolderWithFilesIsRefused) {
  const Scratch scratch;
  write_text(scratch / "out/quick/notes.txt", "mine");
  const Result result = seiche(scratch.folder(), {"run", quick});
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(test::tells(result.err, {"out/quick", "-o DIR", "--overwrite"}));
  EXPECT_FALSE(std::filesystem::exists(scratch / "out/quick/run.json"));
}

TEST(Usage, WithoutFfmpegAMovieIsRefusedBeforeTheRun) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), {"run", quick}, {"PATH=/nonexistent"});
  EXPECT_EQ(result.code, 5);
  EXPECT_TRUE(test::tells(result.err, {"seiche: ", "package ffmpeg"}));
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST(Usage, WithoutOpenGlPicturesAreRefusedBeforeTheRun) {
  const Scratch scratch;
  // Mesa then claims to know OpenGL 2.1 only, as very old machines do.
  const Result result = seiche(scratch.folder(), {"run", quick}, {"MESA_GL_VERSION_OVERRIDE=2.1"});
  EXPECT_EQ(result.code, 4);
  EXPECT_NE(result.err.find("libosmesa6"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST(Usage, InfoNamesTheRendererAndTheEncoders) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), {"info"}, {"DISPLAY="});
  EXPECT_EQ(result.code, 0);
  for (const char* text : {"OSMesa", "VTK", "libx264", "Eigen", "CHOLMOD"})
    EXPECT_NE(result.out.find(text), std::string::npos) << text;
}

// The loader takes the build of the solver that suits the processor; told that there is no AVX2, it takes another, with
// the same results but for rounding.
TEST(Usage, TheSolverSuitsTheProcessor) {
  const Scratch scratch;
  const std::string without = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2";
  const auto info = [&](const std::vector<std::string>& environment) {
    return seiche(scratch.folder(), {"info"}, environment).out;
  };
#ifdef __x86_64__
  EXPECT_NE(info({without}).find("for x86-64-v2"), std::string::npos);
  if (__builtin_cpu_supports("avx2")) {
    EXPECT_NE(info({}).find("for x86-64-v3"), std::string::npos);
  }
#endif
  const auto last_readings = [&](const std::string& folder, const std::vector<std::string>& environment) {
    const Result result = seiche(scratch.folder(),
                                 {"run", quick, "--end", "0.1", "--set", "output.pictures=false", "--set",
                                  "output.movie=none", "--quiet", "-o", folder},
                                 environment);
    EXPECT_EQ(result.code, 0) << result.err;
    std::istringstream last(read_file(scratch / folder / "probes.csv"));
    std::string line, cell;
    for (std::string next; std::getline(last, next);) line = next;
    std::istringstream cells(line);
    std::vector<double> values;
    while (std::getline(cells, cell, ',')) values.push_back(std::stod(cell));
    return values;
  };
  const std::vector<double> one = last_readings("one", {}), other = last_readings("other", {without});
  ASSERT_GT(one.size(), 5u);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], other[k], 1e-3 * std::abs(one[k]) + 1e-5) << k;
}

TEST(Usage, KernelsArePrintedOrDrawn) {
  const Scratch scratch;
  EXPECT_NE(seiche(scratch.folder(), {"kernels"}).out.find("KF5"), std::string::npos);
  EXPECT_EQ(seiche(scratch.folder(), {"kernels", "-o", "kernels.png"}).code, 0);
  EXPECT_EQ(read_file(scratch / "kernels.png").substr(1, 3), "PNG");
}

TEST(Usage, ValidateListsItsCases) {
  const Scratch scratch;
  const Result result = seiche(scratch.folder(), {"validate", "--list"});
  EXPECT_EQ(result.code, 0) << result.err;
  for (const char* name : {"still-tank ", "pan2008 ", "standing-wave ", "dam-break ", "roll ", "paper "})
    EXPECT_NE(result.out.find(name), std::string::npos) << name;
  EXPECT_TRUE(std::filesystem::is_empty(scratch.folder()));
}

TEST(Usage, ValidateRefusesWhatIsntThereAndWritesNothing) {
  const Scratch scratch;
  const auto error_of = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "validate");
    const Result result = seiche(scratch.folder(), arguments);
    EXPECT_EQ(result.code, 2);
    return result.err;
  };
  EXPECT_TRUE(test::tells(error_of({"--only", "roll,dam-brake"}), {"'dam-brake'", "'dam-break'?"}));
  EXPECT_TRUE(test::tells(error_of({"."}), {"seiche: . ", "reference/"}));
  EXPECT_TRUE(std::filesystem::is_empty(scratch.folder()));
  write_text(scratch / "out/validate/notes.txt", "mine");
  EXPECT_NE(error_of({}).find("--overwrite"), std::string::npos);
}

}  // namespace
}  // namespace seiche::test
