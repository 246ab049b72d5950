// What a frame of 12,288 particles costs: a picture of 1280 x 720, its PNG, a VTU file, a frame of a movie.
#include "render/outputs.hpp"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>

#include "render/files/vtu.hpp"
#include "render/picture/range.hpp"
#include "render/view/painter.hpp"
#include "tests/unit/render/synthetic_curves.hpp"

namespace seiche::bench {
namespace {

constexpr int frames_of_movie = 50;

/// A tank whose surface tilts to and fro, its curves under the picture.
struct Show {
  test::Box box{.spacing = 0.2 / 64};
  RunInfo run = test::run_with_sensors(box);
  std::vector<FramePtr> frames;
  render::Painter painter{run, render::Look{}};
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("seiche-bench-" + std::to_string(getpid()));

  Show() {
    for (int k = 0; k < frames_of_movie; ++k)
      frames.push_back(test::lattice(box, 0.2 * std::sin(2 * 3.14159 * k / frames_of_movie), k));
    painter.record(test::readings(0, 1, 1000));
    std::filesystem::create_directories(folder);
    picture(0);  // makes the window
  }
  ~Show() { std::filesystem::remove_all(folder); }

  const Frame& frame(std::size_t k) const { return *frames[k % frames.size()]; }
  render::Image picture(std::size_t k) { return painter.draw(frame(k), render::scene_range(run)); }
};

template <class F>
void each_frame(benchmark::State& state, Show& show, F f) {
  std::size_t k = 0;
  for (auto _ : state) f(k++);
  using benchmark::Counter;
  const double fluid = std::round(show.box.length * show.box.depth / (show.box.spacing * show.box.spacing));
  state.counters["s_per_particle"] = Counter(fluid, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void picture(benchmark::State& state) {
  Show show;
  each_frame(state, show, [&](std::size_t k) { benchmark::DoNotOptimize(show.picture(k)); });
}

void png(benchmark::State& state) {
  Show show;
  const render::Image image = show.picture(0);
  each_frame(state, show, [&](std::size_t k) {
    render::write_png(show.folder / "a.png", image, render::provenance(show.run, show.frame(k)));
  });
}

void vtu(benchmark::State& state) {
  Show show;
  each_frame(state, show, [&](std::size_t k) {
    render::write_vtu(show.folder / "a.vtu", show.frame(k), render::provenance(show.run, show.frame(k)));
  });
}

// Whole movies, since the encoder lags behind; ffmpeg's start and end are in it.
void movie_frame(benchmark::State& state) {
  Show show;
  std::vector<render::Image> images;
  for (int k = 0; k < frames_of_movie; ++k) images.push_back(show.picture(k));
  std::unique_ptr<render::ImageSink> movie;
  each_frame(state, show, [&](std::size_t k) {
    const std::size_t at = k % frames_of_movie;
    if (at == 0) {
      movie = render::movie(show.folder / "a.mp4");
      movie->begin(show.run, images[0].width, images[0].height);
    }
    movie->image(images[at], show.frame(at));
    if (at + 1 == frames_of_movie) movie->end();
  });
}

void real_time(benchmark::internal::Benchmark* of) { of->UseRealTime()->Unit(benchmark::kMillisecond); }

BENCHMARK(picture)->Apply(real_time);
BENCHMARK(png)->Apply(real_time);
BENCHMARK(vtu)->Apply(real_time);
BENCHMARK(movie_frame)->Apply(real_time)->Iterations(2 * frames_of_movie);

}  // namespace
}  // namespace seiche::bench
