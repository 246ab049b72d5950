#include "apps/validate/surface.hpp"

#include <algorithm>
#include <numeric>

namespace seiche::apps::validate {
std::vector<double> stations(double length, int count) {
  std::vector<double> x(count);
  for (int i = 0; i < count; ++i) x[i] = length * (i + 0.5) / count;
  return x;
}

Series profile(const Recording& recording, double time) {
  Series heights;
  for (std::size_t k = 0; k < recording.stations.size(); ++k) {
    heights.t.push_back(recording.stations[k]);
    heights.y.push_back(recording.parameters.fluid.depth + recording.sensors.at(station_column(k)).at(time));
  }
  return heights;
}

double mean_height(const Recording& recording, double from, double to) {
  double sum = 0;
  for (std::size_t k = 0; k < recording.stations.size(); ++k) {
    const Series part = recording.sensors.at(station_column(k)).between(from, to);
    sum += std::accumulate(part.y.begin(), part.y.end(), 0.0) / static_cast<double>(part.size());
  }
  return recording.parameters.fluid.depth + sum / static_cast<double>(recording.stations.size());
}

double front(const Frame& frame, double spacing) {
  std::vector<std::size_t> fluid;
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (frame.kind[i] == Kind::fluid) fluid.push_back(i);
  // From the right: the first particle that isn't alone is the front.
  std::sort(fluid.begin(), fluid.end(),
            [&](std::size_t a, std::size_t b) { return frame.position[a][0] > frame.position[b][0]; });
  for (const std::size_t i : fluid) {
    const auto close = [&](std::size_t j) {
      const double dx = frame.position[j][0] - frame.position[i][0], dy = frame.position[j][1] - frame.position[i][1];
      return j != i && dx * dx + dy * dy < 2.25 * spacing * spacing;
    };
    if (std::count_if(fluid.begin(), fluid.end(), close) >= 2) return frame.position[i][0] + 0.5 * spacing;
  }
  return 0;
}

ProfileDistance profile_distance(const Series& reference, const Series& series, double from, double to) {
  ProfileDistance d;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series.t[i] < from || series.t[i] > to) continue;
    const double e = series.y[i] - reference.at(series.t[i]);
    d.squares += e * e;
    ++d.count;
  }
  return d;
}

}  // namespace seiche::apps::validate
