#include <algorithm>
#include <exception>
#include <optional>

#include "render/check_look.hpp"
#include "render/outputs.hpp"
#include "render/picture/range.hpp"
#include "render/picture/ticks.hpp"
#include "render/view/painter.hpp"

namespace seiche::render {
namespace {

class Pictures : public Sink {
 public:
  Pictures(const Look& look, std::vector<std::unique_ptr<ImageSink>> takers) : look_(look), takers_(std::move(takers)) {
    check_look(look_);
    quantity_ = quantity_of(look_.quantity);
  }

  void begin(const RunInfo& run) override {
    painter_.emplace(run, look_);
    fixed_ = fixed_range(run, look_);
    for (const auto& taker : takers_) taker->begin(run, look_.width, look_.height);
  }

  void frame(const FramePtr& frame) override {
    painter_->record(frame->readings);
    if (look_.range == "run" && !fixed_)
      kept_.push_back(frame);
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
    for (const auto& taker : takers_) attempt([&] { taker->end(); });  // whatever befell the others
    if (error) std::rethrow_exception(error);
  }

 private:
  void draw(const Frame& frame, Range range) {
    const Image image = painter_->draw(frame, range);
    for (const auto& taker : takers_) taker->image(image, frame);
  }

  void draw_kept() {
    if (kept_.empty()) return;
    Range whole = fluid_range(*kept_.front(), quantity_);
    for (const auto& frame : kept_) {
      const Range range = fluid_range(*frame, quantity_);
      whole = {std::min(whole.low, range.low), std::max(whole.high, range.high)};
    }
    whole = rounded(whole);
    for (auto& frame : kept_) {
      draw(*frame, whole);
      frame.reset();
    }
    kept_.clear();
  }

  Look look_;
  Quantity quantity_ = Quantity::pressure;
  std::vector<std::unique_ptr<ImageSink>> takers_;
  std::optional<Painter> painter_;
  std::optional<Range> fixed_;
  std::vector<FramePtr> kept_;
};

}  // namespace

std::unique_ptr<Sink> pictures(const Look& look, std::vector<std::unique_ptr<ImageSink>> takers) {
  return std::make_unique<Pictures>(look, std::move(takers));
}

}  // namespace seiche::render
