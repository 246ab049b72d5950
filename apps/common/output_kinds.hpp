#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "render/movie_format.hpp"

// What a run may write beside run.json. The keys of [output], --overwrite and a run's last words read the table.
namespace seiche::apps {

/// `report` is the last; each is written unless a scene says false.
enum class OutputKind { pictures, movie, vtu, probes, report };

/// A file of a run's folder, or a series of files by frame number; "{}" stands for the scene's name.
struct OutputFile {
  std::string folder, name;  ///< as in "vtu", "{}_"; folder empty: the run's own
  std::string suffix;
  bool numbered = false;  ///< six digits or more stand before the suffix
};

struct OutputRow {
  OutputKind kind;
  std::string_view key;           ///< of [output]
  std::string_view help;          ///< of the key
  std::string_view title;         ///< in the last words of a run
  std::vector<OutputFile> files;  ///< that a run may leave; the last words name the first that is there
};

// Of all formats: an earlier run may have had another.
inline std::vector<OutputFile> movies() {
  std::vector<OutputFile> files;
  for (const render::MovieRow& format : ChoiceTable<render::MovieFormat>::rows)
    if (format.value != render::MovieFormat::none) files.push_back({"", "{}", std::string(format.suffix)});
  return files;
}

/// In the order of OutputKind.
inline const std::vector<OutputRow>& output_rows() {
  static const std::vector<OutputRow> rows{
      {OutputKind::pictures, "pictures", "frames/000123.png", "pictures", {{"frames", "", ".png", true}}},
      {OutputKind::movie, "movie", "format of the movie", "movie", movies()},
      {OutputKind::vtu,
       "vtu",
       "particles for ParaView: vtu/ and the .pvd that lists them",
       "ParaView",
       {{"", "{}", ".pvd"}, {"", "{}", ".vtu.series"}, {"vtu", "{}_", ".vtu", true}}},
      {OutputKind::probes, "probes", "sensor readings: probes.csv", "curves", {{"", "probes", ".csv"}}},
      {OutputKind::report,
       "report",
       "a page of movie, curves and measures: report.html",
       "report",
       {{"", "report", ".html"}}},
  };
  return rows;
}

inline const OutputRow& output_row(OutputKind kind) { return output_rows()[static_cast<std::size_t>(kind)]; }

constexpr std::size_t output_kinds = static_cast<std::size_t>(OutputKind::report) + 1;

/// Which kinds a scene asks for; all, unless told.
class WantedOutputs {
 public:
  WantedOutputs() { wanted_.fill(true); }
  bool& operator[](OutputKind kind) { return wanted_[static_cast<std::size_t>(kind)]; }
  bool operator[](OutputKind kind) const { return wanted_[static_cast<std::size_t>(kind)]; }

 private:
  std::array<bool, output_kinds> wanted_;
};

}  // namespace seiche::apps
