#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfVersion.h>

#include <cstring>
#include <string_view>

#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "image/exr_error.h"
#include "image/image_file.h"
#include "image/image_io.h"

namespace tetralux {
namespace {

constexpr const char* kUnreadable = "cannot be read as OpenEXR";

// A file's bytes as OpenEXR wants them. Reading from memory gives every kind of bad file the same message as the other
// readers give, and the end of the bytes is checked here, whatever sizes the file claims.
class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(const std::string& name, const std::vector<std::byte>& bytes)
      : Imf::IStream(name.c_str()), bytes_(bytes) {}

  bool read(char* out, int count) override {
    const size_t n = static_cast<size_t>(count);
    if (count < 0 || position_ > bytes_.size() || bytes_.size() - position_ < n)
      throw Iex::InputExc(
          fmt::format("the file ends after {} bytes, {} more were expected at {}", bytes_.size(), count, position_));
    if (n > 0) std::memcpy(out, bytes_.data() + position_, n);
    position_ += n;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  const std::vector<std::byte>& bytes_;
  std::uint64_t position_ = 0;
};

std::vector<std::byte> readExrBytes(const std::filesystem::path& path) {
  std::vector<std::byte> bytes = readFile(path);
  requireSignature(path, bytes, "\x76\x2f\x31\x01", "an OpenEXR image");
  return bytes;
}

std::uint32_t littleEndian(const std::byte* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; i++) value |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
  return value;
}

// Compares the sizes that attributes claim with the bytes that follow: OpenEXR allocates them, up to 2 GiB, before it
// reads. Layout: file signature and version, 4 bytes each, then name, type (both ended by 0), size and value of every
// attribute; an empty name ends a header, and an empty header those of a file with several parts.
void requireAttributeSizes(const std::vector<std::byte>& bytes, bool severalParts) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  size_t at = 8;
  const auto text = [&] {
    const size_t end = all.find('\0', at);
    if (end == std::string_view::npos)
      throw Iex::InputExc(fmt::format("the file ends after {} bytes in its header", all.size()));
    const std::string_view found = all.substr(at, end - at);
    at = end + 1;
    return found;
  };
  bool another = true;
  while (another) {
    another = false;
    for (std::string_view name = text(); !name.empty(); name = text()) {
      another = severalParts;
      text();
      if (all.size() - at < 4) throw Iex::InputExc(fmt::format("attribute '{}' is cut off", name));
      const std::uint32_t size = littleEndian(bytes.data() + at);
      at += 4;
      if (all.size() - at < size)
        throw Iex::InputExc(
            fmt::format("attribute '{}' has {} bytes, but the file only {} more", name, size, all.size() - at));
      at += size;
    }
  }
}

// The first header, read before InputFile sees the file: InputFile allocates by what the header claims.
Imf::Header readHeader(const std::string& name, const std::vector<std::byte>& bytes) {
  if (bytes.size() < 8) throw Iex::InputExc(fmt::format("the file ends after {} bytes in its header", bytes.size()));
  const std::uint32_t field = littleEndian(bytes.data() + 4);
  int version = static_cast<int>(field);
  if (Imf::getVersion(version) != Imf::EXR_VERSION || !Imf::supportsFlags(Imf::getFlags(version)))
    throw Iex::InputExc(fmt::format("version field is {:#x}, expected version {}", field, Imf::EXR_VERSION));
  requireAttributeSizes(bytes, Imf::isMultiPart(version));
  MemoryStream stream(name, bytes);
  stream.seekg(8);
  Imf::Header header;
  header.readFrom(stream, version);
  return header;
}

void requireColourChannels(const std::filesystem::path& path, const Imf::ChannelList& channels) {
  for (const char* name : {"R", "G", "B"}) {
    if (channels.findChannel(name)) continue;
    std::vector<std::string> names;
    for (auto c = channels.begin(); c != channels.end(); ++c) names.emplace_back(c.name());
    fail(ErrorCode::Input, "{}: has no channel {}: channels are {}, expected R, G, B and perhaps A", path.string(),
         name, names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")));
  }
}

}  // namespace

Image readExr(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = readExrBytes(path);
  const std::string name = path.filename().string();
  return withExrErrors(ErrorCode::Input, path, kUnreadable, [&] {
    const Imf::Header header = readHeader(name, bytes);
    const Imath::Box2i window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    requireImageSize(path, width, height);
    if (header.hasType() && Imf::isDeepData(header.type()))
      fail(ErrorCode::Input, "{}: is a deep image ({}), expected a flat one", path.string(), header.type());
    requireColourChannels(path, header.channels());

    Imf::setGlobalThreadCount(static_cast<int>(workerCount()));
    MemoryStream stream(name, bytes);
    Imf::InputFile file(stream);
    if (!file.isComplete()) fail(ErrorCode::Input, "{}: is incomplete: some of its pixels are missing", path.string());
    Image image(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    Imf::FrameBuffer frame;
    const char* channelNames[4] = {"R", "G", "B", "A"};
    for (size_t c = 0; c < 4; c++) {
      constexpr double kOpaque = 1.0;  // filled in where the file has no A
      const char* first = reinterpret_cast<const char*>(image.pixels.data()) + c * sizeof(float);
      frame.insert(channelNames[c], Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(glm::vec4),
                                                     sizeof(glm::vec4) * image.width, 1, 1, kOpaque));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return image;
  });
}

std::optional<std::string> readExrAttribute(const std::filesystem::path& path, const std::string& name) {
  const std::vector<std::byte> bytes = readExrBytes(path);
  return withExrErrors(ErrorCode::Input, path, kUnreadable, [&]() -> std::optional<std::string> {
    const Imf::Header header = readHeader(path.filename().string(), bytes);
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name.c_str());
    if (!attribute) return std::nullopt;
    return attribute->value();
  });
}

}  // namespace tetralux
