#include "apps/run/probes_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace seiche::apps {
namespace {

class ProbesCsv : public Sink {
 public:
  explicit ProbesCsv(std::filesystem::path file) : file_(std::move(file)) {}

  void begin(const RunInfo& run) override {
    columns_ = run.sensors.size();
    out_.open(file_);
    std::string titles = "t [s]";
    for (const Column& column : run.sensors) titles.append(",").append(header(column));
    write(titles + '\n');
  }

  void frame(const FramePtr& frame) override {
    std::string rows;
    auto value = frame->readings.values.begin();
    for (const double time : frame->readings.time) {
      fmt::format_to(std::back_inserter(rows), "{:.6f}", time);
      for (std::size_t i = 0; i < columns_; ++i, ++value) {
        rows += ',';
        if (!std::isnan(*value)) fmt::format_to(std::back_inserter(rows), "{:.7g}", *value);  // a gap is empty
      }
      rows += '\n';
    }
    write(rows);
  }

  void end() override { out_.close(); }

 private:
  void write(const std::string& text) {
    out_ << text << std::flush;
    if (!out_) throw std::runtime_error(fmt::format("can't write {}: is the disk full?", file_.string()));
  }

  std::filesystem::path file_;
  std::ofstream out_;
  std::size_t columns_ = 0;
};

}  // namespace

std::unique_ptr<Sink> probes_csv(const std::filesystem::path& file) { return std::make_unique<ProbesCsv>(file); }

}  // namespace seiche::apps
