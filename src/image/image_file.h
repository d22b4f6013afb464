// What the readers of image files check before they hand a file to its library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace tetralux {

// Throws Error(Input) when `bytes` does not begin with `signature` (text of any bytes). `format` is the kind of image.
void requireSignature(const std::filesystem::path& path, const std::vector<std::byte>& bytes,
                      std::string_view signature, const char* format);

// Throws Error(Input) when an image of this size is empty or beyond kMaxImageSide or kMaxImagePixels.
void requireImageSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height);

}  // namespace tetralux
