// The transfer function on the device. Its size does not depend on the mesh; a change costs one copy of some kilobytes.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "gpu/packed_tables.h"
#include "render/mesh_space.h"
#include "volume/transfer_function.h"

namespace tetralux::render {

// The tables behind include/integrate.glsl and the cull pass, on the host.
struct TransferTables {
  std::vector<glm::vec4> pieces;         // TRANSFER_PIECE_TEXELS per piece
  std::vector<std::uint32_t> pieceBins;  // two per bin: the pieces at its low and high end
  std::vector<glm::vec4> points;         // luminance, extinction at control points; a step is two of one scalar
  std::vector<glm::vec2> pointScalars;   // of each point and the next; ascending, from -1e30 to 1e30
  std::vector<float> largestExtinction;  // EXTINCTION_LEVELS x TRANSFER_BINS, per mesh unit; or emission, if larger
  std::vector<glm::vec4> support;        // xy: open intervals of scalars inside which there is extinction or emission
};

// Scalars are normalised, extinctions and emissions per length are per mesh unit. Pieces that single precision cannot
// tell from a step are steps. A step's value at the step itself is the one after it, so the support of a step up is
// moved down by one ulp.
TransferTables makeTransferTables(const TransferFunction& transfer, const MeshSpace& space);

// Whether every scalar of the field lies inside one interval of a support.
bool coversField(const std::vector<glm::vec4>& support);

class TransferBuffer {
 public:
  // No transfer function yet: set() comes first.
  explicit TransferBuffer(const gpu::Context& context) : context_(context) {}
  TransferBuffer(const gpu::Context& context, const TransferFunction& transfer, const MeshSpace& space)
      : TransferBuffer(context) {
    set(transfer, space);
  }

  // Another transfer function. All tables share one buffer and go there in one copy; memory is taken from the device
  // only where they are longer than any before. Nothing may still be drawn with the last one. Throws Error(Device).
  void set(const TransferFunction& transfer, const MeshSpace& space);

  const gpu::TexelView& pieces() const { return pieceView_; }
  const gpu::TexelView& pieceBins() const { return binView_; }
  const gpu::TexelView& points() const { return pointView_; }
  const gpu::TexelView& pointScalars() const { return pointScalarView_; }
  const gpu::TexelView& largestExtinction() const { return extinctionView_; }
  const gpu::TexelView& support() const { return supportView_; }
  std::uint32_t supportCount() const { return supportCount_; }
  bool showsEverywhere() const { return coversField(support_); }
  Emission emission() const { return emission_; }
  float largest() const {
    return largest_;
  }  // extinction over all scalars, 1/mesh unit; or emission per length, if more
  // What pieces() holds, on the host: TRANSFER_PIECE_TEXELS per piece.
  const std::vector<glm::vec4>& pieceTexels() const { return pieceTexels_; }
  // The same of support().
  const std::vector<glm::vec4>& supportIntervals() const { return support_; }
  // The same of points() and pointScalars().
  const std::vector<glm::vec4>& pointTexels() const { return pointTexels_; }
  const std::vector<glm::vec2>& pointScalarTexels() const { return pointScalarTexels_; }
  std::uint64_t sizeBytes() const { return tables_.sizeBytes(); }

 private:
  const gpu::Context& context_;
  Emission emission_ = Emission::PerExtinction;
  float largest_ = 0.0f;
  std::uint32_t supportCount_ = 0;
  std::vector<glm::vec4> pieceTexels_;
  std::vector<glm::vec4> pointTexels_;
  std::vector<glm::vec2> pointScalarTexels_;
  std::vector<glm::vec4> support_;
  gpu::PackedTables tables_;
  gpu::TexelView pieceView_;
  gpu::TexelView binView_;
  gpu::TexelView pointView_;
  gpu::TexelView pointScalarView_;
  gpu::TexelView extinctionView_;
  gpu::TexelView supportView_;
};

}  // namespace tetralux::render
