#pragma once
#include "solver/choice.hpp"

namespace seiche {

/// What the numbers of a file that doesn't say so itself are in.
enum class LengthUnit { m, cm, mm, inch, foot };

template <>
struct ChoiceTable<LengthUnit> {
  static constexpr std::array rows{Choice{LengthUnit::m, "m", "metres"}, Choice{LengthUnit::cm, "cm", "centimetres"},
                                   Choice{LengthUnit::mm, "mm", "millimetres"},
                                   Choice{LengthUnit::inch, "in", "inches"}, Choice{LengthUnit::foot, "ft", "feet"}};
};

/// One of it [m].
constexpr double metres(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::cm:
      return 1e-2;
    case LengthUnit::mm:
      return 1e-3;
    case LengthUnit::inch:
      return 0.0254;
    case LengthUnit::foot:
      return 0.3048;
    case LengthUnit::m:
      break;
  }
  return 1;
}

}  // namespace seiche
