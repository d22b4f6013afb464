#include "render/appearance_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "render/surface_points.h"
#include "shared/spec_ids.h"

namespace tetralux::render {
namespace {

constexpr size_t kGrain = 1 << 16;

// Texels of all vertices; no buffer where nothing uses them.
template <typename Texel>
gpu::Buffer makeVertexTexels(const gpu::Context& context, size_t vertices, const char* name, const Texel& texel) {
  if (vertices == 0) return {};
  if (vertices > context.info().largestTexelBuffer)
    fail(ErrorCode::Device, "{} of {} points do not fit this device, whose texel buffers hold {}", name, vertices,
         context.info().largestTexelBuffer);
  return gpu::makeBuffer<glm::vec4>(context, vertices, name, [&](std::span<glm::vec4> texels, size_t first) {
    parallelFor(texels.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
      for (size_t i = begin; i < end; i++) texels[i] = texel(first + i);
    });
  });
}

// Directions in mesh space, in units of the longest: whatever the field's unit, single precision holds them.
gpu::Buffer makeGradientBuffer(const gpu::Context& context, const std::vector<glm::dvec3>& gradients) {
  double longest = 0.0;
  for (const glm::dvec3& g : gradients) longest = std::max(longest, glm::length(g));
  const double scale = longest > 0.0 ? 1.0 / longest : 1.0;
  return makeVertexTexels(context, gradients.size(), "vertex gradients",
                          [&](size_t i) { return glm::vec4(scale * gradients[i], 0.0f); });
}

gpu::Buffer makeNumberBuffer(const gpu::Context& context, const AppearanceNumbers& numbers) {
  size_t vertices = 0;
  for (const std::vector<double>* values : numbers.values) vertices = std::max(vertices, values ? values->size() : 0);
  return makeVertexTexels(context, vertices, "vertex numbers", [&](size_t vertex) {
    glm::vec4 texel(0.0f);
    for (int kind = 0; kind < 3; kind++) {
      const auto k = static_cast<size_t>(kind);
      if (numbers.values[k]) texel[kind] = numbers.ranges[k].normalized((*numbers.values[k])[vertex]);
    }
    return texel;
  });
}

gpu::Buffer makeColorBuffer(const gpu::Context& context, const std::vector<glm::dvec4>& rgba, const MeshSpace& space) {
  return makeVertexTexels(context, rgba.size(), "vertex colors", [&](size_t i) {
    return glm::vec4(glm::dvec4(glm::dvec3(rgba[i]), rgba[i].w * space.scale));
  });
}

gpu::SpecConstants listConstants(const Appearance& appearance, const AppearanceNumbers& numbers) {
  const auto count = [](size_t n) { return static_cast<std::uint32_t>(n); };
  const auto points = [&](ModulatedBy by) {
    const FactorCurve* curve = numbers.curves[static_cast<size_t>(by)];
    return curve ? count(curve->points().size()) : 0u;
  };
  const bool isLit = appearance.volumeShading == Shading::Phong;
  const auto& transfer2d = appearance.transfer2d;
  const bool isClassified = isLit || !appearance.modulations.empty() || appearance.rgbaField || transfer2d;
  return {{SPEC_CLIP_PLANES, count(appearance.clip.size())},
          {SPEC_LIGHTS, count(appearance.lighting.lights.size())},
          {SPEC_HEAD_LIGHT, appearance.lighting.headLight},
          {SPEC_ISOSURFACES, !appearance.isosurfaces.empty()},
          {SPEC_ISOSURFACE_COUNT, count(appearance.isosurfaces.size())},
          {SPEC_VOLUME, appearance.volumeVisible},
          {SPEC_RAY_ENDS, !appearance.surfaces.empty()},
          {SPEC_CLASSIFIED, appearance.volumeVisible && isClassified},
          {SPEC_LIT_VOLUME, isLit},
          {SPEC_VERTEX_COLORS, appearance.rgbaField.has_value()},
          {SPEC_CURVE_MAGNITUDE, points(ModulatedBy::GradientMagnitude)},
          {SPEC_CURVE_BOUNDARY, points(ModulatedBy::BoundaryDistance)},
          {SPEC_CURVE_FIELD, points(ModulatedBy::Field)},
          {SPEC_CURVE_COSINE, points(ModulatedBy::ViewCosine)},
          {SPEC_TRANSFER_COLUMNS, transfer2d ? count(transfer2d->scalars().size()) : 0u},
          {SPEC_TRANSFER_ROWS, transfer2d ? count(transfer2d->gradients().size()) : 0u}};
}

}  // namespace

