#include "apps/validate/validate.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <stdexcept>

#include "apps/common/exit_codes.hpp"
#include "apps/common/nearest.hpp"
#include "apps/common/output_folder.hpp"
#include "apps/common/signals.hpp"
#include "apps/run/run_info.hpp"
#include "apps/validate/page.hpp"
#include "apps/validate/table.hpp"
#include "render/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps::validate {
namespace {

std::vector<Case> chosen(const std::vector<Case>& cases, const std::vector<std::string>& names) {
  if (names.empty()) return cases;
  std::vector<Case> result;
  std::vector<std::string> known;
  for (const Case& each : cases) {
    known.push_back(each.name);
    if (std::find(names.begin(), names.end(), each.name) != names.end()) result.push_back(each);
  }
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const auto guess = nearest(name, known);
    throw std::invalid_argument(
        fmt::format("there is no case '{}'; {}", name,
                    guess ? fmt::format("did you mean '{}'?", *guess) : "`seiche validate --list` shows all"));
  }
  return result;
}

Outcome outcome_of(const Case& each, Bench& bench, const std::vector<KnownMissOf>& known) {
  try {
    Outcome outcome{each.name, each.run(bench), {}};
    mark_known_misses(each.name, outcome.findings.figures, known);
    return outcome;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    return {each.name, {}, error.what()};
  }
}

void write(const fs::path& folder, const std::vector<Outcome>& outcomes) {
  render::write_file(folder / "table.md", table_md(outcomes));
  render::write_file(folder / "table.csv", table_csv(outcomes));
  std::vector<Chart> charts;
  for (const Outcome& outcome : outcomes)
    charts.insert(charts.end(), outcome.findings.charts.begin(), outcome.findings.charts.end());
  if (!charts.empty())
    render::write_png(folder / "figures.png", draw_page(charts), {{"Software", fmt::format("seiche {}", version())}});
}

int exit_code(const std::vector<Outcome>& outcomes, bool interrupted) {
  if (interrupted) return apps::interrupted;
  int code = done;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.failure.empty()) return failed;
    if (!outcome.passed()) code = over_threshold;
  }
  return code;
}

}  // namespace

fs::path find_scenes() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path prefix = program.parent_path().parent_path();
  const fs::path installed = prefix / SEICHE_INSTALLED_SCENES;
  return fs::is_directory(installed) ? installed : prefix / "scenes";
}

int validate(const Request& request, const std::vector<Case>& cases, const std::vector<KnownMissOf>& known) {
  const std::vector<Case> asked = chosen(cases, request.only);
  const fs::path scenes = request.scenes.empty() ? find_scenes() : request.scenes;
  if (request.list) {
    for (const Case& each : asked) fmt::print("{:<14} {}\n", each.name, each.shows);
    fmt::print("with the scenes and references of {}\n", scenes.string());
    return done;
  }
  if (!fs::is_directory(scenes / "reference"))
    throw std::invalid_argument(fmt::format("{} is no folder of scenes: it has no reference/", scenes.string()));
  const OutputFolder folder{request.folder, "validate"};
  folder.check(request.overwrite);
  render::gl_description();  // before hours are spent
  fs::create_directories(request.folder);

  const SignalWatch signals;
  Bench bench(scenes, request.quick, request.threads > 0 ? request.threads : omp_get_num_procs(),
              [&] { return signals.caught(); });
  std::vector<Outcome> outcomes;
  bool interrupted = false;
  for (const Case& each : asked) {
    fmt::print("{}: {}\n", each.name, each.shows);
    std::fflush(stdout);
    try {
      outcomes.push_back(outcome_of(each, bench, known));
    } catch (const Interrupted&) {
      interrupted = true;
      break;
    }
    fmt::print("{}\n", figures_text(outcomes.back()));
  }
  write(request.folder, outcomes);
  fmt::print("{}{}; see {}/table.md and figures.png\n", interrupted ? "Interrupted. " : "", count_text(outcomes),
             request.folder.string());
  return exit_code(outcomes, interrupted);
}

}  // namespace seiche::apps::validate
