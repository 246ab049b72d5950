#include "render/files/frame_spool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace seiche::render {
namespace {

std::runtime_error failed(const char* what, const std::filesystem::path& folder, int error) {
  return std::runtime_error(
      fmt::format("look.range = 'run' keeps frames in {} until the run ends, and they can't be {}: {}", folder.string(),
                  what, error == 0 ? "the file is cut short" : std::strerror(error)));
}

// One value or array after the other. Does not compile when Frame has more or fewer members.
template <class AnyFrame, class Act>
void each_field(AnyFrame& frame, Act act) {
  auto& [index, step, time, pose, position, velocity, pressure, number_density, kind, free_surface, id, derived,
         readings] = frame;
  act(index), act(step), act(time), act(pose);
  act(position), act(velocity), act(pressure), act(number_density), act(kind), act(free_surface), act(id);
  std::size_t count = derived.size();
  act(count);
  if constexpr (!std::is_const_v<AnyFrame>) derived.resize(count);
  for (auto& field : derived) act(field.quantity), act(field.values);
  act(readings.time), act(readings.values);
}

// Eigen's vectors of fixed size are their numbers and nothing else, though not to the compiler.
template <class Field>
constexpr bool is_plain = std::is_trivially_copyable_v<Field> || std::is_same_v<Field, RigidState>;

}  // namespace

FrameSpool::FrameSpool(const std::filesystem::path& folder) : folder_(folder) {
  std::error_code ignored;  // what can't be made can't be opened either
  std::filesystem::create_directories(folder, ignored);
  std::string name = (folder / ".frames-XXXXXX").string();  // mkostemp() replaces the six X
  file_ = Descriptor(mkostemp(name.data(), O_CLOEXEC));
  if (file_.number() < 0) throw failed("written", folder_, errno);
  unlink(name.c_str());
}

void FrameSpool::put(const void* bytes, std::size_t size, long& place) const {
  for (const char* rest = static_cast<const char*>(bytes); size > 0;) {
    const ssize_t count = pwrite(file_.number(), rest, size, place);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw failed("written", folder_, errno);
    rest += count;
    place += count;
    size -= static_cast<std::size_t>(count);
  }
}

void FrameSpool::get(void* bytes, std::size_t size) {
  for (char* rest = static_cast<char*>(bytes); size > 0;) {
    const ssize_t count = pread(file_.number(), rest, size, place_);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw failed("read back", folder_, count < 0 ? errno : 0);
    rest += count;
    place_ += count;
    size -= static_cast<std::size_t>(count);
  }
}

void FrameSpool::write(const Frame& frame) {
  long place = end_;
  each_field(frame, [&]<class Field>(const Field& field) {
    if constexpr (is_plain<Field>) {
      put(&field, sizeof field, place);
    } else {
      const std::size_t count = field.size();
      put(&count, sizeof count, place);
      put(field.data(), count * sizeof field[0], place);
    }
  });
  end_ = place;
}

std::optional<Frame> FrameSpool::read() {
  if (place_ == end_) return std::nullopt;
  Frame frame;
  each_field(frame, [&]<class Field>(Field& field) {
    if constexpr (is_plain<Field>) {
      get(&field, sizeof field);
    } else {
      std::size_t count = 0;
      get(&count, sizeof count);
      field.resize(count);
      get(field.data(), count * sizeof field[0]);
    }
  });
  return frame;
}

}  // namespace seiche::render
