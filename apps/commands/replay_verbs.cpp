#include "apps/commands/replay_verbs.hpp"

#include "apps/commands/flags.hpp"
#include "apps/commands/help.hpp"

namespace seiche::apps {
namespace {

void add_common(CLI::App& verb, ReplayRequest& request) {
  verb.add_option("run", request.run, "folder of the run, as `seiche run` left it or is filling it")
      ->required()
      ->type_name("OUT");
  const auto look = [&](const char* flag, const char* key, const char* type) {
    add_shorthand(verb, flag, key, request.look, type);
  };
  look("--quantity", "look.quantity", "NAME");
  look("--colour-map", "look.colour_map", "NAME");
  look("--range", "look.range", "RANGE");
  look("--size", "output.size", "WxH");
  look("--view", "look.view", "NAME");
  look("--background", "look.background", "NAME");
  look("--style", "look.style", "NAME");
  look("--curves", "look.curves", "SENSORS");
  add_set(verb, request.look, "change a key of [look], or output.size");
  verb.add_option("--from", request.frames.from, "leave out frames before this time")->type_name("SECONDS");
  verb.add_option("--to", request.frames.to, "leave out frames after this time")->type_name("SECONDS");
  verb.add_option_function<std::string>(
          "--frames", [&](const std::string& text) { select_frames(text, request.frames); },
          "first and last frame by number, as in 100:200, 100: or :200")
      ->type_name("A:B");
  verb.add_flag("--latest", request.latest, "follow a run that is still going, to its end");
  auto* speed = verb.add_option("--speed", request.speed, "of the movie: 0.25 is four times slower than the run")
                    ->check(CLI::Range(1e-4, 1e4))
                    ->type_name("FACTOR");
  verb.add_option("--fps", request.fps, "frames a second of the movie; as many as the run has if left out")
      ->check(CLI::Range(0.1, 1000.0))
      ->type_name("N")
      ->excludes(speed);
  verb.add_flag("--quiet", request.quiet, "print nothing but errors");
}

}  // namespace

void add_render(CLI::App& app, ReplayRequest& request, int& code) {
  CLI::App* verb = app.add_subcommand("render", "Draw a run again from its VTU files, without solving")
                       ->group("Verbs")
                       ->footer(help::render_footer);
  add_common(*verb, request);
  verb->add_option("-o,--output", request.output, "folder for the pictures; OUT/render if left out")->type_name("DIR");
  add_movie_format(*verb, request.movie, "make a movie of them, too");
  verb->add_flag("--overwrite", request.overwrite, "replace earlier pictures in the folder; other files there stay");
  verb->callback([&request, &code] { code = replay(request); });
}

void add_movie(CLI::App& app, ReplayRequest& request, int& code) {
  CLI::App* verb = app.add_subcommand("movie", "Make another movie of a run, from its pictures or VTU files")
                       ->group("Verbs")
                       ->footer(help::movie_footer);
  add_common(*verb, request);
  verb->add_option("-o,--output", request.output,
                   "the movie; its suffix says which format: .mp4, .webm or .gif; OUT/render/NAME.mp4 if left out")
      ->type_name("FILE");
  verb->add_flag("--overwrite", request.overwrite, "replace the file");
  verb->callback([&request, &code] { code = replay_movie(request); });
}

}  // namespace seiche::apps
