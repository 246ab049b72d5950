#include "solver/modes/cut_out.hpp"

#include <algorithm>

#include "solver/modes/arrangement.hpp"
#include "solver/tank/edge.hpp"

namespace seiche::solver::modes {
namespace {

using Points = std::vector<Vec<2>>;

double signed_area(const Points& points) {
  double twice = 0;
  for (std::size_t k = 0; k < points.size(); ++k) twice += cross(points[k], points[(k + 1) % points.size()]);
  return 0.5 * twice;
}

struct Cut {
  double tolerance;
  Arrangement all;
  /// Of all loops of the section; of each solid; of all plates.
  std::vector<Way> section;
  std::vector<std::vector<Way>> solids;
  std::vector<Way> plates;

  const Vec<2>& at(int k) const { return all.points[static_cast<std::size_t>(k)]; }

  bool is_inside(const std::vector<Way>& loops, const Vec<2>& r) const {
    bool inside = false;
    for (const auto& [from, to] : loops) {
      const Vec<2>&a = at(from), &b = at(to);
      if ((a[1] > r[1]) != (b[1] > r[1]) && r[0] < a[0] + (r[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        inside = !inside;
    }
    return inside;
  }

  /// Whether there may be liquid just to the left of the way's middle.
  bool is_wall(const Way& way) const {
    const Vec<2> along = at(way.second) - at(way.first);
    const Vec<2> left = at(way.first) + 0.5 * along + 0.1 * tolerance * Vec<2>(-along[1], along[0]).normalized();
    return is_inside(section, left) &&
           std::none_of(solids.begin(), solids.end(), [&](const auto& solid) { return is_inside(solid, left); });
  }
};

Cut cut_up(const Polygons& section, const Polygons& solids, const Polygons& plates) {
  std::vector<std::array<Vec<2>, 2>> lines;
  const auto add = [&](const Points& points, bool closed) {
    for (std::size_t k = 0; k + (closed ? 0 : 1) < points.size(); ++k)
      lines.push_back({points[k], points[(k + 1) % points.size()]});
  };
  for (const Points& loop : section) add(loop, true);
  double size = 0;
  for (const auto& line : lines) size = std::max(size, (line[0] - lines[0][0]).cwiseAbs().maxCoeff());
  const std::size_t section_end = lines.size();
  std::vector<std::size_t> ends;
  for (const Points& solid : solids) {
    add(signed_area(solid) > 0 ? Points(solid.rbegin(), solid.rend()) : solid, true);
    ends.push_back(lines.size());
  }
  for (const Points& plate : plates) add(plate, false);

  const double tolerance = 1e-9 * size;
  Cut cut{tolerance, arranged(lines, tolerance), {}, {}, {}};
  const auto ways = [&](std::size_t from, std::size_t to) {
    std::vector<Way> some;
    for (std::size_t k = from; k < to; ++k) some.insert(some.end(), cut.all.ways[k].begin(), cut.all.ways[k].end());
    return some;
  };
  cut.section = ways(0, section_end);
  std::size_t from = section_end;
  for (const std::size_t end : ends) {
    cut.solids.push_back(ways(from, end));
    from = end;
  }
  cut.plates = ways(from, lines.size());
  return cut;
}

}  // namespace

Polygons cut_out(const Polygons& section, const Polygons& solids, const Polygons& plates) {
  const Cut cut = cut_up(section, solids, plates);
  std::set<Way> kept;
  const auto keep = [&](const Way& way) {
    if (cut.is_wall(way)) kept.insert(way);
  };
  for (const Way& way : cut.section) keep(way);
  for (const auto& solid : cut.solids)
    for (const Way& way : solid) keep(way);
  for (const Way& way : cut.plates) {
    keep(way);
    keep({way.second, way.first});
  }
  return walks(cut.all.points, std::move(kept));
}

}  // namespace seiche::solver::modes
