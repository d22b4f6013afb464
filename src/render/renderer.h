// The public face: a mesh on a device, then pictures of it.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/recorder.h"
#include "image/image.h"
#include "mesh/adjacency.h"
#include "mesh/tet_mesh.h"
#include "render/empty_space.h"
#include "render/frame.h"
#include "render/order/order_check.h"
#include "render/projection.h"
#include "render/tolerance/tolerance_plan.h"
#include "view/camera.h"
#include "volume/transfer_function.h"

namespace tetralux::render {

struct RenderOptions {
  Target target = Target::Rgba32f;
  std::uint32_t chunkCells = 0;  // of Target::Rgba16fChunked; 0: a 32nd of the mesh's cells (chunkCellCount)
  Integration integration = Integration::Exact;
  Interpolation interpolation = Interpolation::Perspective;
  TableOptions table;
  bool timed = false;  // time every pass (costs a little)
  // What is drawn of cells is a faint grey, not integrated: the least that pass "raster" costs.
  bool constantColor = false;
  // Count what rays that walk have to do (FrameStats::march): a pipeline of its own, slower than others.
  bool countWork = false;
};

struct RendererOptions {
  // Reach every buffer by its address, as a mesh beyond the device's descriptor ranges needs. Chosen by itself where it
  // is needed; forced for tests, which then have lists in many pieces (gpu/pieced_buffer.h).
  bool forceWideAddressing = false;
  std::optional<SortVariant> sortVariant;  // nothing: the best for the device
  // Of rays that walk, where the device has it. Nothing: where single precision may show (precision.h); else for tests.
  std::optional<bool> doublePrecision;
  CellProjection projection = CellProjection::Pt;
  // Cut cells that the transfer function leaves empty out of the mesh that rays walk through, or never do (for tests).
  // Nothing: where it pays (empty_space.h).
  std::optional<bool> skipEmptySpace;
  // The work of rays that walk is shared out as GPUs like it: short turns, several invocations to a job
  // (shared/march.h). Nothing: on devices that are not processors; else for tests.
  std::optional<bool> gpuRays;
  // Snap vertices of fans to the device's grid and take back what that does to interpolated values. Nothing: on devices
  // that interpolate between snapped vertices, which are taken to be those that are not processors.
  std::optional<bool> snapVertices;
  Order order =
      Order::Auto;      // CellProjection::March needs none and is always right; with Auto, any other keeps cells drawn
  bool mayWalk = true;  // CellProjection::Auto may become March; false where what frames ask for is made by blending
  std::uint32_t kBuffer = 6;  // segments buffered per pixel by Order::KBuffer, 1 to KBUFFER_LARGEST
  // Largest error per pixel and channel that is allowed, > 0: frames with Integration::Exact, and what is Auto, are
  // then drawn as cheaply as is known to keep it (tolerance/tolerance_plan.h). Nothing: exactly, up to rounding.
  std::optional<double> tolerance;
  bool checkOrder = false;  // count what the order gets wrong, every frame (costs about as much as the cull pass)
};

// What CellProjection::Auto becomes, and why.
ProjectionChoice projectionFor(const RendererOptions& options);

struct FrameStats {
  std::uint64_t drawnCells = 0;
  std::uint64_t triangles = 0;  // with an area; of CellProjection::Gator all four of every cell
  // Drawn by clipping rays against their faces; not counted by CellProjection::Gator.
  std::optional<std::uint64_t> clippedCells = 0;
  std::uint64_t culledOutside = 0;
  std::uint64_t culledNoSample = 0;
  std::uint64_t culledTransparent = 0;  // of rays that walk: cut out of what they walk through
  std::vector<gpu::PassTime> passes;    // when timed
  Target target = Target::Rgba32f;      // what was drawn into; never Auto
  CellProjection projection = CellProjection::Pt;
  bool doublePrecision = false;  // rays walked in it
  OrderReport order;
  std::optional<MarchWork> march;  // when counted, of rays that walk
  Integration integration = Integration::Exact;
  Interpolation interpolation = Interpolation::Perspective;
  std::optional<TableBuild> tableBuild;  // of a table of three dimensions
  std::optional<TolerancePlan> plan;     // how the tolerance is kept, if one was given
  double tablesMs = 0.0;                 // that building the method's table took, before this frame or an earlier one
  double frameMs = 0.0;                  // device work until the picture is ready there
  double readbackMs = 0.0;               // picture to host memory
};

// On the device, but for the last two.
struct MemoryUse {
  std::uint64_t meshBytes = 0;
  std::uint64_t frameBytes = 0;
  std::uint64_t orderBytes = 0;
  std::uint64_t tableBytes = 0;

