#include "image/image_io.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"
#include "image/image_file.h"

namespace tetralux {
namespace {

// In the order of ExrCompression.
constexpr std::array<const char*, 10> kCompressionNames{"none",  "rle", "zips", "zip",  "piz",
                                                        "pxr24", "b44", "b44a", "dwaa", "dwab"};
static_assert(kCompressionNames.size() == static_cast<size_t>(ExrCompression::Dwab) + 1);

std::string hexOf(const std::byte* bytes, size_t count) {
  std::string text;
  for (size_t i = 0; i < count; i++)
    text += fmt::format("{}{:02x}", i == 0 ? "" : " ", std::to_integer<unsigned>(bytes[i]));
  return text;
}

}  // namespace

const char* exrCompressionName(ExrCompression compression) {
  return kCompressionNames.at(static_cast<size_t>(compression));
}

ExrCompression parseExrCompression(std::string_view name) {
  const auto found = std::find(kCompressionNames.begin(), kCompressionNames.end(), name);
  if (found == kCompressionNames.end())
    fail(ErrorCode::Usage, "unknown compression '{}', expected {}", name, fmt::join(kCompressionNames, ", "));
  return static_cast<ExrCompression>(found - kCompressionNames.begin());
}

Image readImage(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".exr") return readExr(path);
  if (extension == ".png") return readPng(path);
  fail(ErrorCode::Input, "{}: unknown image format '{}', expected .exr or .png", path.string(),
       path.extension().string());
}

void requireSignature(const std::filesystem::path& path, const std::vector<std::byte>& bytes,
                      std::string_view signature, const char* format) {
  const auto* expected = reinterpret_cast<const std::byte*>(signature.data());
  const size_t length = std::min(signature.size(), bytes.size());
  if (length == signature.size() && std::equal(expected, expected + length, bytes.begin())) return;
  fail(ErrorCode::Input, "{}: is not {}: begins with {}, expected {}", path.string(), format,
       hexOf(bytes.data(), length), hexOf(expected, signature.size()));
}

void requireImageSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || width > kMaxImageSide || height > kMaxImageSide ||
      static_cast<std::uint64_t>(width * height) > kMaxImagePixels)
    fail(ErrorCode::Input, "{}: is {} x {} pixels, expected 1 to {} a side and at most {} in all", path.string(), width,
         height, kMaxImageSide, kMaxImagePixels);
}

}  // namespace tetralux
