// What the passes of a frame have to do, as far as a frame's statistics tell.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/renderer.h"

namespace tetralux::render {

struct PassWork {
  std::string pass;
  // The least that is read and written: every input and every output once.
  std::optional<std::uint64_t> bytes;
  std::optional<std::uint64_t> items;
  std::string unit;                                           // of the items
  std::vector<std::pair<std::string, std::uint64_t>> counts;  // everything that was counted, by name
};

// The passes that a frame has under their names, in order. Those of the march need the frame's work to have been
// counted.
std::vector<PassWork> passWork(const FrameStats& stats, std::uint64_t cells, std::uint64_t points, ImageSize size);

}  // namespace tetralux::render
