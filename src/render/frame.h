// One frame, from the mesh on the device to the picture on the device.
#pragma once

#include <memory>

#include "gpu/recorder.h"
#include "render/apart_pass.h"
#include "render/appearance_buffer.h"
#include "render/batch.h"
#include "render/combine_pass.h"
#include "render/cull_pass.h"
#include "render/frame_view.h"
#include "render/gpu_mesh.h"
#include "render/march_pass.h"
#include "render/order/cell_order.h"
#include "render/project_pass.h"
#include "render/raster_pass.h"
#include "render/sort_pass.h"
#include "render/surface_pass.h"
#include "render/target_images.h"
#include "render/transfer_buffer.h"
#include "shared/counters.h"

namespace tetralux::render {

// What only depends on the mesh: reused from frame to frame.
struct FrameStorage {
  SortStorage sort;
  BatchStorage batches;
  gpu::Buffer view;                   // FrameView
  gpu::Buffer counters;               // FrameCounters
  gpu::Buffer shortPixels;            // one uint
  std::unique_ptr<PixelLists> lists;  // made when cells are composited apart

  FrameStorage(const gpu::Context& context, std::uint32_t cellCount, SortVariant sortVariant,
               CellProjection projection = CellProjection::Pt);
  std::uint64_t sizeBytes() const;
};

// The passes, in no order.
struct FramePasses {
  GpuTruthTable truthTable;
  CullPass cull;
  ProjectPass project;
  RasterPass raster;
  CombinePass combine;
  ApartPass apart;

  explicit FramePasses(const gpu::Context& context);
};

// Everything that one frame reads.
struct FrameInputs {
  const gpu::Context& context;
  const GpuMesh& mesh;
  const TransferBuffer& transfer;
  const IntegrationTables& tables;
  const FrameSetup& setup;
  FrameVariant variant;
  const Camera& camera;
  ImageSize size;
  const AppearanceBuffer* appearance = nullptr;  // what is shown beside the volume
  // Of the march alone:
  SurfacePass* surfacePass = nullptr;  // with surfaces
  SurfaceStorage* surfaces = nullptr;  // opaque triangles, if there are any
  bool checkOrder = false;             // count what the order gets wrong
  // Of the march: the part of the mesh that is left to walk through (empty_space.h), or null for all of it.
  const WalkTopology* kept = nullptr;

  const WalkTopology& walkTopology(const MarchStorage& storage) const { return kept ? *kept : storage.topology(); }
};

// Draws a frame into `target`, whose old content is forgotten, and waits for it. Returns how right the order was.
OrderReport drawFrame(gpu::Recorder& recorder, const FrameInputs& inputs, FramePasses& passes, CellOrder& order,
                      FrameStorage& storage, const FrameTarget& target);

// What a frame of rays that walk had to do.
struct MarchWork {
  std::uint64_t faces = 0;  // boundary faces that were looked at, once for every band of rows
  std::uint64_t jobs = 0;   // pairs of a face and a tile of pixels that it may cover
  // Of frames with FrameVariant::countWork, else 0:
  std::uint64_t entries = 0;  // of rays into the mesh: nodes of the pixels' lists
  std::uint64_t cells = 0;    // steps from cell to cell
  std::uint64_t parts = 0;    // segments, or parts of segments, that were integrated
};

// The same by rays that walk from cell to cell: no cell is projected and none is sorted.
MarchWork marchFrame(gpu::Recorder& recorder, const FrameInputs& inputs, MarchPass& pass, MarchStorage& storage,
                     const gpu::AttachmentImage& target);

// Whether recordMarchFrame() can draw a frame: it is drawn in one band, without a look at the host in between.
bool canRunAhead(const FrameInputs& inputs, MarchStorage& storage);

// Records the same frame without waiting for it, in the hope that its lists fit and that one dispatch is enough.
//   hostCounts   MarchCounts: when all has run, they tell whether that came true
void recordMarchFrame(gpu::Recorder& recorder, const FrameInputs& inputs, MarchPass& pass, const MarchStorage& storage,
                      const gpu::AttachmentImage& target, const gpu::Buffer& hostCounts);

}  // namespace tetralux::render
