// Empty-space skipping: cells that neither absorb nor emit are cut out of the mesh that rays walk through, once for
// each transfer function. What is left is a mesh with holes, and rays that leave it come back as into any other.
#pragma once

#include <optional>

#include "gpu/recorder.h"
#include "render/skip_pass.h"
#include "render/walk_topology.h"

namespace tetralux::render {

// Whether cutting cells out of a mesh makes frames faster: when it saves many more steps of rays than it makes faces at
// which they come back. Both are counted as if rays met all cells and faces alike.
//   cells, faces           of the whole mesh: cells, boundary faces
//   keptCells, keptFaces   of the cells that are left
bool paysToCut(std::uint64_t cells, std::uint64_t faces, std::uint64_t keptCells, std::uint64_t keptFaces);

// Whether looking for what is empty may make even a single picture faster: that takes 50 to 90 ns a cell on lavapipe,
// and saves a few hundred a pixel.
bool isWorthOnePicture(std::uint64_t cells, std::uint64_t pixels);

class EmptySpace {
 public:
  //   forced   cut out what is empty whether it pays or not, or never (for tests); nothing: where it pays
  EmptySpace(const gpu::Context& context, std::optional<bool> forced) : context_(context), forced_(forced) {}

  // Another transfer function, or another appearance: nothing is cut out until find() is called again.
  void forget();
  // Whether find() has been called since.
  bool isFound() const { return isFound_; }

  // Finds the cells that show, and cuts out the others where that pays (paysToCut()) and the device has memory for it.
  // Waits for the device, which must not be drawing with an earlier result. Throws Error(Device).
  void find(gpu::Recorder& recorder, const SkipInputs& inputs);

  // What rays have to walk through; null where that is the whole mesh.
  const WalkTopology* kept() const { return isCut_ ? &*kept_ : nullptr; }
  // Cells that are cut out.
  std::uint32_t cutCells() const { return isCut_ ? cutCells_ : 0; }

  // Up to 32.3 bytes per cell and 16 per face of the surface around those that show.
  std::uint64_t sizeBytes() const;

 private:
  const gpu::Context& context_;
  std::optional<bool> forced_;
  std::optional<SkipPass> pass_;  // made when it is first needed
  bool isFound_ = false;
  bool isCut_ = false;
  std::uint32_t cutCells_ = 0;
  std::optional<WalkTopology> kept_;
};

}  // namespace tetralux::render
