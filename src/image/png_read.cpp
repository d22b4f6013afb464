#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <new>

#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "image/color.h"
#include "image/image_file.h"
#include "image/image_io.h"

namespace tetralux {
namespace {

// One PNG being read. libpng leaves a failed call by longjmp, which must not pass a C++ object with a destructor: every
// call that may fail is made in the functions with setjmp below, which have none; this object belongs to their caller.
struct PngReader {
  const std::byte* next = nullptr;
  size_t left = 0;
  std::array<char, 160> message{};
  png_structp png = nullptr;
  png_infop info = nullptr;

  explicit PngReader(const std::vector<std::byte>& bytes) : next(bytes.data()), left(bytes.size()) {}
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

extern "C" {

[[noreturn]] static void onPngError(png_structp png, png_const_charp text) {
  auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
  std::strncpy(reader->message.data(), text, reader->message.size() - 1);
  png_longjmp(png, 1);
}

// Warnings concern chunks that do not change the pixels read here.
static void onPngWarning(png_structp, png_const_charp) {}

static void onPngRead(png_structp png, png_bytep out, size_t count) {
  auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
  if (reader->left < count) png_error(png, "the file ends early");
  std::memcpy(out, reader->next, count);
  reader->next += count;
  reader->left -= count;
}

}  // extern "C"

bool readHeader(PngReader& reader) {
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, onPngError, onPngWarning);
  if (!reader.png) return false;
  if (setjmp(png_jmpbuf(reader.png))) return false;
  reader.info = png_create_info_struct(reader.png);
  if (!reader.info) png_error(reader.png, "out of memory");
  png_set_read_fn(reader.png, &reader, onPngRead);
  // The size is checked by the caller, whose message has the numbers.
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_read_info(reader.png, reader.info);
  return true;
}

// Four samples a pixel, 8 or 16 bits each, whatever the file holds.
bool setRgbaOutput(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_expand(reader.png);  // palette to RGB, 1 to 4 bits to 8, transparent colour to alpha
  png_set_gray_to_rgb(reader.png);
  png_set_add_alpha(reader.png, 0xffff, PNG_FILLER_AFTER);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

// The end is read, too: a file cut off behind its pixels is as damaged as any other.
bool readRows(PngReader& reader, png_bytep* rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

// Linear light of every sample value.
std::vector<double> decodingTable(const PngReader& reader, size_t levels) {
  // PNG specification (ISO/IEC 15948:2004) 11.3.3: sRGB and iCCP override gAMA. 1/2.2 is what writers of sRGB put into
  // gAMA for readers that know no sRGB chunk, and means the sRGB curve.
  constexpr png_fixed_point kSrgbGamma = 45455;
  png_fixed_point gamma = 0;
  const bool known = png_get_valid(reader.png, reader.info, PNG_INFO_sRGB | PNG_INFO_iCCP) != 0;
  const bool power = !known && png_get_gAMA_fixed(reader.png, reader.info, &gamma) != 0 && gamma > 0 &&
                     std::abs(gamma - kSrgbGamma) > 100;
  std::vector<double> table(levels);
  for (size_t i = 0; i < levels; i++) {
    const double sample = static_cast<double>(i) / static_cast<double>(levels - 1);
    table[i] = power ? std::pow(sample, static_cast<double>(PNG_FP_1) / gamma) : linearFromSrgb(sample);
  }
  return table;
}

}  // namespace

Image readPng(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = readFile(path);
  requireSignature(path, bytes, "\x89PNG\r\n\x1a\n", "a PNG image");
  PngReader reader(bytes);
  const auto require = [&](bool read) {
    if (!reader.png) throw std::bad_alloc();
    if (!read) fail(ErrorCode::Input, "{}: cannot be read as PNG: {}", path.string(), reader.message.data());
  };
  require(readHeader(reader));
  const std::uint32_t width = png_get_image_width(reader.png, reader.info);
  const std::uint32_t height = png_get_image_height(reader.png, reader.info);
  requireImageSize(path, width, height);
  require(setRgbaOutput(reader));

  const size_t rowBytes = png_get_rowbytes(reader.png, reader.info);
  std::vector<png_byte> samples(rowBytes * height);
  std::vector<png_bytep> rows(height);
  for (size_t y = 0; y < height; y++) rows[y] = samples.data() + y * rowBytes;
  require(readRows(reader, rows.data()));

  const size_t sampleBytes = png_get_bit_depth(reader.png, reader.info) / 8;
  const std::vector<double> linear = decodingTable(reader, size_t{1} << (8 * sampleBytes));
  const double full = static_cast<double>(linear.size() - 1);
  Image image(width, height);
  parallelFor(height, 16, [&](size_t begin, size_t end, unsigned) {
    for (size_t y = begin; y < end; y++) {
      const png_byte* row = rows[y];
      const auto sample = [&](size_t i) -> size_t {
        return sampleBytes == 1 ? row[i] : static_cast<size_t>(row[2 * i]) << 8 | row[2 * i + 1];
      };
      for (size_t x = 0; x < width; x++) {
        const double alpha = static_cast<double>(sample(4 * x + 3)) / full;
        image.pixels[y * width + x] = glm::vec4(linear[sample(4 * x)] * alpha, linear[sample(4 * x + 1)] * alpha,
                                                linear[sample(4 * x + 2)] * alpha, alpha);
      }
    }
  });
  return image;
}

}  // namespace tetralux
