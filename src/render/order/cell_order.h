// The order in which cells are drawn, as a choice.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/recorder.h"
#include "render/frame_view.h"
#include "render/gpu_mesh.h"
#include "render/gpu_topology.h"
#include "render/order/cycles.h"
#include "render/pipeline_variants.h"
#include "render/sort_pass.h"

namespace tetralux::render {

enum class Order {
  Auto,     // radix where the check proves it exact for the view, otherwise exact
  None,     // by cell index
  Bucket,   // by centroid distance in 256 buckets (Marroquim et al. 2008, section 4.2)
  Bitonic,  // by centroid distance, bitonic merge sort
  Radix,    // by centroid distance, radix sort
  Power,    // by the power of the eye with respect to the circumspheres: exact on Delaunay meshes
  KBuffer,  // by centroid distance, mended per pixel by a buffer of k segments (Callahan et al. 2005)
  Exact,    // the visibility order itself; cells of cycles are composited per pixel
};

// Names on the command line and in statistics, in the order above; parseOrder throws Error(Usage).
const std::vector<std::string>& orderNames();
const char* orderName(Order order);
Order parseOrder(const std::string& name);

// How right an order is for a view.
struct OrderReport {
  Order order = Order::Radix;             // what was drawn; never Auto
  bool isChecked = false;                 // the next four counts were made
  std::uint64_t faces = 0;                // shared faces that a ray may pass through
  std::uint64_t misordered = 0;           // ... whose two cells are sorted the wrong way round
  std::uint64_t relations = 0;            // pairs of cells behind each other across a gap, counted at every pixel
  std::uint64_t misorderedRelations = 0;  // ... sorted the wrong way round
  std::uint64_t cyclicCells = 0;          // cells that hide each other in a cycle (exact)
  std::uint64_t apartCells = 0;           // cells composited per pixel: those of cycles and some between them (exact)
  std::uint64_t shortPixels = 0;          // pixels where the k-buffer was too small for the right order (kbuffer)
  std::uint64_t levels = 0;               // length of the longest chain of cells behind each other (exact)

  // Whether every pixel is known to show its cells in the right order.
  bool isExact() const;
};

// What an order works with. Keys are the cull pass's; buffers are the frame's.
struct OrderInputs {
  gpu::Recorder& recorder;
  const GpuMesh& mesh;
  const FrameSetup& setup;
  FrameVariant variant;
  ImageSize size;
  const gpu::Buffer& view;  // FrameView
  SortStorage& sort;
  bool check = false;  // fill in the report's counts
};

// Cells in drawing order, on the device.
struct CellSequence {
  const gpu::Buffer* order = nullptr;  // cell indices
  const gpu::TexelView* orderView = nullptr;
  const gpu::Buffer* kept = nullptr;  // how many (one uint)
  std::vector<SlotSpan> apart;        // cells that are composited per pixel, back to front
  std::uint32_t kBuffer = 0;          // ... with a buffer of this many segments; 0: sorted
  OrderReport report;
};

// One way of ordering cells.
class CellOrder {
 public:
  virtual ~CellOrder() = default;

  // Records what turns the cull pass's keys into a sequence, in passes named "order", "check" and "sort". May run the
  // recorder to look at results. A barrier from compute writes is recorded at the end.
  virtual CellSequence record(const OrderInputs& inputs) = 0;

  // Device memory of its own.
  virtual std::uint64_t sizeBytes() const = 0;
};

}  // namespace tetralux::render
