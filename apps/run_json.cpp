#include "apps/run_json.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/lists.hpp"
#include "apps/options.hpp"
#include "apps/run_info.hpp"
#include "apps/scene_text.hpp"
#include "render/file.hpp"

namespace seiche::apps {
namespace {

using Json = nlohmann::ordered_json;

Json tables(const List& list, const Scene& scene) {
  Json result = Json::array();
  for (std::size_t row = 0; row < list.size(scene); ++row) {
    Json& table = result.emplace_back();
    for (const Member& member : list.members) {
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

Json ending(const std::optional<Ending>& ending) {
  if (!ending) return Json::object({{"status", "running"}});
  Json result = Json::object({{"status", name(ending->status)}, {"time_s", ending->time}, {"frames", ending->frames}});
  if (!ending->reason.empty()) result["reason"] = ending->reason;
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
          {"iterations_per_step", s.steps > 0 ? static_cast<double>(s.iterations) / s.steps : 0},
          {"worst_residual", s.worst_residual}};
}

Json particles(const Statistics& s) {
  return {{"fluid", s.fluid_particles},
          {"wall", s.wall_particles},
          {"dummy", s.dummy_particles},
          {"leaked", s.leaked},
          {"spilled", s.spilled}};
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

}  // namespace

void write_run_json(const std::filesystem::path& file, const Scene& scene, const RunRecord& record) {
  Json json{{"seiche", version()},
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

}  // namespace seiche::apps
