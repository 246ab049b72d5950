#pragma once
#include <limits>
#include <string>

#include "apps/scene/lists.hpp"
#include "apps/scene/options.hpp"

namespace seiche::apps {

/// Where something stands in a scene file; what the command line says comes after all of it.
struct Position {
  unsigned line = std::numeric_limits<unsigned>::max();
  unsigned column = 0;
  auto operator<=>(const Position&) const = default;  // NOLINT(modernize-use-nullptr): the 0 is the compiler's
};

/// A key with the value it is given, not yet put into a scene.
struct Setting {
  std::string origin;  ///< for messages: file:line:column, or the flag as the user wrote it
  Position position;
  const Option* option;
  Value value;
};

/// A list with the tables that it is given, not yet put into a scene.
struct ListSetting {
  struct Key {
    std::string origin;
    Position position;
    const Member* member;
    Value value;
  };
  struct Table {
    std::string origin;
    Position position;
    std::vector<Key> keys;
  };
  const List* list;
  std::vector<Table> tables;
};

/// Something wrong, fit for the user.
struct Complaint {
  std::string message;
  Position position;
};

/// What a source of settings holds, and what is wrong with it.
struct Settings {
  std::vector<Setting> good;
  std::vector<ListSetting> lists;
  std::vector<Complaint> complaints;
};

}  // namespace seiche::apps
