#include <fmt/format.h>

#include "render/files/file.hpp"
#include "render/files/provenance.hpp"
#include "render/files/vtu.hpp"
#include "render/outputs.hpp"

namespace seiche::render {
namespace {

// For an attribute of XML as for a string of JSON, in their own ways.
std::string escaped(const std::string& text, bool json) {
  std::string out;
  for (const char c : text) {
    if (json && (c == '"' || c == '\\'))
      out += fmt::format("\\{}", c);
    else if (!json && (c == '"' || c == '&' || c == '<'))
      out += fmt::format("&#{};", static_cast<int>(c));
    else
      out += c;
  }
  return out;
}

class VtuSeries : public Sink {
 public:
  explicit VtuSeries(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void begin(const RunInfo& run) override { run_ = run; }

  void frame(const FramePtr& frame) override {
    const std::string name = fmt::format("vtu/{}_{:06}.vtu", run_.name, frame->index);
    write_vtu(folder_ / name, *frame, provenance(run_, *frame));
    const std::string time = fmt::format("{:.9g}", frame->time);
    pvd_ += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, escaped(name, false));
    series_ += fmt::format("{}\n    {{\"name\": \"{}\", \"time\": {}}}", series_.empty() ? "" : ",",
                           escaped(name, true), time);
    write_lists();
  }

  void end() override {}

 private:
  // After each frame, so that ParaView opens a run that is still going.
  void write_lists() const {
    write_file(folder_ / (run_.name + ".pvd"),
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
               "  <Collection>\n" +
                   pvd_ + "  </Collection>\n</VTKFile>\n");
    write_file(folder_ / (run_.name + ".vtu.series"),
               "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [" + series_ + "\n  ]\n}\n");
  }

  std::filesystem::path folder_;
  RunInfo run_;
  std::string pvd_, series_;  // the lists' lines so far
};

}  // namespace

std::unique_ptr<Sink> vtu_series(const std::filesystem::path& folder) { return std::make_unique<VtuSeries>(folder); }

}  // namespace seiche::render