AppearanceBuffer::AppearanceBuffer(const gpu::Context& context, const Appearance& appearance,
                                   const AppearanceData& data, const MeshSpace& space)
    : context_(context), clip_(appearance.clip), space_(space) {
  const AppearanceNumbers numbers = listNumbers(appearance, data);
  constants_ = listConstants(appearance, numbers);
  texelBuffer_ = gpu::makeBuffer(context, listAppearanceTexels(appearance, numbers, space), "appearance texels");
  gradientBuffer_ = makeGradientBuffer(context, data.gradients);
  numberBuffer_ = makeNumberBuffer(context, numbers);
  colorBuffer_ = makeColorBuffer(context, data.rgba, space);
  texelView_ = gpu::TexelView(context, texelBuffer_, VK_FORMAT_R32G32B32A32_SFLOAT);
  const auto view = [&](const gpu::Buffer& buffer) {
    // A binding needs a view, used or not.
    return gpu::TexelView(context, buffer.sizeBytes() > 0 ? buffer : texelBuffer_, VK_FORMAT_R32G32B32A32_SFLOAT);
  };
  gradientView_ = view(gradientBuffer_);
  numberView_ = view(numberBuffer_);
  colorView_ = view(colorBuffer_);
  for (const Isosurface& surface : appearance.isosurfaces) isovalues_.push_back(space.scalar(surface.value));

  replacesTransfer_ = appearance.volumeVisible && (appearance.rgbaField || appearance.transfer2d);
  for (const glm::dvec4& color : data.rgba) ownExtinction_ = std::max(ownExtinction_, color.w * space.scale);
  if (appearance.transfer2d) ownExtinction_ = appearance.transfer2d->largestExtinction() * space.scale;
  for (const Modulation& modulation : appearance.modulations) {
    double largest = 0.0;
    for (const FactorPoint& point : modulation.curve.points()) largest = std::max(largest, point.factor);
    largestFactor_ *= largest;
  }
}

double AppearanceBuffer::largestExtinction(double ofTransferFunction) const {
  return largestFactor_ * (replacesTransfer_ ? ownExtinction_ : ofTransferFunction);
}

void AppearanceBuffer::setTransfer(const TransferBuffer& transfer) {
  const SurfacePoints points = insertIsovalues(transfer.pointTexels(), transfer.pointScalarTexels(), isovalues_);
  std::vector<glm::vec4> support = transfer.supportIntervals();
  constexpr float kEverywhere = 1e30f;
  if (replacesTransfer_) support.assign(1, {-kEverywhere, kEverywhere, 0.0f, 0.0f});
  for (const float value : isovalues_)
    support.emplace_back(std::nextafter(value, -kEverywhere), std::nextafter(value, kEverywhere), 0.0f, 0.0f);
  supportCount_ = static_cast<std::uint32_t>(support.size());
  showsEverywhere_ = coversField(support);
  if (support.empty()) support.emplace_back(0.0f);
  constexpr VkFormat kFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
  const std::array<gpu::TableView, 3> views = {{{&pointView_, kFormat, gpu::bytesOf(points.points)},
                                                {&pointScalarView_, kFormat, gpu::bytesOf(points.scalars)},
                                                {&supportView_, kFormat, gpu::bytesOf(support)}}};
  transferTables_.set(context_, views, "walk points");
}

void AppearanceBuffer::recordCamera(gpu::CommandBuffer& commands, const Camera& camera) const {
  if (clip_.empty()) return;
  const glm::dmat3 rotation = camera.viewRotation();
  std::vector<glm::vec4> planes;
  for (const ClipPlane& plane : clip_) {
    const double length = glm::length(plane.normal);
    const glm::dvec3 normal = plane.normal / length;
    planes.emplace_back(rotation * normal, (glm::dot(normal, camera.eye) - plane.offset / length) / space_.scale);
  }
  commands.update(texelBuffer_, planes.data(), planes.size() * sizeof(glm::vec4));
}

std::uint64_t AppearanceBuffer::sizeBytes() const {
  std::uint64_t bytes = transferTables_.sizeBytes();
  for (const gpu::Buffer* buffer : {&texelBuffer_, &gradientBuffer_, &numberBuffer_, &colorBuffer_})
    bytes += buffer->sizeBytes();
  return bytes;
}

}  // namespace tetralux::render
