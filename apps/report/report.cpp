#include "apps/report/report.hpp"

#include <algorithm>
#include <charconv>

#include "apps/common/output_folder.hpp"
#include "apps/report/curves.hpp"
#include "apps/report/page.hpp"
#include "render/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {

std::vector<Still> even_stills(const std::vector<fs::path>& pictures, double frame_interval, double end,
                               std::size_t most) {
  const std::size_t count = std::min(most, pictures.size());
  std::vector<Still> stills;
  for (std::size_t i = 0; i < count; ++i) {
    const fs::path& picture = pictures[count == 1 ? 0 : (i * (pictures.size() - 1) + (count - 1) / 2) / (count - 1)];
    const std::string number = picture.stem();
    long index = 0;
    std::from_chars(number.data(), number.data() + number.size(), index);
    stills.push_back({picture, std::min(end, static_cast<double>(index) * frame_interval)});
  }
  return stills;
}

Report report_of(const StoredRun& run, const std::string& command) {
  Report result{run.scene.name, {{run, run.scene.name, stored_readings(run)}}, {}, {}, command};
  const OutputFolder files{run.folder, run.scene.name};
  if (run.scene.writes(OutputKind::movie)) result.movie = files.movie(run.scene.output.movie);
  result.stills = even_stills(stored_pictures(run), run.info.frame_interval, report::reached(result));
  return result;
}

void write_report(const fs::path& file, const Report& report) {
  render::write_file(file, report::page(report, file.parent_path()));
}

}  // namespace seiche::apps
