#include <algorithm>
#include <exception>
#include <optional>

#include "render/check_look.hpp"
#include "render/files/frame_spool.hpp"
#include "render/outputs.hpp"
#include "render/picture/range.hpp"
#include "render/picture/ticks.hpp"
#include "render/view/painter.hpp"

namespace seiche::render {
namespace {

class Pictures : public Sink {
 public:
  Pictures(const Look& look, std::vector<std::unique_ptr<ImageSink>> image_sinks, std::filesystem::path folder)
      : look_(look), quantity_(look.quantity), image_sinks_(std::move(image_sinks)), folder_(std::move(folder)) {
    check_look(look_);
  }

  void begin(const RunInfo& run) override {
    painter_.emplace(run, look_);
    fixed_ = fixed_range(run, look_);
    if (look_.range.source == RangeSource::run && !fixed_) spool_.emplace(folder_);
    for (const auto& image_sink : image_sinks_) image_sink->begin(run, look_.width, look_.height);
  }

  void frame(const FramePtr& frame) override {
    painter_->record(frame->readings);
    if (spool_)
      keep(*frame);
    else
      draw(*frame, fixed_ ? *fixed_ : rounded(fluid_range(*frame, quantity_)));
  }

  void end() override {
    std::exception_ptr error;
    const auto attempt = [&](const auto& what) {
      try {
        what();
      } catch (...) {
        if (!error) error = std::current_exception();
      }
    };
    attempt([&] { draw_kept(); });
    for (const auto& image_sink : image_sinks_) attempt([&] { image_sink->end(); });  // whatever happened to the others
    if (error) std::rethrow_exception(error);
  }

 private:
  void draw(const Frame& frame, Range range) {
    const Image image = painter_->draw(frame, range);
    for (const auto& image_sink : image_sinks_) image_sink->image(image, frame);
  }

  void keep(const Frame& frame) {
    const Range range = fluid_range(frame, quantity_);
    spool_->write(frame);
    whole_ = whole_ ? Range{std::min(whole_->low, range.low), std::max(whole_->high, range.high)} : range;
  }

  void draw_kept() {
    if (!whole_) return;
    const Range range = rounded(*whole_);
    while (const auto frame = spool_->read()) draw(*frame, range);
    spool_.reset();
  }

  Look look_;
  Quantity quantity_;
  std::vector<std::unique_ptr<ImageSink>> image_sinks_;
  std::optional<Painter> painter_;
  std::optional<Range> fixed_;
  std::filesystem::path folder_;
  std::optional<FrameSpool> spool_;  // where colours need the range of the whole run
  std::optional<Range> whole_;       // of the frames in it
};

}  // namespace

std::unique_ptr<Sink> pictures(const Look& look, std::vector<std::unique_ptr<ImageSink>> image_sinks,
                               const std::filesystem::path& folder) {
  return std::make_unique<Pictures>(look, std::move(image_sinks), folder);
}

Image draw_frame(const RunInfo& run, const Look& look, const Frame& frame, const MotionMarks& marks) {
  Painter painter(run, look);
  painter.mark(marks);
  return painter.draw(frame, fixed_range(run, look).value_or(rounded(fluid_range(frame, look.quantity))));
}

}  // namespace seiche::render
