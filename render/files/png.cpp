#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <memory>

#include "render/files/file.hpp"
#include "render/files/provenance.hpp"
#include "render/outputs.hpp"

namespace seiche::render {
namespace {

// libpng reports errors by a function that must not return.
[[noreturn]] void fail(png_structp, png_const_charp what) {
  throw std::runtime_error(fmt::format("can't encode a PNG: {}", what));
}
void ignore(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png_create_info_struct(png);
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

std::string encode(const Image& image, const std::vector<std::pair<std::string, std::string>>& text) {
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size() && opaque; i += 4) opaque = image.rgba[i] == 255;

  Writer writer;
  std::string bytes;
  png_set_write_fn(writer.png, &bytes, append, nullptr);
  // Large flat areas: one simple filter and the least effort make files nearly as small, several times sooner.
  png_set_filter(writer.png, 0, PNG_FILTER_UP);
  png_set_compression_level(writer.png, 1);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
               8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_text> chunks;
  for (const auto& [keyword, value] : text) {
    png_text chunk{};
    const bool ascii = std::all_of(value.begin(), value.end(), [](char c) { return (c & 0x80) == 0; });
    chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(keyword.c_str());
    chunk.text = const_cast<char*>(value.c_str());
    chunks.push_back(chunk);
  }
  png_set_text(writer.png, writer.info, chunks.data(), static_cast<int>(chunks.size()));
  png_write_info(writer.png, writer.info);
  if (opaque) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);
  for (int y = 0; y < image.height; ++y) png_write_row(writer.png, image.rgba.data() + 4L * image.width * y);
  png_write_end(writer.png, writer.info);
  return bytes;
}

class PngSeries : public ImageSink {
 public:
  explicit PngSeries(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void begin(const RunInfo& run, int, int) override { run_ = run; }
  void image(const Image& image, const Frame& frame) override {
    write_png(folder_ / fmt::format("{:06}.png", frame.index), image, provenance(run_, frame));
  }
  void end() override {}

 private:
  std::filesystem::path folder_;
  RunInfo run_;
};

}  // namespace

void write_png(const std::filesystem::path& file, const Image& image,
               const std::vector<std::pair<std::string, std::string>>& text) {
  write_file(file, encode(image, text));
}

std::unique_ptr<ImageSink> png_series(const std::filesystem::path& folder) {
  return std::make_unique<PngSeries>(folder);
}

}  // namespace seiche::render