  // The frame's and the order's again, by what they grow with.
  std::uint64_t topologyBytes = 0;   // cells: who is whose neighbour
  std::uint64_t cellOrderBytes = 0;  // cells: keys, indices, what finds an order
  std::uint64_t pictureBytes = 0;    // pixels: pictures, lists of fragments, batches of projected cells

  gpu::MemoryBudget budget;  // what is left beside all this

  // On the host, while the renderer was made: mesh and field, and who is whose neighbour.
  std::uint64_t hostMeshBytes = 0;
  std::uint64_t hostAdjacencyBytes = 0;
};

class Renderer {
 public:
  // Copies the mesh to the device; it need not outlive the call. Throws Error(Device), before anything is allocated
  // where the device has too little memory left for the mesh.
  //   context   must outlive the renderer
  //   warmed    passes of a renderer with the same options (takeMarchPass()), or null
  Renderer(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
           const RendererOptions& options = {}, std::unique_ptr<MarchPass> warmed = nullptr);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Colours and extinctions from now on. Cost does not depend on the mesh.
  void setTransferFunction(const TransferFunction& transfer);

  // What is shown beside the volume, or instead of it, from now on: isosurfaces, lighting, clip planes, surfaces, other
  // ways to classify. A default appearance costs nothing. Throws Error(Usage) where the projection is neither
  // CellProjection::March nor, without surfaces, Silhouette; and Error(Device).
  //   data   makeAppearanceData() of the mesh's; need not outlive the call
  void setAppearance(const Appearance& appearance, const AppearanceData& data);

  // Draws a frame and leaves it on the device. Throws Error(Device), and Error(Usage) for a method of
  // integration that cannot carry the transfer function's emission or the projection. A transfer function must have
  // been set. A table that the method of integration needs is built before, when it is not that of the last frame.
  FrameStats draw(const Camera& camera, ImageSize size, const RenderOptions& options = {});

  // The last frame drawn. Sets `readbackMs` of its statistics, if given.
  Image readImage(FrameStats* stats = nullptr);

  // draw() and readImage() in two steps, for sequences: begin() hands a frame and the copy of its picture to the device
  // and does not wait, finish() waits for the oldest frame begun. So the device draws the next frame while the host
  // uses the last. Frames that need a look at the host in between, and timed ones, are drawn by begin() at once.
  // draw() must not be called while frames are in flight. Both throw like draw().
  void begin(const Camera& camera, ImageSize size, const RenderOptions& options = {});
  struct Finished {
    FrameStats stats;
    Image image;
  };
  Finished finish();
  // Frames begun and not finished. Each holds a picture on the host beside its own.
  size_t inFlight() const { return flights_.size(); }

  // The passes with all pipelines made so far, for another renderer on the same context; null where rays do not walk.
  // Nothing can be drawn after.
  std::unique_ptr<MarchPass> takeMarchPass() { return std::move(marchPass_); }

  MemoryUse memoryUse() const;
  const MeshSpace& space() const { return mesh_.space(); }
  std::uint64_t cellCount() const { return mesh_.cellCount(); }
  std::uint64_t pointCount() const { return mesh_.vertexCount(); }
  CellProjection projection() const { return projection_.projection; }

 private:
  // A frame as it is going to be drawn.
  struct Request {
    Camera camera;
    ImageSize size;
    RenderOptions options;
    gpu::PassTiming timing = gpu::PassTiming::Off;
    IntegrationVariant integration;
    std::uint32_t output = 0;  // shared/target_output.h
    bool checkOrder = false;
  };
  // A frame in flight.
  struct Flight {
    Request request;
    FrameStats stats;
    // Runs the frame, with copies of counts and picture. Null where it was drawn at once: `image` is it.
    std::unique_ptr<gpu::Recorder> recorder;
    MarchRoom room;          // that its lists have
    gpu::Buffer hostCounts;  // MarchCounts
    gpu::Buffer readback;    // the picture
    Image image;
  };

