// Files compiled into the program: shader modules and presets.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace tetralux {

struct EmbeddedFile {
  std::string_view name;      // path relative to the embedded folder
  const unsigned char* data;  // aligned to 4 bytes, never freed
  size_t sizeBytes;

  std::string_view text() const { return {reinterpret_cast<const char*>(data), sizeBytes}; }
};

// The file of that name, or null.
inline const EmbeddedFile* findEmbedded(std::span<const EmbeddedFile> files, std::string_view name) {
  for (const EmbeddedFile& file : files) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

}  // namespace tetralux
