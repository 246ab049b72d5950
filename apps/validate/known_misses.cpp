#include "apps/validate/known_misses.hpp"

namespace seiche::apps::validate {

void mark_known_misses(const std::string& name, std::vector<Figure>& figures, const std::vector<KnownMissOf>& known) {
  for (const KnownMissOf& each : known) {
    if (each.name != name) continue;
    for (Figure& figure : figures)
      // A coarser run may only report it.
      if (figure.name == each.figure && figure.target) figure.known = each.miss;
  }
}

}  // namespace seiche::apps::validate
