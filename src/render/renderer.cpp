#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "base/parallel.h"
#include "mesh/adjacency.h"
#include "mesh/cut_folds.h"
#include "mesh/overlaps.h"
#include "render/memory_need.h"
#include "render/order/make_order.h"
#include "render/precision.h"
#include "render/rounding_probe.h"
#include "shared/march.h"
#include "shared/target_output.h"

namespace tetralux::render {
namespace {

// Every so many pixels along both axes one counts roundings for Target::Auto.
constexpr std::uint32_t kMeasureStep = 4;

// Whether a buffer of the frame or mesh is longer than texel buffers or storage descriptors reach.
bool needsWideAddressing(const gpu::DeviceInfo& info, const GpuMesh& mesh) {
  // The march reads the four neighbours of a cell one by one.
  const std::uint64_t longest = std::max(std::uint64_t{4} * mesh.cellCount(), std::uint64_t{mesh.vertexCount()});
  return longest > info.largestTexelBuffer || mesh.cellCount() > 1u << gpu::kPieceBits ||
         std::uint64_t{4} * mesh.cellCount() > info.largestStorageRangeBytes;
}

// Where the addresses are forced, lists have many pieces, too.
constexpr unsigned kFewPieceBits = 10;

unsigned pieceBits(const RendererOptions& options) {
  return options.forceWideAddressing ? kFewPieceBits : gpu::kPieceBits;
}

SortVariant sortVariant(const gpu::Context& context, const RendererOptions& options) {
  return options.sortVariant.value_or(bestSortVariant(context.info()));
}

// The context, once it is known that the mesh may fit. Throws Error(Device) otherwise.
const gpu::Context& withRoomFor(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
                                CellProjection projection) {
  gpu::requireMemory(
      context,
      leastMeshBytes(mesh.cellCount(), mesh.pointCount(), field.association, projection, context.info().hasFloat64),
      fmt::format("a mesh of {} cells", mesh.cellCount()));
  return context;
}

}  // namespace

ProjectionChoice projectionFor(const RendererOptions& options) {
  if (options.projection != CellProjection::Auto) return {options.projection, "asked for", 0.0};
  return chooseProjection(options.order == Order::Auto && options.mayWalk);
}

Renderer::Renderer(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
                   const RendererOptions& options, std::unique_ptr<MarchPass> warmed)
    : context_(withRoomFor(context, mesh, field, projectionFor(options).projection)),
      mesh_(context, mesh, field, pieceBits(options)),
      wideAddressing_(options.forceWideAddressing || needsWideAddressing(context.info(), mesh_)),
      checkOrder_(options.checkOrder),
      subpixels_(options.snapVertices.value_or(!context.info().isCpu) ? context.info().subpixels : 0),
      gpuRays_(options.gpuRays.value_or(!context.info().isCpu)),
      hostMeshBytes_(mesh.sizeBytes() + field.values.size() * sizeof(double)),
      tolerance_(options.tolerance),
      doublePrecision_(options.doublePrecision),
      projection_(projectionFor(options)),
      target_(context) {
  if (projection() == CellProjection::March) {
    marchPass_ = warmed ? std::move(warmed) : std::make_unique<MarchPass>(context);
    Adjacency adjacency = makeAdjacency(mesh);
    cutFolds(mesh, adjacency);
    noteAdjacency(adjacency);
    marchStorage_ = std::make_unique<MarchStorage>(context, mesh, mesh_.space(), adjacency, pieceBits(options));
    emptySpace_ = std::make_unique<EmptySpace>(context, options.skipEmptySpace);
    return;
  }
  passes_ = std::make_unique<FramePasses>(context);
  storage_ = std::make_unique<FrameStorage>(context, mesh_.cellCount(), sortVariant(context, options), projection());
  std::optional<Adjacency> adjacency;
  if (options.checkOrder || needsVisibility(options.order)) {
    adjacency = makeAdjacency(mesh);
    noteAdjacency(*adjacency);
    visibility_ = std::make_unique<VisibilityKit>(context, *adjacency, findOverlaps(mesh, *adjacency));
  }
  order_ = makeOrder(context, {mesh, mesh_.space(), adjacency ? &*adjacency : nullptr}, options.order, options.kBuffer,
                     sortVariant(context, options), visibility_.get());
}

void Renderer::noteAdjacency(const Adjacency& adjacency) {
  hostAdjacencyBytes_ = adjacency.sizeBytes();
  // Corners of boundary faces are the one list that may be longer than the mesh's.
  if (3 * adjacency.boundary.size() > context_.info().largestTexelBuffer) wideAddressing_ = true;
}

Renderer::~Renderer() {
  if (!flights_.empty()) gpu::waitUntilIdle(context_);
}

void Renderer::setTransferFunction(const TransferFunction& transfer) {
  landFlights();
  transferFunction_ = transfer;
  prepareTransfer();
}

void Renderer::setAppearance(const Appearance& appearance, const AppearanceData& data) {
  landFlights();
  appearance_.reset();
  surfaces_.reset();
  isTransferReplaced_ = appearance.replacesTransferFunction();
  if (!appearance.isPlain()) {
    const bool isOutlined = projection() == CellProjection::Silhouette && appearance.surfaces.empty();
    if (!marchPass_ && !isOutlined)
      fail(ErrorCode::Usage,
           "--projection: found '{}' with more than a volume to show, expected march, or silhouette without surfaces",
           projectionName(projection()));
    appearance_ = std::make_unique<AppearanceBuffer>(context_, appearance, data, mesh_.space());
    CHECK_EQ(appearance.surfaces.size(), data.surfaces.size());
    if (!data.surfaces.empty()) {
      if (!surfacePass_) surfacePass_ = std::make_unique<SurfacePass>(context_);
      surfaces_ = std::make_unique<SurfaceStorage>(context_, data.surfaces, mesh_.space());
    }
  }
  if (transfer_) prepareTransfer();
}

double Renderer::largestExtinction() const {
  const auto ofTransfer = static_cast<double>(transfer_->largest());
  return appearance_ ? appearance_->largestExtinction(ofTransfer) : ofTransfer;
}

void Renderer::prepareTransfer() {
  const TransferFunction transfer = isTransferReplaced_ ? TransferFunction() : transferFunction_;
  if (!transfer_) transfer_ = std::make_unique<TransferBuffer>(context_);
  transfer_->set(transfer, mesh_.space());
  if (appearance_) appearance_->setTransfer(*transfer_);
  if (emptySpace_) emptySpace_->forget();
  hasDrawnTransfer_ = false;
  choice_.reset();
  plan_.reset();
  luminance_ = largestLuminance(transfer, space().scalarCenter - 0.5 * space().scalarRange,
                                space().scalarCenter + 0.5 * space().scalarRange);
  // Psi does not depend on it.
  if (built_ && built_->first != Integration::Ppi) built_.reset();
}

void Renderer::checkMethod(const RenderOptions& options) const {
  const auto refuse = [](const char* option, const char* found, const char* with, const char* expected) {
    fail(ErrorCode::Usage, "{}: found '{}' with {}, expected {}", option, found, with, expected);
  };
  if (transfer_->emission() == Emission::PerLength && !carriesEmissionPerLength(options.integration))
    refuse("--integration", integrationName(options.integration), "emission per length",
           "a method other than moments and ppi");
  if (options.interpolation == Interpolation::Screen &&
      (projection() == CellProjection::Silhouette || projection() == CellProjection::March))
    refuse("--interpolation", "screen", "a projection that interpolates nothing", "--projection pt or gator");
  if (appearance_ && options.integration != Integration::Exact)
    refuse("--integration", integrationName(options.integration), "more than a volume to show", "exact");
  if (tolerance_ && options.integration != Integration::Exact)
    refuse("--integration", integrationName(options.integration), "a tolerance", "exact, which has bounds");
  if (tolerance_ && options.interpolation == Interpolation::Screen)
    refuse("--interpolation", "screen", "a tolerance", "perspective");
}

void Renderer::preparePlan() {
  if (!tolerance_ || plan_) return;
  if (transfer_->emission() == Emission::PerLength) {
    plan_ = planFully(*tolerance_, "emission per length: what lies behind may be any number of times brighter");
  } else if (appearance_) {
    plan_ = planFully(*tolerance_, "more than a volume to show: no bound is known for less");
  } else {
    const double limit = kIntegrationShare * *tolerance_;
    plan_ = planTolerance(*tolerance_, luminance_, classifyCells(context_, mesh_, *transfer_, wideAddressing_, limit));
  }
  plan_->decisions.insert(plan_->decisions.begin(),
                          {"projection", projectionName(projection()), projection_.reason, projection_.figure});
}

void Renderer::prepareTables(Integration integration, const TableOptions& options) {
  if (!tables_) tables_ = std::make_unique<IntegrationTables>(context_);
  const std::pair wanted{integration, options};
  if (built_ == wanted) return;
  landFlights();
  built_.reset();
  if (tableDimensions(integration) > 0 && integration != Integration::Ppi && !lengths_)
    lengths_ = measureCellLengths(context_, mesh_, wideAddressing_);
  tables_->build(integration, options, {*transfer_, lengths_.value_or(CellLengths{})});
  built_ = wanted;
}

FrameSetup Renderer::setupOf(const Request& request) const {
  return makeFrameSetup(request.camera, request.size, mesh_.space(), mesh_.cellCount(),
                        appearance_ ? appearance_->supportCount() : transfer_->supportCount(), kCentroidKeyBits);
}

FrameInputs Renderer::inputsOf(const Request& request, const FrameSetup& setup) const {
  FrameVariant variant;
  variant.perspective = setup.perspective;
  variant.cellField = mesh_.isCellField();
  variant.nearCells = setup.nearCells;
  variant.wideAddressing = wideAddressing_;
  variant.silhouette = projection() == CellProjection::Silhouette;
  variant.gator = projection() == CellProjection::Gator;
  variant.subpixels = subpixels_;
  variant.emissionPerLength = transfer_->emission() == Emission::PerLength;
  variant.doublePrecision = usesDoublePrecision(setup);
  // Mesa's software device has as many threads as there are processors, at most 32.
  variant.dispatchThreads = context_.info().isCpu ? std::min(workerCount(), 32u) : 1;
  variant.turnRounds = gpuRays_ ? shared::MARCH_TURN_ROUNDS : shared::MARCH_LAST_ROUND;
  variant.jobLanes = gpuRays_ ? shared::MARCH_JOB_LANES : 1;
  variant.countWork = request.options.countWork;
  variant.integration = request.integration;
  variant.output = request.output;
  return {context_,
          mesh_,
          *transfer_,
          *tables_,
          setup,
          variant,
          request.camera,
          request.size,
          appearance_.get(),
          surfacePass_.get(),
          surfaces_.get(),
          request.checkOrder,
          canSkip(request) ? emptySpace_->kept() : nullptr};
}

bool Renderer::canSkip(const Request& request) const {
  return marchPass_ && request.options.integration == Integration::Exact;
}

void Renderer::skipEmptySpace(const Request& request, FrameStats& stats) {
  // What may be the only picture, and what may not be drawn with this transfer function again.
  const std::uint64_t pixels = std::uint64_t{request.size.width} * request.size.height;
  const bool waits = !hasDrawnTransfer_ && (hasDrawn_ || !isWorthOnePicture(cellCount(), pixels));
  hasDrawn_ = true;
  hasDrawnTransfer_ = true;
  if (!canSkip(request)) return;
  // Landing may draw again, and come here.
  if (!waits && !emptySpace_->isFound()) landFlights();
  if (!waits && !emptySpace_->isFound()) {
    gpu::Recorder recorder(context_, request.timing);
    emptySpace_->find(recorder, skipInputs());
    stats.frameMs += recorder.totalMs();
    stats.passes.insert(stats.passes.end(), recorder.passTimes().begin(), recorder.passTimes().end());
  }
  stats.culledTransparent = emptySpace_->cutCells();
}

SkipInputs Renderer::skipInputs() const {
  const WalkTopology& whole = marchStorage_->topology();
  if (appearance_)
    return {mesh_,          whole, appearance_->support(), appearance_->supportCount(), appearance_->showsEverywhere(),
            wideAddressing_};
  return {mesh_, whole, transfer_->support(), transfer_->supportCount(), transfer_->showsEverywhere(), wideAddressing_};
}

FrameTarget Renderer::targetOf(const Request& request) const {
  return {target_.picture(), target_.chunk(), chunkCellCount(request.options.chunkCells, mesh_.cellCount())};
}

Renderer::Drawn Renderer::drawInto(gpu::Recorder& recorder, const Request& request, const FrameTarget& target) {
  const FrameSetup setup = setupOf(request);
  const FrameInputs inputs = inputsOf(request, setup);
  Drawn drawn{{}, {}, inputs.variant.doublePrecision, setup.smallestPixel};
  if (marchPass_)
    drawn.march = marchFrame(recorder, inputs, *marchPass_, *marchStorage_, target.picture);
  else
    drawn.order = drawFrame(recorder, inputs, *passes_, *order_, *storage_, target);
  return drawn;
}

bool Renderer::usesDoublePrecision(const FrameSetup& setup) const {
  if (!marchPass_ || !context_.info().hasFloat64) return false;
  return doublePrecision_.value_or(isTooDenseForSingle(largestExtinction(), tolerance_) ||
                                   isTooFineForSingle(setup.smallestPixel));
}

Target Renderer::chooseTarget(const Request& request, FrameStats& stats) {
  if (choice_ && choice_->camera == request.camera && choice_->size == request.size &&
      choice_->integration == request.integration)
    return choice_->target;
  // Nothing is blended: rays gather light in registers, and a pixel is rounded once.
  const double limit = tolerance_ ? kRoundingShare * *tolerance_ : kHalfFloatLimit;
  if (marchPass_) return halfFloatHolds(1.0, /*roundsToNearest=*/true, limit) ? Target::Rgba16f : Target::Rgba32f;
  if (!roundsToNearest_) roundsToNearest_ = halfBlendingRoundsToNearest(context_);
  const auto part = [](std::uint32_t side) { return (side + kMeasureStep - 1) / kMeasureStep; };
  Request smaller = request;
  smaller.size = {part(request.size.width), part(request.size.height)};
  smaller.output = *roundsToNearest_ ? shared::OUTPUT_ROUNDINGS : shared::OUTPUT_TRUNCATIONS;
  smaller.checkOrder = false;
  smaller.options.countWork = false;
  TargetImages images(context_);
  images.prepare(smaller.size, Target::Rgba32f);
  gpu::Recorder recorder(context_, request.timing);
  drawInto(recorder, smaller, {images.picture()});
  double worst = 0.0;
  for (const glm::vec4& pixel : images.read().pixels) worst = std::max(worst, static_cast<double>(pixel.x));
  choice_ = {request.camera, request.size, request.integration,
             halfFloatHolds(worst, *roundsToNearest_, limit) ? Target::Rgba16f : Target::Rgba32f};
  stats.frameMs += recorder.totalMs();
  if (request.timing != gpu::PassTiming::Off) stats.passes.push_back({"measure", recorder.totalMs()});
  return choice_->target;
}

Renderer::Request Renderer::prepare(const Camera& camera, ImageSize size, const RenderOptions& options,
                                    FrameStats& stats) {
  CHECK(transfer_ != nullptr);
  checkMethod(options);
  preparePlan();
  Request request{camera, size, options};
  request.timing = options.timed ? gpu::bestTiming(context_.info()) : gpu::PassTiming::Off;
  request.integration = {options.integration, options.interpolation};
  request.checkOrder = checkOrder_;
  if (plan_) {
    request.integration.integration = plan_->integration;
    request.integration.accuracy = plan_->accuracy;
    request.integration.leastTransmittance = plan_->leastTransmittance;
    stats.plan = plan_;
  }
  prepareTables(request.integration.integration, options.table);
  request.integration.tableFetch = tables_->needsFetch();
  stats.projection = projection();
  stats.target = options.target == Target::Auto ? chooseTarget(request, stats) : options.target;
  request.output = options.constantColor                 ? shared::OUTPUT_CONSTANT
                   : stats.target == Target::Rgba8Dither ? shared::OUTPUT_DITHERED
                                                         : shared::OUTPUT_COLOR;
  skipEmptySpace(request, stats);
  stats.integration = request.integration.integration;
  stats.interpolation = options.interpolation;
  stats.tableBuild = tables_->tableBuild();
  stats.tablesMs = tables_->buildMs();
  return request;
}

void Renderer::noteDrawn(FrameStats& stats, const Drawn& drawn) const {
  stats.order = drawn.order;
  if (marchPass_) stats.order.order = Order::Exact;
  stats.doublePrecision = drawn.doublePrecision;
  if (stats.plan && marchPass_)
    stats.plan->decisions.push_back(
        {"precision", drawn.doublePrecision ? "double" : "single",
         fmt::format(
             "single precision misses crossings by {:.1g} mesh units; extinction is up to {:.3g} per mesh unit, "
             "pixels are at least {:.2g} wide",
             kCrossingRounding, largestExtinction(), drawn.smallestPixel),
         kCrossingRounding * largestExtinction()});
}

FrameStats Renderer::draw(const Camera& camera, ImageSize size, const RenderOptions& options) {
  CHECK(flights_.empty());
  FrameStats stats;
  const Request request = prepare(camera, size, options, stats);
  return draw(request, std::move(stats));
}

FrameStats Renderer::draw(const Request& request, FrameStats stats) {
  target_.prepare(request.size, stats.target);
  gpu::Recorder recorder(context_, request.timing);
  const Drawn drawn = drawInto(recorder, request, targetOf(request));
  noteDrawn(stats, drawn);
  if (marchPass_ && request.options.countWork) stats.march = drawn.march;
  shared::FrameCounters counters{};
  if (storage_) gpu::download(context_, storage_->counters, &counters, sizeof counters);
  stats.drawnCells = counters.drawn;
  stats.triangles = counters.triangles;
  stats.clippedCells = counters.clipped;
  if (projection() == CellProjection::Gator) {
    stats.triangles = std::uint64_t{counters.drawn} * (shared::FAN_INDICES / 3);
    stats.clippedCells.reset();
  }
  stats.culledOutside = counters.outside;
  stats.culledNoSample = counters.noSample;
  if (storage_) stats.culledTransparent = counters.transparent;
  stats.passes.insert(stats.passes.end(), recorder.passTimes().begin(), recorder.passTimes().end());
  stats.frameMs += recorder.totalMs();
  return stats;
}

Image Renderer::readImage(FrameStats* stats) { return target_.read(stats ? &stats->readbackMs : nullptr); }

void Renderer::begin(const Camera& camera, ImageSize size, const RenderOptions& options) {
  auto flight = spare_ ? std::move(spare_) : std::make_unique<Flight>();
  flight->stats = {};
  flight->request = prepare(camera, size, options, flight->stats);
  const FrameSetup setup = setupOf(flight->request);
  const FrameInputs inputs = inputsOf(flight->request, setup);
  // Other pictures take the place of those that are being drawn.
  if (!target_.holds(size, flight->stats.target)) landFlights();
  if (!marchPass_ || flight->request.timing != gpu::PassTiming::Off || !canRunAhead(inputs, *marchStorage_)) {
    landFlights();
    flight->stats = draw(flight->request, std::move(flight->stats));
    flight->image = readImage(&flight->stats);
    flights_.push_back(std::move(flight));
    return;
  }
  target_.prepare(size, flight->stats.target);
  if (flight->hostCounts.sizeBytes() == 0)
    flight->hostCounts =
        gpu::Buffer(context_, sizeof(shared::MarchCounts), gpu::MemoryKind::Readback, "march counts in flight");
  if (flight->readback.sizeBytes() != target_.pictureBytes()) {
    flight->readback = {};
    flight->readback = gpu::Buffer(context_, target_.pictureBytes(), gpu::MemoryKind::Readback, "picture in flight");
  }
  flight->room = marchStorage_->room();
  flight->recorder = std::make_unique<gpu::Recorder>(context_, gpu::PassTiming::Off);
  recordMarchFrame(*flight->recorder, inputs, *marchPass_, *marchStorage_, target_.picture(), flight->hostCounts);
  target_.recordRead(flight->recorder->pass("readback"), flight->readback);
  noteDrawn(flight->stats, {{}, {}, inputs.variant.doublePrecision, setup.smallestPixel});
  flight->recorder->submit();
  flights_.push_back(std::move(flight));
}

void Renderer::land(Flight& flight) {
  if (!flight.recorder) return;
  flight.recorder->wait();
  flight.stats.frameMs += flight.recorder->totalMs();
  flight.recorder.reset();
  const shared::MarchCounts& counts = flight.hostCounts.as<shared::MarchCounts>()[0];
  if (counts.unfinished == 0 && flight.room.holds(counts)) {
    flight.image = target_.unpack(flight.readback);
    return;
  }
  // More room is needed than those behind it have, or another dispatch.
  gpu::waitUntilIdle(context_);
  FrameStats stats;
  flight.request = prepare(flight.request.camera, flight.request.size, flight.request.options, stats);
  flight.stats = draw(flight.request, std::move(stats));
  flight.image = readImage(&flight.stats);
}

void Renderer::landFlights() {
  for (const std::unique_ptr<Flight>& flight : flights_) land(*flight);
}

Renderer::Finished Renderer::finish() {
  CHECK(!flights_.empty());
  land(*flights_.front());
  spare_ = std::move(flights_.front());
  flights_.pop_front();
  return {std::move(spare_->stats), std::move(spare_->image)};
}
MemoryUse Renderer::memoryUse() const {
  MemoryUse use;
  use.meshBytes = mesh_.sizeBytes();
  const std::uint64_t skipBytes = emptySpace_ ? emptySpace_->sizeBytes() : 0;
  use.frameBytes = (storage_ ? storage_->sizeBytes() : marchStorage_->sizeBytes() + skipBytes) + target_.sizeBytes();
  use.orderBytes = (order_ ? order_->sizeBytes() : 0) + (visibility_ ? visibility_->sizeBytes() : 0);
  use.topologyBytes = marchStorage_ ? marchStorage_->topology().sizeBytes() + skipBytes
                                    : (visibility_ ? visibility_->topology.sizeBytes() : 0);
  use.cellOrderBytes = use.orderBytes + (storage_ ? storage_->sort.sizeBytes() - use.topologyBytes : 0);
  use.pictureBytes = use.frameBytes - (storage_ ? storage_->sort.sizeBytes() : use.topologyBytes);
  use.hostMeshBytes = hostMeshBytes_;
  use.hostAdjacencyBytes = hostAdjacencyBytes_;
  use.budget = context_.memoryBudget();
  use.tableBytes = (transfer_ ? transfer_->sizeBytes() : 0) + (tables_ ? tables_->sizeBytes() : 0) +
                   (appearance_ ? appearance_->sizeBytes() : 0) + (surfaces_ ? surfaces_->sizeBytes() : 0);
  return use;
}

}  // namespace tetralux::render
