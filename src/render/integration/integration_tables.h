// The tables behind the methods of integration that have one, on the device.
#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/sampled_image.h"
#include "render/integration/cell_lengths.h"
#include "render/integration/integration.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

// What a table depends on beside the method.
struct TableInputs {
  const TransferBuffer& transfer;
  CellLengths lengths;
};

// Holds the table of one method at a time. Without one there is only a texel of each kind, so that every binding of
// include/integrate.glsl has something to be bound to.
class IntegrationTables {
 public:
  explicit IntegrationTables(const gpu::Context& context);

  // Builds the table of a method and waits for it; a method that has none gives the memory of the last one back. Throws
  // Error(Device) when it does not fit the device, Error(Input) when the transfer function has more pieces than
  // Integration::Moments takes.
  void build(Integration integration, const TableOptions& options, const TableInputs& inputs);

  // The bindings INTEGRATION_NUMBERS, INTEGRATION_TABLE_2D and INTEGRATION_TABLE_3D.
  const gpu::TexelView& numbers() const { return numberView_; }
  const gpu::SampledImage& table2d() const { return table2d_; }
  const gpu::SampledImage& table3d() const { return table3d_; }

  // Whether the shader has to interpolate between entries.
  bool needsFetch() const { return needsFetch_; }

  double buildMs() const { return buildMs_; }                           // that the last build took, 0 without a table
  std::optional<TableBuild> tableBuild() const { return tableBuild_; }  // of a table of three dimensions
  std::uint64_t sizeBytes() const { return bytes_; }                    // of the table, 0 without one

  // The table's entries as a shader sees them, row 0 of slice 0 first; those of one channel in all of xyz. With
  // emission per length, light is per mesh unit of the segment. The last build must have made an image.
  std::vector<glm::vec4> read() const;
  const gpu::ImageExtent& extent() const { return extent_; }

 private:
  void clear();
  TableFormat defaultFormat(int channels) const;
  void buildImage(Integration integration, const TableOptions& options, const TableInputs& inputs);
  void setNumbers(const std::vector<glm::vec4>& numbers);

  const gpu::Context& context_;
  gpu::Buffer numberBuffer_;
  gpu::TexelView numberView_;
  gpu::SampledImage table2d_;
  gpu::SampledImage table3d_;
  gpu::ImageExtent extent_;
  TableFormat format_ = TableFormat::Unorm16;
  int channels_ = 0;  // 0: there is no table
  glm::vec4 valuePerEntry_{1.0f};
  bool needsFetch_ = false;
  double buildMs_ = 0.0;
  std::optional<TableBuild> tableBuild_;
  std::uint64_t bytes_ = 0;
};

}  // namespace tetralux::render
