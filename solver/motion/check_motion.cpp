#include "solver/motion/check_motion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

template <class... Arguments>
[[noreturn]] void refuse(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  throw BadParameters(fmt::format(text, std::forward<Arguments>(arguments)...));
}

void check_column(const char* name, const std::vector<double>& values, std::size_t samples) {
  if (!values.empty() && values.size() != samples)
    refuse("motion.file has {} samples of {} at {} times", values.size(), name, samples);
  for (double value : values)
    if (!std::isfinite(value)) refuse("motion.file: a value of {} is not finite", name);
}

void check_series(const Parameters::TimeSeries& series, double end) {
  const std::vector<double>& t = series.time;
  if (t.size() < 4) refuse("motion.file has {} samples; a spline needs 4 at least", t.size());
  for (const auto& [name, values] :
       {std::pair{"t", &t}, {"surge", &series.surge}, {"heave", &series.heave}, {"roll", &series.roll}})
    check_column(name, *values, t.size());
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

}  // namespace

void check_motion(const Parameters& p) {
  const Parameters::Motion& m = p.motion;
  const bool terms = m.type == "harmonics", file = m.type == "file", rest = m.type == "none";
  if (terms && m.harmonics.empty())
    refuse("motion.type = harmonics needs its terms: write [[motion.harmonic]] above the keys of each");
  if (!terms && !rest && !m.harmonics.empty())
    refuse("motion.type = {} ignores [[motion.harmonic]]: take motion.type = harmonics, or leave the terms out",
           m.type);
  for (const Parameters::Harmonic& h : m.harmonics)
    if (h.of != "surge" && h.of != "heave" && h.of != "roll")
      refuse("motion.harmonic: of = '{}' is none of surge, heave, roll", h.of);
  if (file && m.file.empty() && m.series.time.empty())
    refuse("motion.type = file needs motion.file, the CSV of its samples");
  if (!file && !rest && !m.file.empty())
    refuse("motion.type = {} ignores motion.file: take motion.type = file, or leave the file out", m.type);
  if (file) check_series(m.series, p.time.end);
}

}  // namespace seiche::solver
