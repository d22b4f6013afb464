#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "image/exr_error.h"
#include "image/image_io.h"

namespace tetralux {
namespace {

static_assert(static_cast<int>(ExrCompression::None) == Imf::NO_COMPRESSION);
static_assert(static_cast<int>(ExrCompression::Zips) == Imf::ZIPS_COMPRESSION);
static_assert(static_cast<int>(ExrCompression::Piz) == Imf::PIZ_COMPRESSION);
static_assert(static_cast<int>(ExrCompression::B44) == Imf::B44_COMPRESSION);
static_assert(static_cast<int>(ExrCompression::Dwab) == Imf::DWAB_COMPRESSION);

// A file that remembers a failed write. OpenEXR writes the table of offsets in a destructor, which keeps errors to
// itself, and the system may report a full disk only when the file is closed.
class FileStream : public Imf::OStream {
 public:
  //   temporary  the file that is opened
  //   path       the file that messages speak of
  FileStream(const std::filesystem::path& temporary, const std::filesystem::path& path)
      : Imf::OStream(path.filename().c_str()), path_(path), file_(std::fopen(temporary.c_str(), "wb")) {
    if (!file_) failNow();
  }
  ~FileStream() override {
    if (file_) std::fclose(file_);
  }

  void write(const char* bytes, int count) override {
    const size_t n = static_cast<size_t>(count);
    if (std::fwrite(bytes, 1, n, file_) != n) failNow();
  }
  std::uint64_t tellp() override { return static_cast<std::uint64_t>(::ftello(file_)); }
  void seekp(std::uint64_t position) override {
    if (::fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) failNow();
  }

  // Throws the first error met so far or met while closing.
  void close() {
    if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) error_ = errno;
    if (error_ != 0) throwError();
  }

 private:
  [[noreturn]] void failNow() {
    if (error_ == 0) error_ = errno;
    throwError();
  }
  [[noreturn]] void throwError() const {
    fail(ErrorCode::Output, "{}: cannot be written: {}", path_.string(), std::strerror(error_));
  }

  std::filesystem::path path_;
  std::FILE* file_;
  int error_ = 0;
};

// OpenEXR transforms row vectors from the left: the transpose, which is GLM's memory order read by rows.
Imath::M44f rowVectorMatrix(const glm::dmat4& m) {
  Imath::M44f result;
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++) result[i][j] = static_cast<float>(m[i][j]);
  }
  return result;
}

// OpenEXR's ndc from clip space: x to the right and y down, 0..1 over the image.
glm::dmat4 exrNdcFromClip() {
  glm::dmat4 m(1.0);
  m[0][0] = 0.5;
  m[1][1] = -0.5;
  m[3][0] = 0.5;
  m[3][1] = 0.5;
  return m;
}

Imf::Header makeHeader(const Image& image, const ExrOptions& options) {
  Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
  header.compression() = static_cast<Imf::Compression>(options.compression);
  for (const char* name : {"R", "G", "B", "A"})
    header.channels().insert(name, Imf::Channel(options.half ? Imf::HALF : Imf::FLOAT));
  if (!options.extraChannelName.empty()) header.channels().insert(options.extraChannelName, Imf::Channel(Imf::FLOAT));
  if (options.viewFromWorld) Imf::addWorldToCamera(header, rowVectorMatrix(*options.viewFromWorld));
  if (options.clipFromWorld) Imf::addWorldToNDC(header, rowVectorMatrix(exrNdcFromClip() * *options.clipFromWorld));
  for (const auto& [name, value] : options.attributes) {
    CHECK(header.find(name) == header.end());
    header.insert(name, Imf::StringAttribute(value));
  }
  return header;
}

half halfOf(float value) {
  constexpr float kLargest = 65504.0f;
  return half(std::isfinite(value) ? std::clamp(value, -kLargest, kLargest) : value);
}

// Lines converted to half at a time: the longest block that any compression takes (dwab), so that none is split.
constexpr std::uint32_t kBandRows = 256;

void writeRows(Imf::OutputFile& file, const Image& image, const ExrOptions& options) {
  const size_t rowPixels = image.width;
  std::vector<half> band(options.half ? rowPixels * std::min(image.height, kBandRows) * 4 : 0);
  const std::uint32_t step = options.half ? kBandRows : image.height;
  for (std::uint32_t top = 0; top < image.height; top += step) {
    const std::uint32_t rows = std::min(step, image.height - top);
    const glm::vec4* pixels = &image.at(0, top);
    if (options.half) {
      parallelFor(rowPixels * rows, 1 << 16, [&](size_t begin, size_t end, unsigned) {
        for (size_t i = begin; i < end; i++) {
          for (size_t c = 0; c < 4; c++) band[4 * i + c] = halfOf(pixels[i][static_cast<int>(c)]);
        }
      });
    }
    const Imath::Box2i window(Imath::V2i(0, static_cast<int>(top)),
                              Imath::V2i(static_cast<int>(image.width) - 1, static_cast<int>(top + rows) - 1));
    const auto addSlice = [&](Imf::FrameBuffer& frame, const std::string& name, Imf::PixelType type, const void* first,
                              size_t pixelBytes) {
      frame.insert(name, Imf::Slice::Make(type, first, window, pixelBytes, pixelBytes * rowPixels));
    };
    Imf::FrameBuffer frame;
    const char* channelNames[4] = {"R", "G", "B", "A"};
    for (size_t c = 0; c < 4; c++) {
      if (options.half) {
        addSlice(frame, channelNames[c], Imf::HALF, band.data() + c, 4 * sizeof(half));
      } else {
        addSlice(frame, channelNames[c], Imf::FLOAT, reinterpret_cast<const float*>(pixels) + c, sizeof(glm::vec4));
      }
    }
    if (!options.extraChannelName.empty())
      addSlice(frame, options.extraChannelName, Imf::FLOAT, options.extraChannel.data() + top * rowPixels,
               sizeof(float));
    file.setFrameBuffer(frame);
    file.writePixels(static_cast<int>(rows));
  }
}

}  // namespace

void writeExr(const Image& image, const std::filesystem::path& path, const ExrOptions& options) {
  CHECK_LT(0u, image.width);
  CHECK_LT(0u, image.height);
  CHECK_EQ(image.pixels.size(), static_cast<size_t>(image.width) * image.height);
  CHECK_EQ(options.extraChannel.size(), options.extraChannelName.empty() ? 0 : image.pixels.size());
  for (const char* name : {"R", "G", "B", "A"}) CHECK(options.extraChannelName != name);
  PendingFile pending(path);
  withExrErrors(ErrorCode::Output, path, "cannot be written as OpenEXR", [&] {
    Imf::setGlobalThreadCount(static_cast<int>(workerCount()));
    FileStream stream(pending.temporaryPath(), path);
    {
      Imf::OutputFile file(stream, makeHeader(image, options));
      writeRows(file, image, options);
    }
    stream.close();
  });
  pending.commit();
}

}  // namespace tetralux
