#include "render/picture/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace seiche::render {
namespace {

double speed(const Float3& velocity) {
  const double x = velocity[0], y = velocity[1], z = velocity[2];
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

// In the order of Quantity.
const std::vector<std::string>& quantity_names() {
  static const std::vector<std::string> names{"pressure", "speed", "number-density", "free-surface", "kind"};
  return names;
}

Quantity quantity_of(const std::string& name) {
  const auto& names = quantity_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw std::invalid_argument(
        fmt::format("there is no quantity '{}'; choose one of {}", name, fmt::join(names, ", ")));
  return static_cast<Quantity>(found - names.begin());
}

const char* title_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::pressure:
      return "pressure [Pa]";
    case Quantity::speed:
      return "speed [m/s]";
    case Quantity::number_density:
      return "number density n/n\u2080";
    case Quantity::free_surface:
    case Quantity::kind:
      return "particles";
  }
  return "";
}

double value_of(Quantity quantity, const Frame& frame, std::size_t particle) {
  switch (quantity) {
    case Quantity::pressure:
      return frame.pressure[particle];
    case Quantity::speed:
      return speed(frame.velocity[particle]);
    case Quantity::number_density:
      return frame.number_density[particle];
    case Quantity::free_surface:
      return frame.free_surface[particle] ? 1 : 0;
    case Quantity::kind:
      return static_cast<double>(frame.kind[particle]);
  }
  return 0;
}

// Of M. Okabe, K. Ito, Color Universal Design, 2008, but for the greys.
const std::vector<Class>& classes_of(Quantity quantity) {
  static const std::vector<Class> none, surface{{"inside", {86, 180, 233}}, {"free surface", {213, 94, 0}}},
      kinds{{"fluid", {0, 114, 178}}, {"wall", {230, 159, 0}}, {"dummy", {170, 174, 180}}};
  if (quantity == Quantity::free_surface) return surface;
  return quantity == Quantity::kind ? kinds : none;
}

}  // namespace seiche::render
