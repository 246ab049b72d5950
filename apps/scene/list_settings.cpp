#include "apps/scene/list_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace seiche::apps {
namespace {

using Key = ListSetting::Key;
using Table = ListSetting::Table;

void check_required(const List& list, const Table& table, std::vector<Complaint>& complaints) {
  for (const Member& member : list.members) {
    const auto is_it = [&](const Key& key) { return key.member == &member; };
    if (!member.required || std::any_of(table.keys.begin(), table.keys.end(), is_it)) continue;
    const std::string message =
        fmt::format("{}: {} has no {}; expected {}", table.origin, title(list), member.key, expected(member));
    complaints.push_back({message, table.position});
  }
}

}  // namespace

void put_list(const ListSetting& setting, Scene& scene, std::vector<Complaint>& complaints) {
  const List& list = *setting.list;
  list.reset(scene, setting.tables.size());
  std::set<std::string> names;
  for (std::size_t row = 0; row < setting.tables.size(); ++row) {
    check_required(list, setting.tables[row], complaints);
    for (const Key& key : setting.tables[row].keys) {
      const Member& member = *key.member;
      auto complaint = assign(list, member, scene, row, key.value);
      if (!complaint && std::holds_alternative<Name>(member.rule)) {
        const std::string& name = std::get<std::string>(key.value);
        if (!names.insert(name).second)
          complaint = refusal(title(list, member), "another name in each", name, "is taken by one above");
      }
      if (complaint) complaints.push_back({fmt::format("{}: {}", key.origin, *complaint), key.position});
    }
  }
}

}  // namespace seiche::apps