  // Settles what a frame is drawn with and into; draws a small one where Target::Auto has to be measured.
  Request prepare(const Camera& camera, ImageSize size, const RenderOptions& options, FrameStats& stats);
  FrameStats draw(const Request& request, FrameStats stats);
  // Waits for a frame in flight and takes its picture; draws it again where it did not get through.
  void land(Flight& flight);
  void landFlights();
  void prepareTransfer();
  double largestExtinction() const;  // 1/mesh unit
  // What depends on the mesh's adjacency beside its copy on the device.
  void noteAdjacency(const Adjacency& adjacency);
  // Throws Error(Usage) for a method that cannot carry the transfer function's emission or does not go with the
  // projection.
  void checkMethod(const RenderOptions& options) const;
  bool usesDoublePrecision(const FrameSetup& setup) const;
  void preparePlan();
  void prepareTables(Integration integration, const TableOptions& options);
  // What a frame turned out to need.
  struct Drawn {
    OrderReport order;
    MarchWork march;
    bool doublePrecision = false;
    double smallestPixel = 0.0;  // FrameSetup
  };
  void noteDrawn(FrameStats& stats, const Drawn& drawn) const;
  FrameSetup setupOf(const Request& request) const;
  //   setup   must outlive the inputs
  FrameInputs inputsOf(const Request& request, const FrameSetup& setup) const;
  Drawn drawInto(gpu::Recorder& recorder, const Request& request, const FrameTarget& target);
  FrameTarget targetOf(const Request& request) const;
  // Whether a frame is the same without the cells that do not show: tables of other methods may blur light into them.
  bool canSkip(const Request& request) const;
  // Cuts out what the transfer function leaves empty: before the first frame, unless there are many more cells than
  // pixels; else before the second with that transfer function, so that those who draw one picture, or try one transfer
  // function after the other, do not wait for it. Adds what it took to the statistics, as pass "skip".
  void skipEmptySpace(const Request& request, FrameStats& stats);
  SkipInputs skipInputs() const;
  // Target::Auto: draws a small frame that counts roundings and applies halfFloatHolds() to the worst of its pixels.
  // Adds what it took to the statistics, as pass "measure".
  Target chooseTarget(const Request& request, FrameStats& stats);

  const gpu::Context& context_;
  GpuMesh mesh_;
  bool wideAddressing_;
  bool checkOrder_;
  std::uint32_t subpixels_;  // SPEC_SUBPIXELS
  bool gpuRays_;
  std::uint64_t hostMeshBytes_;
  std::uint64_t hostAdjacencyBytes_ = 0;
  std::optional<double> tolerance_;
  std::optional<bool> doublePrecision_;
  ProjectionChoice projection_;
  std::optional<TolerancePlan> plan_;  // for transfer_
  double luminance_ = 0.0;             // largest of transfer_ over the field's range
  // Of projected cells:
  std::unique_ptr<FramePasses> passes_;
  std::unique_ptr<FrameStorage> storage_;
  std::unique_ptr<VisibilityKit> visibility_;
  std::unique_ptr<CellOrder> order_;
  // Of walking rays:
  std::unique_ptr<MarchPass> marchPass_;
  std::unique_ptr<MarchStorage> marchStorage_;
  std::unique_ptr<EmptySpace> emptySpace_;
  bool hasDrawn_ = false;          // any frame
  bool hasDrawnTransfer_ = false;  // one with this transfer function and appearance
  TransferFunction transferFunction_;
  std::unique_ptr<TransferBuffer> transfer_;
  bool isTransferReplaced_ = false;
  std::unique_ptr<AppearanceBuffer> appearance_;
  std::unique_ptr<SurfacePass> surfacePass_;
  std::unique_ptr<SurfaceStorage> surfaces_;
  std::unique_ptr<IntegrationTables> tables_;                  // made for the first frame
  std::optional<std::pair<Integration, TableOptions>> built_;  // what they hold for transfer_
  std::optional<CellLengths> lengths_;
  TargetImages target_;
  std::deque<std::unique_ptr<Flight>> flights_;  // the oldest first
  std::unique_ptr<Flight> spare_;                // one that is over, for its buffers

  // What Target::Auto became, and for which frame; forgotten with the transfer function.
  struct TargetChoice {
    Camera camera;
    ImageSize size;
    IntegrationVariant integration;
    Target target;
  };
  std::optional<TargetChoice> choice_;
  std::optional<bool> roundsToNearest_;  // halfBlendingRoundsToNearest(), once it is needed
};

}  // namespace tetralux::render
