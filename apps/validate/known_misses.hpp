#pragma once
#include <string>
#include <vector>

#include "apps/validate/figure.hpp"

namespace seiche::apps::validate {

/// A known miss, and the figure that it is of.
struct KnownMissOf {
  std::string name;    ///< of the case
  std::string figure;  ///< its name
  KnownMiss miss;
};

/// Marks those figures of a case that are in the list.
void mark_known_misses(const std::string& name, std::vector<Figure>& figures, const std::vector<KnownMissOf>& known);

}  // namespace seiche::apps::validate
