#pragma once
#include <string>
#include <vector>

#include "solver/column.hpp"

namespace seiche::test {

/// The columns as files head them.
inline std::vector<std::string> headers(const std::vector<Column>& columns) {
  std::vector<std::string> all;
  for (const Column& column : columns) all.push_back(header(column));
  return all;
}

}  // namespace seiche::test
