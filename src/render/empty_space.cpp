#include "render/empty_space.h"

#include "base/error.h"

namespace tetralux::render {
namespace {

// What it takes a ray to come back into the mesh, in steps from cell to cell: jobs, lists and their order, vertices of
// a face, and neighbours in a subgroup that wait. Measured on lavapipe with 26 scenes: where a return saves 20 steps,
// cutting costs 28 % of the frame, at 36 10 %; from 54 on it gains, at 60 a third, and up to four fifths.
constexpr std::uint64_t kStepsPerReturn = 45;

// Meshes with more cells per pixel of the picture are drawn once before they are searched.
constexpr std::uint64_t kCellsPerPixel = 4;

// Less than this share of the cells is not worth a second topology.
constexpr std::uint64_t kLeastShare = 16;

}  // namespace

bool paysToCut(std::uint64_t cells, std::uint64_t faces, std::uint64_t keptCells, std::uint64_t keptFaces) {
  const std::uint64_t cut = cells - keptCells;
  if (cut * kLeastShare < cells) return false;
  // A ray that meets a cell goes through two of its four faces; a boundary face it meets from outside every other time.
  const std::uint64_t returns = keptFaces > faces ? keptFaces - faces : 0;
  return 4 * cut >= kStepsPerReturn * returns;
}

bool isWorthOnePicture(std::uint64_t cells, std::uint64_t pixels) { return cells <= kCellsPerPixel * pixels; }

void EmptySpace::forget() {
  isFound_ = false;
  isCut_ = false;
}

void EmptySpace::find(gpu::Recorder& recorder, const SkipInputs& inputs) {
  isFound_ = true;
  if (inputs.showsEverywhere || forced_ == false) return;
  const std::uint32_t cells = inputs.mesh.cellCount();
  if (!pass_) pass_.emplace(context_, cells);
  pass_->recordMark(recorder.pass("skip"), inputs);
  recorder.sync();
  const shared::SkipCounts counts = pass_->counts();
  if (!forced_.value_or(paysToCut(cells, inputs.whole.boundaryCount(), counts.cells, counts.faces))) return;
  kept_.reset();
  const gpu::MemoryBudget budget = context_.memoryBudget();
  const std::uint64_t needed = WalkTopology::bytesFor(cells, counts.faces);
  if (budget.isReported && needed > budget.availableBytes) return;
  try {
    kept_.emplace(context_, cells, counts.faces, inputs.whole.pieceBits());
  } catch (const Error&) {
    return;  // no memory for it, whatever the budget said: rays can do with the whole mesh
  }
  pass_->recordEnclose(recorder.pass("skip"), inputs, *kept_);
  recorder.sync();
  cutCells_ = cells - counts.cells;
  isCut_ = true;
}

std::uint64_t EmptySpace::sizeBytes() const {
  return (pass_ ? pass_->sizeBytes() : 0) + (kept_ ? kept_->sizeBytes() : 0);
}

}  // namespace tetralux::render
