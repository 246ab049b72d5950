#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/system/process.hpp"

namespace seiche::test {

/// Headless Chromium with one page, told what to do in its DevTools protocol through a pair of pipes. Throws
/// std::runtime_error where it can't be started, or refuses a command.
class Browser {
 public:
  /// @param folder for its profile
  explicit Browser(const std::filesystem::path& folder);
  ~Browser();
  Browser(const Browser&) = delete;

  /// Opens a file and waits until it is loaded. What the page complained of before is forgotten.
  void open(const std::filesystem::path& file);

  /// A window of that many pixels.
  void resize(int width, int height);

  /// As in {"prefers-color-scheme", "dark"}; `media` is "screen" or "print".
  void show_as(const std::string& media, const std::string& scheme);

  /// What an expression gives, after it was awaited if it is a promise. A user's gesture, so that movies may play.
  nlohmann::json ask(const std::string& expression);

  /// A click of the mouse there, in the window's pixels.
  void click(double x, double y);

  /// A key that is pressed and let go, as in "ArrowRight".
  void press(const std::string& key, int code);

  /// The whole page as a PNG, or printed as a PDF.
  void shoot(const std::filesystem::path& file);
  void print(const std::filesystem::path& file);

  /// Errors and warnings that the page has caused since it was opened, in its console or its log.
  const std::vector<std::string>& complaints() const { return complaints_; }

  /// Addresses that the page has asked for, but for data and itself.
  const std::vector<std::string>& requests() const { return requests_; }

 private:
  nlohmann::json call(const std::string& method, nlohmann::json parameters = nlohmann::json::object());
  nlohmann::json receive();
  void note(const nlohmann::json& event);

  render::Process start(const std::filesystem::path& profile);

  render::Descriptor to_, from_;
  render::Process process_;
  long last_ = 0;
  bool loaded_ = false;
  std::string session_, read_, page_;
  std::vector<std::string> complaints_, requests_;
};

}  // namespace seiche::test
