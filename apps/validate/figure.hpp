#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace seiche::apps::validate {

/// Where a value must lie, ends included.
struct Target {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool holds(double value) const { return value >= low && value <= high; }
};
inline Target at_most(double high) { return {.high = high}; }
inline Target at_least(double low) { return {.low = low}; }
inline Target within(double both) { return {-both, both}; }

/// Why a figure misses its target, where that is known.
struct KnownMiss {
  std::string reason;
  Target worst;  ///< where the value must lie still
};

/// One number of a case, beside what it ought to be.
struct Figure {
  std::string name;
  double value;
  std::string unit;              ///< of value and target, as in "%"
  std::optional<Target> target;  ///< none: reported only
  std::optional<KnownMiss> known = {};

  bool met() const { return !target || target->holds(value); }
  bool is_known_miss() const { return !met() && known && known->worst.holds(value); }
};

/// As in "0.12 %"; three digits, but whole numbers up to 9999 in full.
std::string value_text(const Figure& figure);

/// As in "<= 1 %", or "-" where there is none.
std::string target_text(const Figure& figure);

/// "met", "missed by 0.2 %", "known miss by 0.2 %", "met, no known miss any more", or "-" where there is no target.
std::string verdict(const Figure& figure);

}  // namespace seiche::apps::validate
