// Image files: OpenEXR for numbers, PNG for eyes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"

namespace tetralux {

// Largest image that the readers accept. A damaged header must not make them allocate what no machine has.
constexpr std::uint32_t kMaxImageSide = 65536;                     // pixels
constexpr std::uint64_t kMaxImagePixels = std::uint64_t{1} << 28;  // 4 GiB in memory

enum class ExrCompression { None, Rle, Zips, Zip, Piz, Pxr24, B44, B44a, Dwaa, Dwab };

// The name used on the command line, lower case ("zip").
const char* exrCompressionName(ExrCompression compression);

// The compression of that name. Throws Error(Usage), with all the names, for any other text.
ExrCompression parseExrCompression(std::string_view name);

// Every member has an initializer, so that those left out of {.half = true} draw no warning.
struct ExrOptions {
  // 16-bit instead of 32-bit floating point, rounded to nearest even. Finite values beyond 65504 become 65504, so that
  // a finite image stays one.
  bool half = false;
  ExrCompression compression = ExrCompression::Zip;
  // Standard attributes. Give column-vector matrices as used everywhere here; what is written follows OpenEXR: row
  // vectors, single precision, and an ndc of (0, 0) at the upper left and (1, 1) at the lower right of the image.
  std::optional<glm::dmat4> viewFromWorld{};  // written as worldToCamera; view: x right, y up, z forward
  std::optional<glm::dmat4> clipFromWorld{};  // written as worldToNDC; clip: x right, y up, -1..1 over the image
  // Further string attributes, name and value. Not the name of an attribute that every file has.
  std::vector<std::pair<std::string, std::string>> attributes{};
  // A further 32-bit channel if the name is not empty, one value per pixel (the reference's count of cells hit).
  std::string extraChannelName{};
  std::vector<float> extraChannel{};
};

// Writes RGBA, linear and premultiplied, complete or not at all: on failure an existing file is untouched and nothing
// else is left behind. Throws Error(Output).
void writeExr(const Image& image, const std::filesystem::path& path, const ExrOptions& options = {});

// Reads R, G, B and A (1 where the file has none) of any pixel type, in scan lines or tiles, over the data window
// wherever it lies. Of a file with several parts the first is read. Throws Error(Input) when the file is not an EXR
// image, is damaged or incomplete, larger than the limits above, deep, or lacks a colour channel.
Image readExr(const std::filesystem::path& path);

// String attribute of an EXR file; empty if it has none of that name and type. Pixels are not looked at. Throws
// Error(Input) when the file is not an EXR image or its header is damaged.
std::optional<std::string> readExrAttribute(const std::filesystem::path& path, const std::string& name);

// How colours are stored in a PNG file.
enum class PngColors {
  Rgb,
  Palette,  // where there are at most 256 colours: smaller, the same when decoded
};

// The bytes of a PNG file, 8-bit sRGB without alpha: the image over `background` (linear RGB), clamped to [0, 1],
// rounded to nearest. Not-a-number becomes 0. Throws Error(Output) where PNG has no such image (sides beyond 2^31).
std::vector<std::byte> encodePng(const Image& image, const glm::vec3& background, PngColors colors = PngColors::Rgb);

// The same to a file. Complete or not at all, like writeExr. Throws Error(Output).
void writePng(const Image& image, const std::filesystem::path& path, const glm::vec3& background);

// Reads a PNG of any kind (1 to 16 bits, gray, palette or RGB, with or without alpha) as linear premultiplied RGBA.
// Colours are sRGB, unless the file says otherwise by a gAMA chunk alone; colour profiles are ignored. Throws
// Error(Input) when the file is not a PNG image, is damaged or incomplete, or larger than the limits above.
Image readPng(const std::filesystem::path& path);

// Chooses by the file's extension, .exr or .png, in any case. Throws Error(Input) on another one.
Image readImage(const std::filesystem::path& path);

}  // namespace tetralux
