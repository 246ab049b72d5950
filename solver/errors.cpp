#include "solver/errors.hpp"

#include <fmt/format.h>

namespace seiche {
namespace {

std::string text(const Failure::Particle& particle) {
  std::string where;
  for (std::size_t axis = 0; axis < particle.position.size(); ++axis)
    where += fmt::format("{}{} = {:.4g} m", axis > 0 ? ", " : "", "xyz"[axis], particle.position[axis]);
  return fmt::format("{} particle {} at {}", name(particle.kind), particle.id, where);
}

}  // namespace

const char* name(Kind kind) {
  switch (kind) {
    case Kind::fluid:
      return "fluid";
    case Kind::wall:
      return "wall";
    case Kind::dummy:
      return "dummy";
  }
  return "";
}

std::string cause_text(const Failure& failure) {
  std::string result = failure.cause;
  if (!failure.detail.empty()) result += fmt::format(" ({})", failure.detail);
  if (failure.place) result += fmt::format(" ({})", text(*failure.place));
  return result;
}

std::string sentence(const Failure& failure) {
  return fmt::format("stopped at t = {:.4f} s, step {}: {}", failure.time, failure.step, cause_text(failure));
}

}  // namespace seiche
