#pragma once

// What --help says beside the list of verbs and flags.
namespace seiche::apps::help {

constexpr const char* program =
    "Simulates liquid sloshing in a tank by the moving-particle semi-implicit method, and shows it:\n"
    "pictures, a movie, files for ParaView and curves, from one scene file. Needs no display.";

constexpr const char* program_footer = R"(Examples:
  seiche run scenes/quick.toml            simulate and draw a small tank in seconds
  seiche run scenes/quick.toml --dry-run  show every key of the scene, with its value, unit and range
  seiche render out/quick --size 640x360  draw a run that is done again, without solving
  seiche movie out/quick -o quick.gif     make another movie of it
  seiche check scenes/quick.toml          look for mistakes, and say what would be simulated
  seiche compare scenes/quick.toml --vary method.kernel=KF1,KF3
                                          run variants side by side, and show them under one clock
  seiche schema > scene.schema.json       what a scene may hold, for editors
  seiche kernels -o kernels.png           draw the kernel functions
  seiche validate --quick                 compare runs with theory and experiment

A run of NAME.toml writes, under out/NAME/ or the folder of -o:
  NAME.mp4              the movie
  frames/000123.png     pictures
  NAME.pvd, vtu/        all particles, for ParaView
  probes.csv            sensor readings, with units in the header
  report.html           a page with the movie, curves and measures, for any browser
  run.json              parameters, steps, how the run ended, time by stage and by output, particle-steps a second

Exit codes:
  0 done   1 the run failed   2 wrong usage or scene   3 a comparison is over its threshold
  4 no OpenGL   5 no encoder   130 interrupted

Each verb has its own --help.)";

constexpr const char* run_footer = R"(Examples:
  seiche run scenes/quick.toml
  seiche run scenes/quick.toml --kernel KF5 --spacing 0.01 -o out/finer
  seiche run scenes/quick.toml --set motion.amplitude=0.02 --set output.movie=gif --overwrite
  seiche run scenes/quick.toml --dry-run > mine.toml

The preset comes first, then the file's keys, then each --set in its order, then the other flags.
The scene, the folder, OpenGL and the encoder are checked before anything is computed or written.
Ctrl-C ends the run with the current frame and closes the movie; a second Ctrl-C ends it at once.)";

constexpr const char* compare_footer = R"(Examples:
  seiche compare scenes/pan2008-paper.toml --vary method.kernel=KF1,KF2,KF3,KF4,KF5 --spacing 0.01
  seiche compare scenes/quick.toml --vary preset=stabilised,paper --vary particles.spacing=0.02,0.01
  seiche compare out/mine out/theirs --range frame -o out/both

Variants are run as many at a time as cores and memory allow; one that fails doesn't stop the others. Ctrl-C ends them
all with their current frames. Of a scene compared before, variants that are done aren't run again. A run of other
parameters in a variant's folder, or a comparison of other runs, is refused without --overwrite.

Writes, under out/<scene>-compare/ or the folder of -o:
  compare.mp4           the movie: 1 to 9 panels under one clock, curves of all below them
  frames/000123.png     its pictures
  report.html           all of it on one page, with measures of each variant
  KF3_spacing-0.01/     one folder per variant, as `seiche run` leaves it; without pictures, movie and page of its own,
                        which --set output.pictures=true, output.movie=mp4 and output.report=true ask for
Exits with 0 when each variant has finished or stopped with a report, with 1 if one could not be run.)";

constexpr const char* render_footer = R"(Examples:
  seiche render out/quick --colour-map cividis --size 1920x1080
  seiche render out/quick --range run --from 0.5 --movie gif -o out/quick-run
  seiche render out/quick --latest

Writes 000123.png and so on into OUT/render or the folder of -o, numbered as the run's frames, and the movie beside
them. What isn't said looks as in the run; its curves come from probes.csv. Without output.vtu a run can't be drawn
again, but `seiche movie` works. --latest goes on until the run has ended; Ctrl-C ends it with the current frame.)";

constexpr const char* movie_footer = R"(Examples:
  seiche movie out/quick -o quick.gif
  seiche movie out/quick --speed 0.25 --from 0.5 --to 0.8 -o slow.mp4
  seiche movie out/quick --view lab --size 640x360 -o lab.webm
  seiche movie out/quick --latest

Takes the run's pictures as they are. Where one is missing, or they are to look otherwise, its VTU files are drawn. A
movie that is replaced stays until the new one is whole.)";

constexpr const char* check_footer = R"(Examples:
  seiche check scenes/quick.toml
  seiche check scenes/ship.toml --picture ship.png
  seiche check scenes/pan2008.toml --spacing 0.0025 --set fluid.depth=0.12

The scene is taken as run takes it with the same flags.
All mistakes are listed, each with its file, line and column. Exits with 0 if there is none, else with 2.)";

constexpr const char* schema_footer = R"(Examples:
  seiche schema > scene.schema.json
  seiche schema --markdown

An editor with Taplo or Even Better TOML takes the schema from a first line in the scene:
  #:schema scene.schema.json)";

constexpr const char* info_footer = R"(Examples:
  seiche info)";

constexpr const char* kernels_footer = R"(Examples:
  seiche kernels
  seiche kernels -o kernels.png)";

constexpr const char* validate_footer = R"(Examples:
  seiche validate --quick                  coarse runs, in minutes
  seiche validate                          all cases, down to 2.5 mm
  seiche validate --only roll,dam-break
  seiche validate --list

Writes, under out/validate/ or the folder of -o:
  table.md, table.csv   each figure with its value, target and verdict
  figures.png           runs and references, drawn
Exits with 3 if a figure misses its target for no known reason, with 1 if a run failed that should not.
The scenes are those that came with the program; another folder of them needs its reference/ too.)";

}  // namespace seiche::apps::help
