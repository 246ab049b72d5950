#include "solver/motion/check_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "solver/errors.hpp"
#include "solver/motion/motion.hpp"

namespace seiche::solver {
namespace {

template <class... Arguments>
[[noreturn]] void refuse(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  throw BadParameters(fmt::format(text, std::forward<Arguments>(arguments)...));
}

void check_column(std::string_view name, const std::vector<double>& values, std::size_t samples) {
  if (!values.empty() && values.size() != samples)
    refuse("motion.file has {} samples of {} at {} times", values.size(), name, samples);
  for (double value : values)
    if (!std::isfinite(value)) refuse("motion.file: a value of {} is not finite", name);
}

void check_span(const Parameters::Motion& m, double end) {
  const double first = m.series.time.front(), last = m.series.time.back();
  // What is left after the rounding of decimals is no gap.
  const double slack = 1e-9 * end;
  if (m.hold) {
    if (m.from + end < first || m.from > last)
      refuse(
          "motion.file holds the motion from {:g} to {:g} s, none of it in the run, which takes {:g} to {:g} s of it: "
          "set motion.from",
          first, last, m.from, m.from + end);
    return;
  }
  if (first > m.from + slack)
    refuse(
        "motion.file begins at {:g} s, the run needs it from {:g} s on: set motion.from = {:g} to begin the run there, "
        "or motion.hold = true to let the tank stand still until then",
        first, m.from, first);
  if (last < m.from + end - slack) {
    const std::string shorten =
        last > m.from ? fmt::format("set time.end = {:g}", last - m.from) : std::string("set a smaller motion.from");
    refuse(
        "motion.file ends at {:g} s, the run needs it up to {:g} s: {}, or motion.hold = true to let the tank stand "
        "still from then on",
        last, m.from + end, shorten);
  }
}

void check_series(const Parameters::TimeSeries& series) {
  const std::vector<double>& t = series.time;
  if (t.size() < 4) refuse("motion.file has {} samples; a spline needs 4 at least", t.size());
  check_column("t", t, t.size());
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) check_column(row.name, series[row.value], t.size());
  for (std::size_t k = 1; k < t.size(); ++k)
    if (!(t[k] > t[k - 1])) refuse("motion.file: t = {:g} s comes after {:g} s; times must ascend", t[k], t[k - 1]);
}

/// Names of those that the motion moves, by whether they keep the plane.
std::string moved(const Motion& motion, const Parameters::Motion& m, bool keep_plane) {
  std::vector<std::string_view> names;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (motion.moves(row.value) && in_plane(row, m) == keep_plane) names.push_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void check_plane(const Parameters::Motion& m) {
  const Motion motion(m);
  const std::string leaving = moved(motion, m, false), staying = moved(motion, m, true);
  if (leaving.empty()) return;
  std::vector<std::string_view> plane;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (in_plane(row, m)) plane.push_back(row.name);
  const std::string remedy = m.type == MotionType::file && !staying.empty()
                                 ? fmt::format("follow motion.columns = \"{}\" alone, or make the tank 3-D", staying)
                                 : "leave it out, or make the tank 3-D, a box by tank.width";
  refuse("motion: {} would leave the plane of a 2-D run, which has {} by motion.axes = \"{}\"; {}", leaving,
         fmt::join(plane, ", "), name(m.axes), remedy);
}

void check_axes(const Parameters::Motion& m) {
  if (m.axes == MotionAxes::ship && m.tank_x == TankX::none)
    refuse(
        "motion.axes = \"ship\" needs motion.tank_x: \"forward\" or \"port\", where the tank's x points in the ship");
  if (m.axes == MotionAxes::tank && m.tank_x != TankX::none)
    refuse(
        "motion.tank_x = \"{}\" means nothing to motion.axes = \"tank\": take motion.axes = \"ship\", or leave it out",
        name(m.tank_x));
}

/// What is for a file alone.
void check_no_record(const Parameters::Motion& m) {
  for (const auto& [key, given] : {std::pair{"from", m.from != 0}, {"hold", m.hold}, {"cutoff", m.cutoff > 0}})
    if (given)
      refuse("motion.type = {} ignores motion.{}: take motion.type = file, or leave it out", m.type_name(), key);
}

}  // namespace

void check_motion(const Parameters& p) {
  const Parameters::Motion& m = p.motion;
  const bool terms = m.type == MotionType::harmonics, file = m.type == MotionType::file;
  const bool rest = m.type == MotionType::none;
  if (terms && m.harmonics.empty())
    refuse("motion.type = harmonics needs its terms: write [[motion.harmonic]] above the keys of each");
  if (!terms && !rest && !m.harmonics.empty())
    refuse("motion.type = {} ignores [[motion.harmonic]]: take motion.type = harmonics, or leave the terms out",
           m.type_name());
  if (file && m.file.empty() && m.series.time.empty())
    refuse("motion.type = file needs motion.file, the CSV of its samples");
  if (!file && !rest && !m.file.empty())
    refuse("motion.type = {} ignores motion.file: take motion.type = file, or leave the file out", m.type_name());
  check_axes(m);
  if (file) {
    check_series(m.series);
    check_span(m, p.time.end);
  } else if (!rest) {
    check_no_record(m);
  }
  if (p.dimension() == 2) check_plane(m);
}

}  // namespace seiche::solver
