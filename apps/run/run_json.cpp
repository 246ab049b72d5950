#include "apps/run/run_json.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "apps/common/schema.hpp"
#include "apps/run/run_info.hpp"
#include "apps/scene/lists.hpp"
#include "apps/scene/options.hpp"
#include "apps/scene/scene_text.hpp"
#include "render/files.hpp"

namespace seiche::apps {
namespace {

using Json = nlohmann::ordered_json;

Json tables(const List& list, const Scene& scene) {
  Json result = Json::array();
  for (std::size_t row = 0; row < list.size(scene); ++row) {
    Json& table = result.emplace_back();
    for (const Member& member : list.members) {
      if (is_of_row(member)) continue;
      std::visit([&](const auto& value) { table[std::string(member.key)] = value; }, value_of(member, scene, row));
    }
  }
  return result;
}

Json parameters(const Scene& scene) {
  Json result;
  for (const Option& option : options()) {
    Json& at = option.section.empty() ? result : result[std::string(option.section)];
    std::visit([&](const auto& value) { at[std::string(option.key)] = value; }, value_of(option, scene));
  }
  for (const List& list : lists()) result[std::string(list.section)][std::string(list.key)] = tables(list, scene);
  return result;
}

// As in "surge_m".
std::string series_key(const DegreeOfFreedomRow& row) { return fmt::format("{}_{}", row.name, row.unit()); }

Json mesh_json(const SurfaceMesh& mesh) {
  Json patches = Json::array();
  for (const SurfaceMesh::Patch& patch : mesh.patches)
    patches.push_back({{"name", patch.name}, {"faces", patch.faces}});
  return {{"points_m", mesh.points}, {"patches", patches}};
}

// A gap is null.
Json samples(const Scene& scene) {
  const Parameters::TimeSeries& series = scene.parameters.motion.series;
  Json motion{{"time_s", series.time}};
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (!series[row.value].empty()) motion[series_key(row)] = series[row.value];
  Json result{{"motion", motion}, {"references", Json::array()}};
  for (const render::Reference& reference : scene.look.references)
    result["references"].push_back({{"time_s", reference.series.time}, {"value", reference.series.value}});
  if (const SurfaceMesh& mesh = scene.parameters.tank.mesh; !mesh.points.empty()) result["tank"] = mesh_json(mesh);
  return result;
}

// Coordinates that aren't finite are null.
Json failure(const Failure& failure) {
  Json result{{"time_s", failure.time}, {"step", failure.step}, {"cause", failure.cause}};
  if (!failure.detail.empty()) result["detail"] = failure.detail;
  if (const auto& place = failure.place)
    result["place"] = {{"kind", name(place->kind)}, {"particle", place->id}, {"position_m", place->position}};
  return result;
}

Json ending(const std::optional<Ending>& ending) {
  if (!ending) return Json::object({{"status", "running"}});
  Json result = Json::object({{"status", name(ending->status)}, {"time_s", ending->time}, {"frames", ending->frames}});
  if (ending->failure) result["failure"] = failure(*ending->failure);
  if (!ending->error.empty()) result["error"] = ending->error;
  return result;
}

Json steps(const Statistics& s) {
  return {{"count", s.steps},
          {"shortest_s", s.shortest_step},
          {"longest_s", s.longest_step},
          {"list_builds", s.list_builds}};
}

Json pressure(const Statistics& s) {
  return {{"iterations", s.iterations},
          {"iterations_per_step", s.steps > 0 ? static_cast<double>(s.iterations) / static_cast<double>(s.steps) : 0},
          {"worst_residual", s.worst_residual}};
}

Json particles(const Statistics& s) {
  return {{"fluid", s.fluid_particles}, {"wall", s.wall_particles}, {"dummy", s.dummy_particles},
          {"leaked", s.leaked},         {"spilled", s.spilled},     {"least_distance_m", s.least_distance}};
}

// By stage of a step and by output; the rest of the names tell what they are.
Json seconds(const Times& times) {
  Json result = Json::object();
  for (const auto& [stage, value] : times.stages) result[stage] = value;
  for (const auto& [output, value] : times.outputs) result[output] = value;
  result["waited_for_outputs"] = times.waited;
  result["total"] = times.total;
  return result;
}

Json speed(const RunRecord& record) {
  return {{"particle_steps_per_second", particle_steps_per_second(record.statistics, record.times)},
          {"waited_for_outputs_share", waited_share(record.times)}};
}

Value value_from(const nlohmann::json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_array() && !json.empty() && json.front().is_number()) return json.get<Numbers>();
  if (json.is_array() && !json.empty() && json.front().size() > 2) return json.get<Rows>();
  if (json.is_array()) return json.get<Points>();
  return json.get<std::string>();
}

void refuse_if(const std::optional<std::string>& complaint) {
  if (complaint) throw std::invalid_argument(*complaint);
}

void read_parameters(const nlohmann::json& json, Scene& scene) {
  for (const Option& option : options()) {
    const auto& at = option.section.empty() ? json : json.at(std::string(option.section));
    // An older program may not have known the key: its default is how things were.
    if (const auto found = at.find(std::string(option.key)); found != at.end())
      refuse_if(assign(option, scene, value_from(*found)));
  }
  for (const List& list : lists()) {
    const auto& section = json.at(std::string(list.section));
    const nlohmann::json tables = section.value(std::string(list.key), nlohmann::json::array());
    list.reset(scene, tables.size());
    for (std::size_t row = 0; row < tables.size(); ++row)
      for (const Member& member : list.members)
        if (const auto found = tables[row].find(std::string(member.key)); found != tables[row].end())
          refuse_if(assign(list, member, scene, row, value_from(*found)));
  }
}

std::vector<double> numbers(const nlohmann::json& json) {
  std::vector<double> values;
  for (const auto& each : json)
    values.push_back(each.is_null() ? std::numeric_limits<double>::quiet_NaN() : each.get<double>());
  return values;
}

SurfaceMesh read_mesh(const nlohmann::json& json) {
  SurfaceMesh mesh;
  mesh.points = json.at("points_m");
  for (const auto& patch : json.at("patches")) {
    mesh.patches.push_back({patch.at("name"), patch.at("faces")});
    for (const auto& face : mesh.patches.back().faces)
      for (const int corner : face) std::ignore = mesh.points.at(static_cast<std::size_t>(corner));
  }
  return mesh;
}

Failure read_failure(const nlohmann::json& json) {
  Failure failure{json.at("time_s"), json.at("step"), json.at("cause"), json.value("detail", ""), {}};
  const auto found = json.find("place");
  if (found == json.end()) return failure;
  failure.place = {Kind::fluid, found->at("particle"), numbers(found->at("position_m"))};
  for (const Kind kind : {Kind::wall, Kind::dummy})
    if (found->at("kind") == name(kind)) failure.place->kind = kind;
  return failure;
}

std::optional<Ending> read_ending(const nlohmann::json& json) {
  const std::string status = json.at("status");
  if (status == "running") return {};
  Ending ending;
  for (const auto each : {Ending::Status::finished, Ending::Status::failed, Ending::Status::interrupted})
    if (status == name(each)) ending.status = each;
  ending.time = json.at("time_s");
  ending.frames = json.at("frames");
  if (const auto found = json.find("failure"); found != json.end()) ending.failure = read_failure(*found);
  ending.error = json.value("error", "");
  return ending;
}

// How a run that can't be read is made anew.
std::string remedy(const nlohmann::json& json, const std::filesystem::path& folder) {
  const auto file = nlohmann::json::json_pointer("/scene/file");
  return fmt::format("make it anew with `seiche run {} -o {} --overwrite` and the settings it had",
                     json.contains(file) ? json[file].get<std::string>() : "SCENE", folder.string());
}

void read_statistics(const nlohmann::json& json, Statistics& s) {
  const auto &steps = json.at("steps"), &pressure = json.at("pressure"), &particles = json.at("particles");
  s.steps = steps.at("count");
  s.shortest_step = steps.at("shortest_s");
  s.longest_step = steps.at("longest_s");
  s.list_builds = steps.at("list_builds");
  s.iterations = pressure.at("iterations");
  s.worst_residual = pressure.at("worst_residual");
  s.fluid_particles = particles.at("fluid");
  s.wall_particles = particles.at("wall");
  s.dummy_particles = particles.at("dummy");
  s.leaked = particles.at("leaked");
  s.spilled = particles.at("spilled");
  // Null before it was measured; an older program didn't write it.
  if (const auto least = particles.find("least_distance_m"); least != particles.end() && least->is_number())
    s.least_distance = *least;
}

}  // namespace

