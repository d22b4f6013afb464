// What is shown beside the volume, on the device (shared/appearance.h).
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "gpu/commands.h"
#include "gpu/packed_tables.h"
#include "gpu/pipeline.h"
#include "render/appearance_texels.h"
#include "render/mesh_space.h"
#include "render/transfer_buffer.h"
#include "view/camera.h"
#include "volume/appearance.h"

namespace tetralux::render {

class AppearanceBuffer {
 public:
  // Copies what is needed to the device: gradients, numbers and colours at vertices only where something uses them, 16
  // bytes per vertex each. Throws Error(Device).
  AppearanceBuffer(const gpu::Context& context, const Appearance& appearance, const AppearanceData& data,
                   const MeshSpace& space);

  // Merges the transfer function's control points with the isovalues.
  void setTransfer(const TransferBuffer& transfer);

  // Records that clip planes are as a camera sees them. Transfer writes: barriers are owed.
  void recordCamera(gpu::CommandBuffer& commands, const Camera& camera) const;

  // What march_appearance.comp is specialised for.
  const gpu::SpecConstants& specConstants() const { return constants_; }

  // Largest extinction with all factors, or of what replaces the transfer function, 1/mesh unit.
  double largestExtinction(double ofTransferFunction) const;

  // As TransferBuffer's, for scalars that show: those of isosurfaces, too, and all where classification is by more.
  const gpu::TexelView& support() const { return supportView_; }
  std::uint32_t supportCount() const { return supportCount_; }
  bool showsEverywhere() const { return showsEverywhere_; }

  const gpu::TexelView& texels() const { return texelView_; }
  const gpu::TexelView& gradients() const { return gradientView_; }
  const gpu::TexelView& numbers() const { return numberView_; }
  const gpu::TexelView& colors() const { return colorView_; }
  const gpu::TexelView& points() const { return pointView_; }
  const gpu::TexelView& pointScalars() const { return pointScalarView_; }
  std::uint64_t sizeBytes() const;

 private:
  const gpu::Context& context_;
  std::vector<ClipPlane> clip_;
  MeshSpace space_;
  std::vector<float> isovalues_;
  gpu::SpecConstants constants_;
  double ownExtinction_ = 0.0;  // of colours at vertices or a transfer function of two dimensions
  bool replacesTransfer_ = false;
  double largestFactor_ = 1.0;
  gpu::Buffer texelBuffer_;
  gpu::Buffer gradientBuffer_;
  gpu::Buffer numberBuffer_;
  gpu::Buffer colorBuffer_;
  gpu::PackedTables transferTables_;
  gpu::TexelView texelView_;
  gpu::TexelView gradientView_;
  gpu::TexelView numberView_;
  gpu::TexelView colorView_;
  gpu::TexelView pointView_;
  gpu::TexelView pointScalarView_;
  gpu::TexelView supportView_;
  std::uint32_t supportCount_ = 0;
  bool showsEverywhere_ = false;
};

}  // namespace tetralux::render
