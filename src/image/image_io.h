// Image files: OpenEXR for numbers, PNG for eyes.
#pragma once

#include <array>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"

namespace tetralux {

enum class ExrCompression { None, Rle, Zips, Zip, Piz, Pxr24, B44, B44a, Dwaa, Dwab };

// The name used on the command line, lower case ("zip"); parse throws Error(Usage) and lists the names.
const char* exrCompressionName(ExrCompression compression);
ExrCompression parseExrCompression(const std::string& name);

struct ExrOptions {
  bool half = false;  // 16-bit instead of 32-bit floating point
  ExrCompression compression = ExrCompression::Zip;
  // Standard attributes, row-vector convention of OpenEXR is handled inside: give column-vector matrices.
  std::optional<glm::dmat4> viewFromWorld;  // written as worldToCamera
  std::optional<glm::dmat4> clipFromWorld;  // written as worldToNDC
  // Further string attributes, name and value.
  std::vector<std::pair<std::string, std::string>> attributes;
  // A further 32-bit channel, one value per pixel, if not empty (the reference's count of cells hit).
  std::string extraChannelName;
  std::vector<float> extraChannel;
};

// Writes RGBA, linear and premultiplied, complete or not at all. Throws Error(Output).
void writeExr(const Image& image, const std::filesystem::path& path, const ExrOptions& options = {});

// Reads R, G, B and A (alpha 1 where the file has none) of any pixel type. Throws Error(Input) when the file is not an
// EXR image, is damaged, tiled in a way OpenEXR cannot read as RGBA, or lacks a colour channel.
Image readExr(const std::filesystem::path& path);

// String attribute of an EXR file, if it is there. Throws Error(Input) like readExr.
std::optional<std::string> readExrAttribute(const std::filesystem::path& path, const std::string& name);

// Writes 8-bit sRGB without alpha: the image over `background` (linear RGB), clamped to [0, 1], rounded to nearest.
// Not-a-number becomes 0. Throws Error(Output).
void writePng(const Image& image, const std::filesystem::path& path, const glm::vec3& background);

// Reads an 8- or 16-bit PNG as linear premultiplied RGBA (sRGB decoded). Throws Error(Input).
Image readPng(const std::filesystem::path& path);

// Chooses by the file's extension, .exr or .png, in any case. Throws Error(Input) on another one.
Image readImage(const std::filesystem::path& path);

}  // namespace tetralux
