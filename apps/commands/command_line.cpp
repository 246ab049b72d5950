#include "apps/commands/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "apps/commands/check.hpp"
#include "apps/commands/flags.hpp"
#include "apps/commands/help.hpp"
#include "apps/commands/info.hpp"
#include "apps/commands/kernels.hpp"
#include "apps/commands/replay_verbs.hpp"
#include "apps/commands/run.hpp"
#include "apps/commands/schema.hpp"
#include "apps/commands/start_picture.hpp"
#include "apps/common/exit_codes.hpp"
#include "apps/common/nearest.hpp"
#include "apps/common/output_folder.hpp"
#include "apps/compare/compare.hpp"
#include "apps/run/run_info.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/validate/cases/cases.hpp"
#include "apps/validate/cases/known_misses.hpp"
#include "apps/validate/validate.hpp"
#include "render/outputs.hpp"

namespace seiche::apps {
namespace {

void add_threads(CLI::App& verb, int& threads) {
  verb.add_option("--threads", threads, "threads to compute with; one per core if left out")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
}

// The flags that change a scene.
void add_settings(CLI::App& verb, std::vector<Override>& overrides) {
  add_set(verb, overrides, "set a key of the scene");
  add_shorthand(verb, "--kernel", "method.kernel", overrides, "NAME");
  add_shorthand(verb, "--spacing", "particles.spacing", overrides, "METRES");
  add_shorthand(verb, "--end", "time.end", overrides, "SECONDS");
  add_shorthand(verb, "--range", "look.range", overrides, "RANGE");
}

void add_run(CLI::App& app, RunRequest& request, int& code) {
  CLI::App* verb = app.add_subcommand("run", "Simulate a scene and write its pictures, movie and data")
                       ->group("Verbs")
                       ->footer(help::run_footer);
  verb->add_option("scene", request.scene, "scene file")->required()->type_name("SCENE");
  verb->add_option("-o,--output", request.folder, "folder for everything written; out/<scene name> if left out")
      ->type_name("DIR");
  add_settings(*verb, request.overrides);
  add_threads(*verb, request.threads);
  verb->add_flag("--dry-run", request.dry_run, "print every key with its value, unit and range, and write nothing");
  verb->add_flag("--quiet", request.quiet, "print nothing but errors");
  verb->add_flag("--overwrite", request.overwrite, "replace an earlier run in the folder; other files there stay");
  verb->callback([&request, &code] { code = run(request); });
}

void add_compare(CLI::App& app, compare::Request& request, int& code) {
  CLI::App* verb = app.add_subcommand("compare", "Run variants of a scene side by side, and show them under one clock")
                       ->group("Verbs")
                       ->footer(help::compare_footer);
  verb->add_option("what", request.what, "a scene to vary, or two or more folders of runs that are done")
      ->type_name("SCENE|DIR...");
  verb->add_option("--vary", request.vary,
                   "a key of the scene and the values that it takes; given several times: every combination")
      ->type_name("KEY=VALUE,VALUE...")
      ->allow_extra_args(false);
  verb->add_option("-o,--output", request.folder,
                   "folder for everything written; out/<scene>-compare if left out, for folders out/compare")
      ->type_name("DIR");
  add_settings(*verb, request.settings);
  add_movie_format(*verb, request.movie, "format of the movie");
  verb->add_option("--size", request.size, "of pictures and movie")->type_name("WxH")->capture_default_str();
  add_threads(*verb, request.threads);
  verb->add_flag("--quiet", request.quiet, "print nothing but errors");
  verb->add_flag("--overwrite", request.overwrite,
                 "run all variants anew, or replace an earlier comparison; other files in the folder stay");
  verb->callback([&request, &code] { code = compare::compare(request); });
}

struct CheckRequest {
  std::string scene;  ///< scene file
  std::vector<Override> overrides;
  std::string picture;  ///< file to draw the start into; empty: none
};

void add_check(CLI::App& app, CheckRequest& request) {
  CLI::App* verb =
      app.add_subcommand("check", "Look for mistakes in a scene")->group("Verbs")->footer(help::check_footer);
  verb->add_option("scene", request.scene, "scene file")->required()->type_name("SCENE");
  add_settings(*verb, request.overrides);
  verb->add_option("--picture", request.picture,
                   "draw the tank as a run starts, and the axes of its motion, into this file")
      ->type_name("FILE.png");
  verb->callback([&request] {
    const Scene scene = read_scene(request.scene, request.overrides);
    fmt::print("{}", check_text(scene));
    if (request.picture.empty()) return;
    draw_start(scene, request.picture);
    fmt::print("  picture {}\n", request.picture);
  });
}

void add_info(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("info", "Show versions, the OpenGL renderer and ffmpeg's encoders")
                       ->group("Verbs")
                       ->footer(help::info_footer);
  verb->callback([] { fmt::print("{}", info_text()); });
}

void add_kernels(CLI::App& app, std::string& picture) {
  CLI::App* verb = app.add_subcommand("kernels", "Show the kernel functions as text, or draw them")
                       ->group("Verbs")
                       ->footer(help::kernels_footer);
  verb->add_option("-o,--output", picture, "draw them into this file instead")->type_name("FILE.png");
  verb->callback([&picture] {
    if (picture.empty()) {
      fmt::print("{}", kernels_text());
    } else {
      draw_kernels(picture);
    }
  });
}

void add_validate(CLI::App& app, validate::Request& request, int& code) {
  CLI::App* verb = app.add_subcommand("validate", "Compare runs with theory, experiment and other codes")
                       ->group("Verbs")
                       ->footer(help::validate_footer);
  verb->add_option("scenes", request.scenes, "folder of scenes; the program's own if left out")->type_name("SCENES");
  verb->add_option("-o,--output", request.folder, "folder for everything written; out/validate if left out")
      ->type_name("DIR");
  verb->add_option("--only", request.only, "run only these cases")->delimiter(',')->type_name("CASE[,CASE]");
  add_threads(*verb, request.threads);
  verb->add_flag("--quick", request.quick, "coarse runs only");
  verb->add_flag("--list", request.list, "name the cases, and run nothing");
  verb->add_flag("--overwrite", request.overwrite, "replace an earlier table in the folder");
  verb->callback(
      [&request, &code] { code = validate::validate(request, validate::all_cases(), validate::known_misses()); });
}

// CLI11 says only that a verb is required where one is misspelt.
std::string usage_message(const CLI::App* app, const CLI::Error& error) {
  std::string what = error.what();
  const std::vector<std::string> words = app->remaining();
  if (app->get_subcommands().empty() && !words.empty() && !words.front().starts_with('-')) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app->get_subcommands([](const CLI::App*) { return true; })) {
      verbs.push_back(verb->get_name());
    }
    const auto guess = nearest(words.front(), verbs);
    what =
        fmt::format("there is no verb '{}'{}", words.front(), guess ? fmt::format("; did you mean '{}'?", *guess) : "");
  }
  return fmt::format("seiche: {}\nseiche --help and seiche VERB --help say more.\n", what);
}

