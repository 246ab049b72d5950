#include "solver/motion/check_motion.hpp"

#include <fmt/format.h>

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

void check_series(const Parameters::TimeSeries& series, double end) {
  const std::vector<double>& t = series.time;
  if (t.size() < 4) refuse("motion.file has {} samples; a spline needs 4 at least", t.size());
  check_column("t", t, t.size());
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) check_column(row.name, series[row.value], t.size());
  for (std::size_t k = 1; k < t.size(); ++k)
    if (!(t[k] > t[k - 1])) refuse("motion.file: t = {:g} s comes after {:g} s; times must ascend", t[k], t[k - 1]);
  // What is left after the rounding of decimals is no gap.
  const double slack = 1e-9 * end;
  if (t.front() > slack || t.back() < end - slack)
    refuse(
        "motion.file holds the motion from {:g} to {:g} s, the run needs 0 to {:g} s: shorten time.end or lengthen the "
        "file",
        t.front(), t.back(), end);
}

void check_plane(const Parameters::Motion& m) {
  const Motion motion(m);
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (motion.moves(row.value) && !row.in_plane())
      refuse("motion: {} leaves the plane of a 2-D run; a run is 3-D with tank.width above 0", row.name);
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
  if (file) check_series(m.series, p.time.end);
  if (p.dimension() == 2) check_plane(m);
}

}  // namespace seiche::solver
