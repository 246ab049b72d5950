#include "apps/scene/files/motion_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/common/csv.hpp"
#include "apps/common/errors.hpp"
#include "apps/scene/files/motion_columns.hpp"
#include "apps/scene/files/motion_tables.hpp"
#include "solver/motion/record.hpp"

namespace seiche::apps {
namespace {

bool is_turned_about_several(const Parameters::TimeSeries& series) {
  return 1 < std::ranges::count_if(degrees_of_freedom, [&](const DegreeOfFreedomRow& row) {
           return row.rotation && std::ranges::any_of(series[row.value], [](double angle) { return angle != 0; });
         });
}

Parameters::TimeSeries any_form(const std::string& text, const std::string& file, const Parameters::Motion& motion,
                                const std::vector<std::string>& columns) {
  if (is_openfoam_table(text)) {
    Parameters::TimeSeries series = openfoam_motion(text, file, motion);
    for (const DegreeOfFreedomRow& row : degrees_of_freedom)
      if (!columns.empty() && std::ranges::find(columns, row.name) == columns.end()) series[row.value].clear();
    if (motion.rotation_order != RotationOrder::xyz && is_turned_about_several(series))
      throw BadScene(fmt::format(
          "{}: OpenFOAM turns by angles about x, then y, then z; set motion.rotation_order = \"xyz\"", file));
    return series;
  }
  if (has_no_titles(text)) return untitled_motion(text, file, motion, columns);
  return titled_motion(Csv(text, file), columns);
}

}  // namespace

Parameters::TimeSeries parse_motion(const std::string& text, const std::string& file, const Parameters::Motion& motion,
                                    const std::string& columns) {
  Parameters::TimeSeries series = any_form(text, file, motion, listed(columns));
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (row.rotation) series[row.value] = solver::unwrapped(series[row.value]);
  return series;
}

Parameters::TimeSeries read_motion_file(const std::string& file, const Parameters::Motion& motion,
                                        const std::string& columns) {
  return parse_motion(read_text_file(file, "motion file"), file, motion, columns);
}

}  // namespace seiche::apps
