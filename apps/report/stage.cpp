#include "apps/report/stage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <vector>

#include "apps/report/curves.hpp"
#include "apps/report/html.hpp"
#include "render/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps::report {
namespace {

constexpr std::uintmax_t largest_movie = 40'000'000;  // that is embedded [bytes]
constexpr std::size_t room_for_stills = 3'600'000;    // of all of them; base64 makes a third more [bytes]

struct Size {
  int width, height;
};

// Of pictures and movie, by the first picture, else by the scene.
Size size_of(const Report& report) {
  const render::Look& look = report.runs.front().run.scene.look;
  if (report.stills.empty()) return {look.width, look.height};
  const render::Image first = render::read_png(report.stills.front().file);
  return {first.width, first.height};
}

// Its own controls are for a page without scripts: they would darken the curves at its foot.
std::string movie_html(const fs::path& movie, const fs::path& folder) {
  const render::MovieRow& format = render::format_of(movie);
  const bool embedded = fs::file_size(movie) <= largest_movie;
  const std::string source = embedded ? data_url(std::string(format.media_type), render::read_file(movie))
                                      : url_of(fs::proximate(movie, folder));
  if (!format.video) return fmt::format("<img class=\"movie\" alt=\"The movie of the run\" src=\"{}\">\n", source);
  return fmt::format(
      "<video class=\"movie\" controls loop muted playsinline preload=\"auto\" aria-label=\"The movie of the run\" "
      "src=\"{}\"></video>\n",
      source);
}

std::string link_note(const fs::path& movie, const fs::path& folder) {
  const auto size = fs::file_size(movie);
  if (size <= largest_movie) return "";
  const fs::path path = fs::proximate(movie, folder);
  return fmt::format(" The movie, {:.0f} MB, isn’t in this page: keep <a href=\"{}\">{}</a> where it is beside it.",
                     static_cast<double>(size) / 1e6, url_of(path), escaped(path.generic_string()));
}

std::string strip_html(const std::vector<Still>& stills) {
  std::string html = "<ol class=\"strip\">\n";
  for (std::size_t i = 0; i < stills.size(); ++i)
    html += fmt::format(
        "<li><button type=\"button\" data-time=\"{0:.6g}\" aria-label=\"Show t = {1:.2f} s\">"
        "<img alt=\"The tank at t = {1:.2f} s\" src=\"{2}\"></button><span>{1:.2f} s</span></li>\n",
        stills[i].time, stills[i].time,
        data_url("image/png", render::small_png(stills[i].file, room_for_stills / stills.size())));
  return html + "</ol>\n";
}

std::string bar_html(std::size_t stills, bool movie) {
  std::string html = "<div class=\"bar\">\n";
  if (movie) html += "<button type=\"button\" id=\"play\">Play</button>\n";
  if (stills > 1)
    html += fmt::format(
        "<input type=\"range\" id=\"slider\" min=\"0\" max=\"{}\" step=\"1\" value=\"0\" aria-label=\"Still\">\n",
        stills - 1);
  html += "<output id=\"clock\" for=\"slider\">t = 0.00 s</output>\n";
  return html +
         "<button type=\"button\" id=\"full\" aria-label=\"Full screen\" title=\"Full screen\" hidden><svg viewBox=\"0 "
         "0 16 16\" "
         "aria-hidden=\"true\"><path d=\"M1 5V1h4M11 1h4v4M15 11v4h-4M5 15H1v-4\"/></svg></button>\n</div>\n";
}

// What can be done with it.
std::string hint(const render::MovieRow* movie, bool stills) {
  std::vector<std::string> ways;
  if (movie && movie->video) ways.emplace_back("play it");
  if (stills) ways.emplace_back("slide through the stills");
  ways.emplace_back("point at a time in the curves");
  std::string sentence = fmt::format("{}: all keep one clock.", fmt::join(ways, " or "));
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence + (movie && !movie->video ? " The movie, a GIF, goes on by itself." : "");
}

}  // namespace

std::string stage_html(const Report& report, const fs::path& folder) {
  const bool movie = fs::is_regular_file(report.movie);
  if (!movie && report.stills.empty()) return "";
  const bool dark = report.runs.front().run.scene.look.background == render::Background::black;
  const Size size = size_of(report);
  std::string html = fmt::format("<figure class=\"stage{}\" style=\"--wide:{};--high:{}\">\n<div class=\"screen\">\n",
                                 dark ? " black" : "", size.width, size.height);
  if (movie) html += movie_html(report.movie, folder);
  if (!report.stills.empty()) html += "<img id=\"still\" alt=\"\" hidden>\n";
  html += "</div>\n" + bar_html(report.stills.size(), movie) + strip_html(report.stills);
  html +=
      fmt::format("<figcaption>{}", hint(movie ? &render::format_of(report.movie) : nullptr, report.stills.size() > 1));
  return html + (movie ? link_note(report.movie, folder) : "") + "</figcaption>\n</figure>\n";
}

}  // namespace seiche::apps::report