int parse(int argc, char** argv) {
  int code = done;
  RunRequest request;
  compare::Request comparison;
  ReplayRequest drawing, encoding;
  validate::Request validation;
  CheckRequest checked;
  std::string picture;
  CLI::App app(help::program, "seiche");
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  app.failure_message(usage_message);
  app.footer(help::program_footer);
  app.set_version_flag("--version", fmt::format("seiche {}", version()));
  app.require_subcommand(1);
  add_run(app, request, code);
  add_compare(app, comparison, code);
  add_render(app, drawing, code);
  add_movie(app, encoding, code);
  add_check(app, checked);
  add_schema(app);
  add_info(app);
  add_kernels(app, picture);
  add_validate(app, validation, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_usage;
  }
  return code;
}

int complain(const std::exception& error, int code) {
  fmt::print(stderr, "seiche: {}\n", error.what());
  return code;
}

}  // namespace

int command_line(int argc, char** argv) {
  try {
    return parse(argc, argv);
  } catch (const BadScene& error) {
    fmt::print(stderr, "{}\n", error.what());  // Begins with file:line:column, where editors look for it.
    return bad_usage;
  } catch (const BadFolder& error) {
    return complain(error, bad_usage);
  } catch (const std::invalid_argument& error) {
    return complain(error, bad_usage);
  } catch (const render::NoGl& error) {
    return complain(error, no_gl);
  } catch (const render::NoEncoder& error) {
    return complain(error, no_encoder);
  } catch (const std::exception& error) {
    return complain(error, failed);
  }
}

}  // namespace seiche::apps
