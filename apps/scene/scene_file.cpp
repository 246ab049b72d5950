#include "apps/scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "apps/common/nearest.hpp"
#include "apps/scene/curve_sensors.hpp"
#include "apps/scene/files/motion_file.hpp"
#include "apps/scene/files/references.hpp"
#include "apps/scene/list_settings.hpp"
#include "apps/scene/sensor_rows.hpp"
#include "apps/scene/tank_settings.hpp"
#include "apps/scene/toml_settings.hpp"
#include "render/check_look.hpp"
#include "solver/check_parameters.hpp"
#include "solver/preset.hpp"

namespace seiche::apps {
namespace {

namespace fs = std::filesystem;

std::string read_text(const std::string& file) {
  // Opening a folder succeeds, reading it throws.
  if (fs::is_directory(file)) throw BadScene(fmt::format("{}: this is a folder, not a scene file", file));
  if (std::ifstream in(file, std::ios::binary); in) return {std::istreambuf_iterator<char>(in), {}};
  if (fs::exists(file)) throw BadScene(fmt::format("{}: this file can't be read", file));

  std::vector<std::string> scenes;
  std::error_code ignored;
  const fs::path folder = fs::path(file).parent_path();
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path().filename());
  }
  std::sort(scenes.begin(), scenes.end());
  const auto guess = nearest(fs::path(file).filename().string(), scenes);
  throw BadScene(fmt::format("{}: there is no such file{}", file,
                             guess ? fmt::format("; did you mean '{}'?", (folder / *guess).string()) : ""));
}

bool is_preset(const Setting& setting) { return setting.option == find_option("", "preset"); }

// Puts the settings into a new scene, the last preset before all else.
Scene assemble(const Settings& all, std::vector<Complaint>& complaints) {
  const std::vector<Setting>& settings = all.good;
  Scene scene;
  const auto put = [&](const Setting& setting) {
    if (const auto complaint = assign(*setting.option, scene, setting.value)) {
      complaints.push_back({fmt::format("{}: {}", setting.origin, *complaint), setting.position});
    }
  };
  for (const Setting& setting : settings) {
    if (is_preset(setting)) put(setting);
  }
  const Preset preset = scene.parameters.preset;
  apply_preset(scene.parameters, preset);
  put_shape(settings, scene);
  for (const Setting& setting : settings) {
    if (!is_preset(setting)) put(setting);
  }
  put_one_level(settings, scene, complaints);
  for (const ListSetting& setting : all.lists) put_list(rows_laid_out(setting, complaints), scene, complaints);
  return scene;
}

// A step of the scene's own must fall on every frame and on the end.
void check_step(const Scene& scene) {
  const double step = scene.parameters.time.step;
  if (step == 0) return;
  const auto check = [&](const char* what, double time) {
    const double steps = time / step;
    if (std::abs(steps - std::round(steps)) > 1e-6)
      throw BadParameters(
          fmt::format("{} = {:.6g} s is {:.3f} steps of time.step = {:.6g} s; it must be a whole number "
                      "of them",
                      what, time, steps, step));
  };
  check("time.end", scene.parameters.time.end);
  check("1/output.frame_rate", 1 / scene.output.frame_rate);
}

// The columns of a file mean nothing to a motion without one; to no motion everything may be left as it is.
void check_columns(const Scene& scene) {
  const Parameters::Motion& motion = scene.parameters.motion;
  if (scene.given.columns.empty() || motion.type == MotionType::file || motion.type == MotionType::none) return;
  throw BadParameters(fmt::format("motion.type = {} ignores motion.columns: take motion.type = file, or leave it out",
                                  motion.type_name()));
}

[[noreturn]] void refuse(std::vector<Complaint> complaints) {
  std::stable_sort(complaints.begin(), complaints.end(),
                   [](const Complaint& a, const Complaint& b) { return a.position < b.position; });
  std::string all;
  for (const Complaint& complaint : complaints) all += (all.empty() ? "" : "\n") + complaint.message;
  throw BadScene(all);
}

}  // namespace

Scene parse_scene(const std::string& toml, const std::string& file, const std::vector<Override>& overrides) {
  Settings all = toml_settings(toml, file);
  Settings more = override_settings(overrides);
  all.good.insert(all.good.end(), more.good.begin(), more.good.end());
  all.lists.insert(all.lists.end(), more.lists.begin(), more.lists.end());
  all.complaints.insert(all.complaints.end(), more.complaints.begin(), more.complaints.end());

  Scene scene = assemble(all, all.complaints);
  if (!all.complaints.empty()) refuse(std::move(all.complaints));
  scene.file = file;
  scene.name = fs::path(file).stem();
  Parameters::Motion& motion = scene.parameters.motion;
  if (motion.type == MotionType::file && !motion.file.empty())
    motion.series =
        read_motion_file((fs::path(file).parent_path() / motion.file).string(), motion, scene.given.columns);
  try {
    settle_tank(scene, fs::path(file).parent_path());
    check_parameters(scene.parameters);
    check_step(scene);
    check_columns(scene);
    render::check_look(scene.look);
    render::check_dimension(scene.look, scene.parameters.dimension());
  } catch (const std::invalid_argument& error) {
    throw BadScene(fmt::format("{}: {}", file, error.what()));
  }
  if (auto complaints = curve_complaints(all, scene); !complaints.empty()) refuse(std::move(complaints));
  read_references(scene, fs::path(file).parent_path());
  return scene;
}

Scene read_scene(const std::string& file, const std::vector<Override>& overrides) {
  return parse_scene(read_text(file), file, overrides);
}

}  // namespace seiche::apps
