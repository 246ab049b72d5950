#include "tests/report/browser.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <stdexcept>

namespace seiche::test {
namespace {

using nlohmann::json;

std::string decoded(const std::string& base64) {
  std::string bytes;
  unsigned group = 0, bits = 0;
  for (const char c : base64) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto digit = digits.find(c);
    if (digit == std::string::npos) break;
    group = group << 6 | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255);
  }
  return bytes;
}

void save(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

// The program reads commands from 3 and writes answers to 4.
render::Process Browser::start(const std::filesystem::path& profile) {
  std::signal(SIGPIPE, SIG_IGN);
  render::Pipe commands = render::make_pipe(), answers = render::make_pipe();
  const render::Descriptor quiet = render::null_device();
  to_ = std::move(commands.write);
  from_ = std::move(answers.read);
  return render::Process(
      {.words = {"chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                 "--no-first-run", "--disable-background-networking", "--remote-debugging-pipe",
                 "--user-data-dir=" + profile.string()},
       .files = {{1, quiet.number()}, {2, quiet.number()}, {3, commands.read.number()}, {4, answers.write.number()}}});
}

Browser::Browser(const std::filesystem::path& folder) : process_(start(folder)) {
  const json target = call("Target.createTarget", {{"url", "about:blank"}});
  session_ = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}})["sessionId"];
  for (const char* domain : {"Page", "Runtime", "Log", "Network"}) call(std::string(domain) + ".enable");
}

Browser::~Browser() {
  try {
    session_.clear();
    call("Browser.close");
  } catch (const std::exception&) {
    process_.signal(SIGKILL);
  }
  process_.wait();
}

json Browser::receive() {
  std::size_t end;
  while ((end = read_.find('\0')) == std::string::npos) {
    std::array<char, 65536> part;
    const ssize_t count = read(from_.number(), part.data(), part.size());
    if (count <= 0) throw std::runtime_error("chromium is gone; is Debian's package chromium installed?");
    read_.append(part.data(), static_cast<std::size_t>(count));
  }
  json message = json::parse(read_.substr(0, end));
  read_.erase(0, end + 1);
  return message;
}

void Browser::note(const json& event) {
  const std::string method = event.value("method", "");
  const json& what = event["params"];
  if (method == "Page.loadEventFired") loaded_ = true;
  if (method == "Runtime.exceptionThrown") complaints_.push_back(what.dump());
  if (method == "Log.entryAdded" && what["entry"]["level"] != "info" && what["entry"]["level"] != "verbose")
    complaints_.push_back(what.dump());
  if (method == "Runtime.consoleAPICalled") complaints_.push_back(what.dump());
  if (method != "Network.requestWillBeSent") return;
  const std::string url = what["request"]["url"];
  if (url != page_ && !url.starts_with("data:")) requests_.push_back(url);
}

json Browser::call(const std::string& method, json parameters) {
  json command{{"id", ++last_}, {"method", method}, {"params", std::move(parameters)}};
  if (!session_.empty()) command["sessionId"] = session_;
  const std::string text = command.dump() + '\0';
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(to_.number(), text.data() + done, text.size() - done);
    if (count < 0) throw std::runtime_error("chromium is gone; is Debian's package chromium installed?");
    done += static_cast<std::size_t>(count);
  }
  while (true) {
    json message = receive();
    if (message.value("id", 0L) != last_) {
      note(message);
      continue;
    }
    if (message.contains("error")) throw std::runtime_error(method + ": " + message["error"].dump());
    return message["result"];
  }
}

void Browser::open(const std::filesystem::path& file) {
  page_ = "file://" + file.string();
  complaints_.clear();
  requests_.clear();
  loaded_ = false;
  call("Page.navigate", {{"url", page_}});
  while (!loaded_) note(receive());
}

void Browser::resize(int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", width < 600}});
}

void Browser::show_as(const std::string& media, const std::string& scheme) {
  call("Emulation.setEmulatedMedia",
       {{"media", media}, {"features", {{{"name", "prefers-color-scheme"}, {"value", scheme}}}}});
}

json Browser::ask(const std::string& expression) {
  const json answer =
      call("Runtime.evaluate",
           {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}, {"userGesture", true}});
  if (answer.contains("exceptionDetails")) throw std::runtime_error(answer["exceptionDetails"].dump());
  return answer["result"].value("value", json());
}

void Browser::click(double x, double y) {
  for (const char* type : {"mousePressed", "mouseReleased"})
    call("Input.dispatchMouseEvent",
         {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"buttons", 1}, {"clickCount", 1}});
}

void Browser::press(const std::string& key, int code) {
  for (const char* type : {"keyDown", "keyUp"})
    call(
        "Input.dispatchKeyEvent",
        {{"type", type}, {"key", key}, {"code", key}, {"windowsVirtualKeyCode", code}, {"nativeVirtualKeyCode", code}});
}

void Browser::shoot(const std::filesystem::path& file) {
  save(file, decoded(call("Page.captureScreenshot", {{"captureBeyondViewport", true}})["data"]));
}

void Browser::print(const std::filesystem::path& file) {
  save(file, decoded(call("Page.printToPDF", {{"preferCSSPageSize", true}, {"printBackground", false}})["data"]));
}

}  // namespace seiche::test
