#include "apps/scene/stl/stl_builder.hpp"

#include <algorithm>

namespace seiche::apps {
namespace {

constexpr std::size_t longest_name = 60;

std::string printable(std::string_view name) {
  std::string text(name.substr(0, longest_name));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

}  // namespace

void StlBuilder::begin_solid(std::string_view name) {
  std::string text = printable(name);
  if (text.empty()) {
    ++unnamed_;
    text = unnamed_ > 1 ? "wall-" + std::to_string(unnamed_) : "wall";
  }
  auto& patches = surface_.mesh.patches;
  const auto same = std::find_if(patches.begin(), patches.end(), [&](const auto& patch) { return patch.name == text; });
  patch_ = static_cast<std::size_t>(same - patches.begin());
  if (same == patches.end()) patches.push_back({std::move(text), {}});
}

int StlBuilder::place_of(const std::array<double, 3>& point) {
  auto& points = surface_.mesh.points;
  const auto [at, is_new] = places_.try_emplace(point, static_cast<int>(points.size()));
  if (is_new) points.push_back({metres_ * point[0], metres_ * point[1], metres_ * point[2]});
  return at->second;
}

void StlBuilder::add(const std::array<std::array<double, 3>, 3>& corners) {
  const auto& [a, b, c] = corners;
  if (a == b || b == c || c == a) {
    ++surface_.degenerate;
    return;
  }
  surface_.mesh.patches.at(patch_).faces.push_back({place_of(a), place_of(b), place_of(c)});
}

StlSurface StlBuilder::result() && {
  std::erase_if(surface_.mesh.patches, [](const auto& patch) { return patch.faces.empty(); });
  return std::move(surface_);
}

}  // namespace seiche::apps
