#pragma once
#include <memory>

#include "apps/run/outputs.hpp"
#include "apps/run/run_info.hpp"
#include "apps/run/run_json.hpp"
#include "apps/scene/scene_file.hpp"
#include "tests/unit/apps/files.hpp"
#include "tests/unit/render/synthetic.hpp"

namespace seiche::apps {

/// A run's folder as `seiche run` writes it, but for the solver: its frames are a lattice that tilts to and fro.
class StoredTank {
 public:
  /// @param more scene keys, TOML
  explicit StoredTank(const test::Scratch& scratch, const std::string& more = "")
      : folder_{scratch / "out", "tank"},
        scene_(parse_scene("fluid.depth = 0.05\ntank.length = 0.2\ntank.height = 0.1\nparticles.spacing = 0.01\n"
                           "motion.type = \"surge\"\nmotion.amplitude = 0.01\n"
                           "time.end = 0.2\noutput.size = \"320x240\"\noutput.frame_rate = 50\n" +
                               more,
                           "tank.toml", {})),
        outputs_(make_outputs(scene_, folder_)) {
    folder_.prepare();
    write_run_json(folder_.record(), scene_, record_);
    outputs_.begin(run_info(scene_));
  }

  /// Adds frames up to number `last`, each with the readings since the one before.
  void write_frames(long last) {
    for (; frames_ <= last; ++frames_) {
      auto frame =
          std::make_shared<Frame>(*test::lattice({.length = 0.2, .height = 0.1, .depth = 0.05, .spacing = 0.01},
                                                 0.1 * std::sin(0.7 * static_cast<double>(frames_)), frames_));
      for (; samples_ <= 20 * frames_; ++samples_) {
        const double time = 1e-3 * static_cast<double>(samples_);
        frame->readings.time.push_back(time);
        for (std::size_t k = 0; k < run_info(scene_).sensors.size(); ++k)
          frame->readings.values.push_back(std::sin(31 * time + static_cast<double>(k)) / 30);
      }
      outputs_.frame(frame);
    }
  }

  /// How it ended.
  void close(Ending::Status status = Ending::Status::finished) {
    const std::string error = outputs_.end();
    if (!error.empty()) throw std::runtime_error(error);
    record_.ending = Ending{status, {}, "", frames_, 0.02 * static_cast<double>(frames_ - 1)};
    write_run_json(folder_.record(), scene_, record_);
  }

  const OutputFolder& folder() const { return folder_; }
  const Scene& scene() const { return scene_; }

 private:
  OutputFolder folder_;
  Scene scene_;
  Outputs outputs_;
  RunRecord record_;
  long frames_ = 0, samples_ = 0;
};

}  // namespace seiche::apps
