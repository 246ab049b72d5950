#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/common/series.hpp"
#include "apps/scene/scene.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"
#include "solver/statistics.hpp"

namespace seiche::apps::validate {

/// The user has stopped the runs.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

/// What a run leaves for the measures.
struct Recording {
  Parameters parameters;
  std::map<std::string, Series> sensors;  ///< by column, as in "eta_left"; 1000 samples a second
  std::vector<double> stations;           ///< x of the wave gauges that the bench was asked for [m]
  Statistics statistics;
  double end = 0;       ///< simulated [s]
  std::string failure;  ///< why the run ended before its time; empty if it did not
};

/// Column of the wave gauge at the recording's station number `k`.
std::string station_column(std::size_t k);

/// Sees each frame of a run.
using Look = std::function<void(const Frame&, const RunInfo&)>;

/// Runs scenes for the cases, and tells standard output of each.
class Bench {
 public:
  /// @param scenes folder of the scenes and of reference/
  /// @param stop asked after each step of a run
  Bench(std::filesystem::path scenes, bool quick, int threads, std::function<bool()> stop)
      : scenes_(std::move(scenes)), quick_(quick), threads_(threads), stop_(std::move(stop)) {}

  bool quick() const { return quick_; }

  /// The scene NAME.toml with settings such as "particles.spacing=0.01". Throws BadScene.
  Scene scene(const std::string& name, const std::vector<std::string>& settings) const;

  /// Runs it to its end, with wave gauges at the stations beside its own sensors. Throws std::runtime_error where the
  /// end isn't reached, Interrupted, BadScene.
  Recording run(const std::string& name, const std::vector<std::string>& settings, const Look& look = {},
                const std::vector<double>& stations = {});

  /// The same for a run that may fail: the recording says why.
  Recording attempt(const std::string& name, const std::vector<std::string>& settings, const Look& look = {},
                    const std::vector<double>& stations = {});

  /// reference/FILE.csv. Throws std::runtime_error.
  Series reference(const std::string& file, const std::string& over, const std::string& column) const;

 private:
  std::filesystem::path scenes_;
  bool quick_;
  int threads_;
  std::function<bool()> stop_;
};

}  // namespace seiche::apps::validate
