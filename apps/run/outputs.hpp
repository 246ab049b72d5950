#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "apps/common/output_folder.hpp"
#include "apps/scene/scene.hpp"
#include "solver/frame.hpp"
#include "solver/sink.hpp"

namespace seiche::apps {

/// The sinks of a run, each with a name for the timings.
class Outputs {
 public:
  void add(std::string name, std::unique_ptr<Sink> sink);

  void begin(const RunInfo& run);
  void frame(const FramePtr& frame);

  /// Ends every sink that began, whatever happens to the others, and lets go of all. Returns what went wrong, empty if
  /// nothing.
  std::string end();

  /// Wall-clock time spent in each [s].
  std::map<std::string, double> seconds() const;

 private:
  struct Entry {
    std::string name;
    std::unique_ptr<Sink> sink;
    bool began = false;
    double seconds = 0;
  };
  std::vector<Entry> entries_;
};

/// Adds another error to those there are, "; " between; an empty one, or all of them again, adds nothing.
void add_error(std::string& errors, const std::string& another);

/// What the scene asks for, in its folder.
Outputs make_outputs(const Scene& scene, const OutputFolder& folder);

/// Throws render::NoGl, render::NoEncoder or std::invalid_argument where what the scene asks for can't be made here.
void check_outputs(const Scene& scene, const OutputFolder& folder);

}  // namespace seiche::apps
