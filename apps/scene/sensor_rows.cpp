#include "apps/scene/sensor_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace seiche::apps {
namespace {

using Key = ListSetting::Key;
using Table = ListSetting::Table;

constexpr std::array places{"x", "y", "z"};

const Key* find(const Table& table, RowKey of) {
  for (const Key& key : table.keys)
    if (const RowKey* found = std::get_if<RowKey>(&key.member->access); found && *found == of) return &key;
  return nullptr;
}

/// The ends of a row, and its count.
struct Row {
  std::array<double, 3> from{}, to{};
  std::int64_t count = 0;
};

class Reader {
 public:
  Reader(const ListSetting& setting, const Table& table, std::vector<Complaint>& complaints)
      : list_(*setting.list), table_(table), complaints_(complaints) {}

  /// Nothing where a complaint was added.
  std::optional<Row> row() {
    Row row;
    const bool good = take(RowKey::from, row.from) & take(RowKey::to, row.to) & take_count(row.count);
    bool free = true;
    for (const Key& key : table_.keys)
      if (std::find(places.begin(), places.end(), key.member->key) != places.end())
        free = complain(key,
                        fmt::format("{} and from both tell where it is; leave one of them", title(list_, *key.member)));
    return good && free ? std::optional(row) : std::nullopt;
  }

 private:
  bool complain(const Key& key, const std::string& what) {
    complaints_.push_back({fmt::format("{}: {}", key.origin, what), key.position});
    return false;
  }

  const Key* needed(RowKey of) {
    const Key* key = find(table_, of);
    if (!key)
      complaints_.push_back({fmt::format("{}: {} has a part of from, to and count; a row of sensors needs all three",
                                         table_.origin, title(list_)),
                             table_.position});
    return key;
  }

  template <class Target>
  bool put_into(const Key& key, Target& target) {
    const auto complaint =
        put(key.value, {&target, key.member->rule, title(list_, *key.member), expected(*key.member)});
    return !complaint || complain(key, *complaint);
  }

  bool take(RowKey of, std::array<double, 3>& place) {
    const Key* key = needed(of);
    return key && put_into(*key, place);
  }

  bool take_count(std::int64_t& count) {
    const Key* key = needed(RowKey::count);
    int whole = 0;
    if (!key || !put_into(*key, whole)) return false;
    count = whole;
    return true;
  }

  const List& list_;
  const Table& table_;
  std::vector<Complaint>& complaints_;
};

/// The table of sensor k of a row, from 0.
Table laid_out(const List& list, const Table& table, const Row& row, std::int64_t k) {
  Table one{table.origin, table.position, {}};
  for (Key key : table.keys) {
    if (is_of_row(*key.member)) continue;
    if (auto* name = std::get_if<std::string>(&key.value); name && std::holds_alternative<Name>(key.member->rule))
      *name += fmt::format("_{}", k + 1);
    one.keys.push_back(std::move(key));
  }
  const double share = static_cast<double>(k) / static_cast<double>(row.count - 1);
  for (std::size_t axis = 0; axis < places.size(); ++axis)
    one.keys.push_back({table.origin, table.position, find_member(list, places[axis]),
                        row.from[axis] + share * (row.to[axis] - row.from[axis])});
  return one;
}

}  // namespace

ListSetting rows_laid_out(const ListSetting& setting, std::vector<Complaint>& complaints) {
  ListSetting all{setting.list, {}};
  for (const Table& table : setting.tables) {
    if (std::ranges::none_of(table.keys, [](const Key& key) { return is_of_row(*key.member); })) {
      all.tables.push_back(table);
    } else if (const auto row = Reader(setting, table, complaints).row()) {
      for (std::int64_t k = 0; k < row->count; ++k) all.tables.push_back(laid_out(*setting.list, table, *row, k));
    }
  }
  return all;
}

}  // namespace seiche::apps
