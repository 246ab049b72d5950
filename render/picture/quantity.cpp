#include "render/picture/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace seiche::render {

std::string title_of(Quantity quantity) {
  const QuantityRow& row = row_of(quantity);
  return row.unit.empty() ? std::string(row.title) : fmt::format("{} [{}]", row.title, row.unit);
}

double value_of(Quantity quantity, const Frame& frame, std::size_t particle) {
  if (const auto of = row_of(quantity).of) return of(frame, particle);
  const auto found = std::ranges::find(frame.derived, quantity, &DerivedField::quantity);
  if (found == frame.derived.end())
    throw std::runtime_error(fmt::format(
        "frame {} was stored without {}; choose another quantity or run the scene again", frame.index, name(quantity)));
  return found->values[particle];
}

// Of M. Okabe, K. Ito, Color Universal Design, 2008, but for the greys.
const std::vector<Class>& classes_of(Quantity quantity) {
  static const std::vector<Class> none, surface{{"inside", {86, 180, 233}}, {"free surface", {213, 94, 0}}},
      kinds{{"fluid", {0, 114, 178}}, {"wall", {230, 159, 0}}, {"dummy", {170, 174, 180}}};
  if (quantity == Quantity::free_surface) return surface;
  return quantity == Quantity::kind ? kinds : none;
}

}  // namespace seiche::render
