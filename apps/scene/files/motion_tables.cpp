#include "apps/scene/files/motion_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "apps/common/errors.hpp"
#include "solver/motion/motion_axes.hpp"

namespace seiche::apps {
namespace {

/// A number, or a bracket.
struct Token {
  std::size_t line;
  std::string_view text;
};

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& what) {
  throw BadScene(fmt::format("{}:{}: {}", file, line, what));
}

/// The text in words, brackets apart, without comments.
std::vector<Token> openfoam_tokens(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t line = 1;
  for (std::size_t k = 0; k < text.size();) {
    if (text[k] == '\n') ++line;
    if (text.substr(k, 2) == "//") {
      k = std::min(text.find('\n', k), text.size());
    } else if (text.substr(k, 2) == "/*") {
      const std::size_t end = std::min(text.find("*/", k), text.size() - 2) + 2;
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(k),
                                                  text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      k = end;
    } else if (std::isspace(static_cast<unsigned char>(text[k])) != 0) {
      ++k;
    } else {
      const bool bracket = text[k] == '(' || text[k] == ')';
      const std::size_t end = bracket ? k + 1 : std::min(text.find_first_of("() \t\r\n", k), text.size());
      tokens.push_back({line, text.substr(k, end - k)});
      k = end;
    }
  }
  return tokens;
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

/// Adds samples of places along the axes of the motion's frame and of angles about them to a series.
class Placed {
 public:
  Placed(const Parameters::Motion& motion, std::string file) : file_(std::move(file)) {
    for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
      const auto axis = static_cast<std::size_t>(frame_axis(row, motion));
      all_[axis + (row.rotation ? 3 : 0)] = row.value;
    }
  }

  /// What stands at a place among x, y, z and the angles about them.
  DegreeOfFreedom at(std::size_t place) const { return all_[place]; }

  void add_time(std::size_t line, double time) {
    auto& t = series.time;
    if (!t.empty() && !(time > t.back()))
      refuse(file_, line, fmt::format("t = {:g} s; expected a time after the {:g} s before", time, t.back()));
    t.push_back(time);
  }

  void check_size(std::size_t line) const {
    if (series.time.size() < 4)
      refuse(file_, line, fmt::format("the file ends after {} samples; expected 4 at least", series.time.size()));
  }

  Parameters::TimeSeries series;

 private:
  std::string file_;
  std::array<DegreeOfFreedom, 6> all_{};
};

std::string_view line_of(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return line;
}

/// The words of a line before a `#`.
std::vector<std::string_view> cells_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> cells;
  constexpr std::string_view between = ",; \t\r";
  for (std::size_t from = line.find_first_not_of(between); from != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(between, from), line.size());
    cells.push_back(line.substr(from, end - from));
    from = line.find_first_not_of(between, end);
  }
  return cells;
}

/// What the columns of an untitled file are; none: the time.
std::vector<std::optional<DegreeOfFreedom>> meanings(const std::vector<std::string>& columns, std::size_t count,
                                                     const Placed& placed, const std::string& file, std::size_t line) {
  std::vector<std::optional<DegreeOfFreedom>> all;
  if (columns.empty() && (count == 4 || count == 7)) {
    all.emplace_back();
    for (std::size_t k = 0; k + 1 < count; ++k) all.emplace_back(placed.at(k));
    return all;
  }
  for (const std::string& name : columns) {
    const auto row = std::ranges::find(degrees_of_freedom, name, &DegreeOfFreedomRow::name);
    if (row == degrees_of_freedom.end() && name != "t")
      refuse(file, line,
             fmt::format("motion.columns has '{}'; expected t, surge, heave, sway, roll, pitch or yaw", name));
    all.push_back(name == "t" ? std::nullopt : std::optional(row->value));
  }
  if (all.size() != count)
    refuse(file, line,
           fmt::format("{} numbers without titles; motion.columns must say what they are, as in \"t, roll\", or a line "
                       "of titles above, as in t [s],roll [deg]; seven are time, x, y, z and three angles",
                       count));
  for (auto each = all.begin(); each != all.end(); ++each)
    if (std::find(all.begin(), each, *each) != each)
      refuse(file, line, fmt::format("motion.columns has '{}' a second time", *each ? name(**each) : "t"));
  if (std::find(all.begin(), all.end(), std::nullopt) == all.end())
    refuse(file, line, "motion.columns doesn't say which of the columns is the time; call it t");
  return all;
}

}  // namespace