void write_run_json(const std::filesystem::path& file, const Scene& scene, const RunRecord& record) {
  Json json{{"seiche", version()},
            {schema_key, run_schema},
            {"scene", {{"name", scene.name}, {"file", scene.file}, {"hash", scene_hash(scene)}}},
            {"run", ending(record.ending)},
            {"particles", particles(record.statistics)},
            {"steps", steps(record.statistics)},
            {"pressure", pressure(record.statistics)},
            {"threads", scene.parameters.threads},
            {"parameters", parameters(scene)}};
  if (record.ending) {
    json["seconds"] = seconds(record.times);
    json["speed"] = speed(record);
  }
  render::write_file(file, json.dump(2) + "\n");
}

void write_samples(const std::filesystem::path& file, const Scene& scene) {
  const Parameters& p = scene.parameters;
  if (p.motion.series.time.empty() && scene.look.references.empty() && p.tank.mesh.points.empty()) return;
  render::write_file(file, samples(scene).dump() + "\n");
}

void read_run_json(const nlohmann::json& json, const std::filesystem::path& folder, Scene& scene, RunRecord& record) {
  check_schema(json, run_schema, remedy(json, folder));
  scene = {};
  scene.name = json.at("scene").at("name");
  scene.file = json.at("scene").at("file");
  scene.parameters.threads = json.at("threads");
  read_parameters(json.at("parameters"), scene);
  record = {};
  record.ending = read_ending(json.at("run"));
  read_statistics(json, record.statistics);
  if (!record.ending) return;
  const auto& seconds = json.at("seconds");
  record.times.total = seconds.at("total");
  record.times.waited = record.ending->waited = seconds.at("waited_for_outputs");
}

void read_samples(const nlohmann::json& json, Scene& scene) {
  const auto& motion = json.at("motion");
  Parameters::TimeSeries& samples = scene.parameters.motion.series;
  samples.time = numbers(motion.at("time_s"));
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (const auto found = motion.find(series_key(row)); found != motion.end()) samples[row.value] = numbers(*found);
  std::size_t row = 0;
  for (render::Reference& reference : scene.look.references) {
    const auto& series = json.at("references").at(row++);
    reference.series = {numbers(series.at("time_s")), numbers(series.at("value"))};
  }
  if (const auto tank = json.find("tank"); tank != json.end()) scene.parameters.tank.mesh = read_mesh(*tank);
}

}  // namespace seiche::apps
