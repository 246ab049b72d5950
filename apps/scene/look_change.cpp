#include "apps/scene/look_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "apps/common/errors.hpp"
#include "apps/scene/curve_sensors.hpp"
#include "apps/scene/files/references.hpp"
#include "apps/scene/list_settings.hpp"
#include "render/picture.hpp"

namespace seiche::apps {
namespace {

void refuse(const std::vector<Complaint>& complaints) {
  if (complaints.empty()) return;
  std::string all;
  for (const Complaint& complaint : complaints) all += (all.empty() ? "" : "\n") + complaint.message;
  throw BadScene(all);
}

Complaint fixed(const std::string& origin, const std::string& key) {
  return {fmt::format("{}: {} is settled by the run; only [look] and output.size can be changed without running the "
                      "scene again",
                      origin, key),
          {}};
}

}  // namespace

void change_look(Scene& scene, const std::vector<Override>& overrides) {
  const Quantity before = scene.look.quantity;
  const Settings all = override_settings(overrides);
  std::vector<Complaint> complaints = all.complaints;
  for (const Setting& setting : all.good) {
    const Option& option = *setting.option;
    if (option.section != "look" && dotted(option) != "output.size")
      complaints.push_back(fixed(setting.origin, dotted(option)));
    else if (const auto complaint = assign(option, scene, setting.value))
      complaints.push_back({fmt::format("{}: {}", setting.origin, *complaint), {}});
  }
  for (const ListSetting& setting : all.lists) {
    if (setting.list->section == "look")
      put_list(setting, scene, complaints);
    else
      complaints.push_back(
          fixed(setting.tables.empty() ? dotted(*setting.list) : setting.tables.front().origin, dotted(*setting.list)));
  }
  refuse(complaints);
  const bool ranged = std::any_of(all.good.begin(), all.good.end(), [](const Setting& setting) {
    return setting.option == find_option("look", "range");
  });
  if (scene.look.quantity != before && !ranged && scene.look.range.source == render::RangeSource::given)
    scene.look.range = {};
  refuse(curve_complaints(all, scene));
  if (!all.lists.empty()) read_references(scene, std::filesystem::path(scene.file).parent_path());
}

}  // namespace seiche::apps
