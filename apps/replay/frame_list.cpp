#include "apps/replay/frame_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace seiche::apps {
namespace {

constexpr double slack = 1e-6;  // [s]: frames fall on times that few digits don't hold

// A whole number that `text` is all of; nothing else.
std::optional<long> whole(std::string_view text) {
  long value = 0;
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || last != end || value < 0) return {};
  return value;
}

}  // namespace

bool Selection::holds(const StoredFrame& frame) const {
  return frame.time >= from - slack && frame.time <= to + slack && frame.index >= first && frame.index <= last;
}

void select_frames(const std::string& text, Selection& selection) {
  const auto colon = text.find(':');
  const std::string low = text.substr(0, colon), high = colon == std::string::npos ? low : text.substr(colon + 1);
  const auto first = low.empty() ? selection.first : whole(low), last = high.empty() ? selection.last : whole(high);
  if (text.empty() || text == ":" || !first || !last || *first > *last)
    throw std::invalid_argument(fmt::format(
        "'{}' is not a range of frames; give the first and the last one, as in 100:200, 100: or :200", text));
  std::tie(selection.first, selection.last) = std::tie(*first, *last);
}

FrameList::FrameList(const StoredRun& run, Scan scan, Selection selection, Wait wait)
    : run_(run), scan_(scan), selection_(selection), wait_(std::move(wait)) {
  rescan();
}

void FrameList::rescan() {
  // Asked first: all frames of a run that has ended are there.
  if (scans_ > 0) ended_ = read_run(run_.folder).record.ending.has_value();
  const long newest = found_.empty() ? -1 : found_.back().index;
  for (StoredFrame& frame : scan_(run_))
    if (frame.index > newest && selection_.holds(frame)) found_.push_back(std::move(frame));
  ++scans_;
}

std::optional<StoredFrame> FrameList::next(const std::stop_token& stop) {
  while (handed_ == found_.size()) {
    if (!wait_ || ended_) return {};
    rescan();
    if (handed_ == found_.size() && !ended_ && !wait_(stop)) return {};
  }
  return found_[handed_++];
}

std::vector<StoredFrame> listed_pictures(const StoredRun& run) {
  const double end = run.record.ending ? run.record.ending->time : run.info.end;
  std::vector<StoredFrame> list;
  for (const auto& file : stored_pictures(run)) {
    const long index = whole(file.stem().string()).value_or(0);
    list.push_back({index, std::min(static_cast<double>(index) * run.info.frame_interval, end), file});
  }
  return list;
}

}  // namespace seiche::apps
