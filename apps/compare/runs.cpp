#include "apps/compare/runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <optional>

#include "apps/common/exit_codes.hpp"
#include "apps/common/stopwatch.hpp"
#include "apps/run/stored_run.hpp"
#include "render/files.hpp"
#include "render/system.hpp"

namespace seiche::apps::compare {
namespace {

constexpr int poll_interval = 250;  // at how far the runs have come [ms]

// What it may not overwrite has been refused by check_kept.
std::vector<std::string> command(const PlannedRun& run, int threads) {
  std::vector<std::string> words{"seiche", "run", run.scene.file};
  for (const Override& each : run.settings) words.insert(words.end(), {"--set", each.key + "=" + each.value});
  words.insert(words.end(),
               {"--threads", fmt::format("{}", threads), "-o", run.folder.string(), "--quiet", "--overwrite"});
  return words;
}

// How far a run has come by its list of frames; as it was where that can't be read.
double reached(const PlannedRun& run, double before) {
  try {
    const auto frames = stored_frames({run.folder, run.scene, {}, {}});
    return frames.empty() ? before : frames.back().time;
  } catch (const BadFolder&) {
    return before;
  }
}

// What its report says; nothing where it didn't come to one.
std::optional<Ending> ending_of(const PlannedRun& run, int code = done) {
  if (code != done && code != failed && code != interrupted) return {};
  try {
    return read_run(run.folder).record.ending;
  } catch (const BadFolder&) {
    return {};
  }
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// A run at work. Where this program is killed, it ends with its current frame.
struct Worker {
  explicit Worker(const std::vector<std::string>& words)
      : process({.words = words,
                 .program = "/proc/self/exe",
                 .files = {{0, nothing.number()}, {1, nothing.number()}, {2, fileno(errors.get())}},
                 .own_session = true,
                 .ends_with_us = true}) {}

  render::File errors = render::temporary_file();
  render::Descriptor nothing = render::null_device();
  render::Process process;
};

// The runs at work, each with its row on the table.
class Workers {
 public:
  Workers(const std::vector<PlannedRun>& runs, bool again) : runs_(runs), workers_(runs.size()) {
    for (const PlannedRun& run : runs) {
      rows_.push_back({.label = run.label, .end = run.scene.parameters.time.end, .ending = {}});
      if (again || !is_done(run)) continue;
      rows_.back().state = ProgressRow::State::over;
      rows_.back().ending = fmt::format("{}; done before", fmt::join(ending_lines(*ending_of(run)), ": "));
    }
  }

  const std::vector<ProgressRow>& rows() const { return rows_; }

  std::size_t waiting() const { return count(ProgressRow::State::waiting); }
  std::size_t running() const { return count(ProgressRow::State::running); }

  // Of the largest run that waits [bytes].
  double memory() const {
    double largest = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i)
      if (rows_[i].state == ProgressRow::State::waiting) largest = std::max(largest, memory_of(runs_[i].scene));
    return largest;
  }

  void start_next(int threads) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (rows_[i].state != ProgressRow::State::waiting) continue;
      workers_[i] = std::make_unique<Worker>(command(runs_[i], threads));
      rows_[i].state = ProgressRow::State::running;
      return;
    }
  }

  void update(Outcome& outcome) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      ProgressRow& row = rows_[i];
      if (row.state != ProgressRow::State::running) continue;
      const std::optional<int> code = workers_[i]->process.exit_code();
      if (!code) {
        row.time = reached(runs_[i], row.time);
        continue;
      }
      row.state = ProgressRow::State::over;
      if (const auto ending = ending_of(runs_[i], *code)) {
        row.ending = fmt::format("{}", fmt::join(ending_lines(*ending), ": "));
      } else {
        const std::string why = first_line(render::contents(workers_[i]->errors.get()));
        row.ending = fmt::format("could not be run: {}", why.empty() ? fmt::format("it ended with {}", *code) : why);
        outcome.errors.push_back(fmt::format("{} {}", row.label, row.ending));
      }
      workers_[i].reset();
    }
  }

  // Until one ends, a signal comes, or it is time to show how far they have come.
  void wait() const {
    std::vector<pollfd> ends;
    for (const auto& worker : workers_)
      if (worker) ends.push_back({worker->process.descriptor(), POLLIN, 0});
    poll(ends.data(), ends.size(), poll_interval);
  }

  void end_all() {
    for (const auto& worker : workers_)
      if (worker) worker->process.signal(SIGINT);
  }

 private:
  std::size_t count(ProgressRow::State state) const {
    return static_cast<std::size_t>(
        std::count_if(rows_.begin(), rows_.end(), [&](const ProgressRow& row) { return row.state == state; }));
  }

  const std::vector<PlannedRun>& runs_;
  std::vector<ProgressRow> rows_;
  std::vector<std::unique_ptr<Worker>> workers_;  // of those at work
};

}  // namespace

std::vector<std::string> ending_lines(const Ending& ending) {
  switch (ending.status) {
    case Ending::Status::finished:
      return {fmt::format("finished at {:.4g} s", ending.time)};
    case Ending::Status::interrupted:
      return {fmt::format("interrupted at {:.3f} s", ending.time)};
    case Ending::Status::failed:
      break;
  }
  return {fmt::format("stopped at {:.3f} s", ending.time), ending.failure ? ending.failure->cause : ending.error};
}

Outcome run_all(const std::vector<PlannedRun>& runs, int threads, bool again, ProgressTable& table,
                const std::function<bool()>& stop) {
  const Stopwatch watch;
  Outcome outcome;
  Workers workers(runs, again);
  const int most = runs_at_a_time(workers.waiting(), threads, workers.memory(), free_memory());
  while (true) {
    if (stop() && !outcome.interrupted) {
      outcome.interrupted = true;
      workers.end_all();
      table.say("Ending all runs with their current frames (Ctrl-C: at once)");
    }
    while (!outcome.interrupted && workers.running() < static_cast<std::size_t>(most) && workers.waiting() > 0)
      workers.start_next(threads / most);
    workers.update(outcome);
    table.show(workers.rows(), watch.seconds());
    if (workers.running() == 0 && (outcome.interrupted || workers.waiting() == 0)) return outcome;
    workers.wait();
  }
}

}  // namespace seiche::apps::compare