bool is_openfoam_table(const std::string& text) {
  const std::vector<Token> tokens = openfoam_tokens(text);
  const auto begins = [&](std::size_t k) { return k < tokens.size() && tokens[k].text == "("; };
  return begins(0) || (begins(1) && number_in(tokens[0].text));
}

Parameters::TimeSeries openfoam_motion(const std::string& text, const std::string& file,
                                       const Parameters::Motion& motion) {
  const std::vector<Token> tokens = openfoam_tokens(text);
  std::size_t next = tokens[0].text == "(" ? 0 : 1;
  const auto last_line = tokens.back().line;
  const auto is = [&](std::string_view what) { return next < tokens.size() && tokens[next].text == what; };
  constexpr const char* form = "(time ((x y z) (angles about x y z)))";
  const auto expect = [&](std::string_view bracket) {
    if (!is(bracket))
      refuse(
          file, next < tokens.size() ? tokens[next].line : last_line,
          fmt::format("{}; expected '{}' of {}",
                      next < tokens.size() ? fmt::format("'{}'", tokens[next].text) : "the file ends", bracket, form));
    ++next;
  };
  const auto number = [&] {
    const auto value = next < tokens.size() ? number_in(tokens[next].text) : std::nullopt;
    if (!value)
      refuse(file, next < tokens.size() ? tokens[next].line : last_line,
             fmt::format("{}; expected a number of {}",
                         next < tokens.size() ? fmt::format("'{}'", tokens[next].text) : "the file ends", form));
    ++next;
    return *value;
  };
  Placed placed(motion, file);
  expect("(");
  while (!is(")")) {
    expect("(");
    placed.add_time(next < tokens.size() ? tokens[next].line : last_line, number());
    expect("(");
    for (std::size_t part = 0; part < 2; ++part) {
      expect("(");
      for (std::size_t axis = 0; axis < 3; ++axis) placed.series[placed.at(3 * part + axis)].push_back(number());
      expect(")");
    }
    expect(")");
    expect(")");
  }
  placed.check_size(last_line);
  return placed.series;
}

bool has_no_titles(const std::string& text) {
  for (std::string_view rest = text; !rest.empty();) {
    const auto cells = cells_of(line_of(rest));
    if (cells.empty()) continue;
    return std::ranges::all_of(cells, [](std::string_view cell) { return number_in(cell).has_value(); });
  }
  return false;
}

Parameters::TimeSeries untitled_motion(const std::string& text, const std::string& file,
                                       const Parameters::Motion& motion, const std::vector<std::string>& columns) {
  Placed placed(motion, file);
  std::vector<std::optional<DegreeOfFreedom>> meaning;
  std::size_t line = 0;
  for (std::string_view rest = text; !rest.empty();) {
    ++line;
    const auto cells = cells_of(line_of(rest));
    if (cells.empty()) continue;
    if (meaning.empty()) meaning = meanings(columns, cells.size(), placed, file, line);
    if (cells.size() != meaning.size())
      refuse(file, line, fmt::format("{} cells; expected {}, as in the first row", cells.size(), meaning.size()));
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto value = number_in(cells[k]);
      if (!value) refuse(file, line, fmt::format("'{}'; expected a number, as in -1.5e-3", cells[k]));
      if (meaning[k])
        placed.series[*meaning[k]].push_back(*value);
      else
        placed.add_time(line, *value);
    }
  }
  placed.check_size(line);
  // A path tells where the tank is, a motion how far it went.
  if (columns.empty())
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<double>& values = placed.series[placed.at(axis)];
      const double first = values.front();
      for (double& value : values) value -= first;
    }
  return placed.series;
}

}  // namespace seiche::apps
