#include "cli/chart_scene.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/default_transfer.h"
#include "cli/write_image.h"
#include "mesh/generate.h"
#include "reference/ray_caster.h"

namespace tetralux::cli {
namespace {

// Size of pictures of generated meshes, when none is asked for; pixels.
constexpr ImageSize kGeneratedSize{512, 512};

class Fnv1a {
 public:
  void add(const void* data, size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (size_t i = 0; i < size; i++) hash_ = (hash_ ^ bytes[i]) * 0x100000001b3u;
  }
  template <typename T>
  void addAll(const std::vector<T>& values) {
    add(values.data(), values.size() * sizeof(T));
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

LoadedScene generate(const ChartScene& scene, const SceneOptions& options) {
  LoadedScene loaded;
  loaded.scene.size = options.size.empty() ? kGeneratedSize : parseSize(options.size);
  loaded.scene.meshPath = scene.name;
  loaded.mesh = hydrogenOrbital(scene.generatedCells, /*seed=*/1);
  loaded.field = scalarField(loaded.mesh, "", scene.name);
  loaded.scene.fieldName = loaded.field.name;
  loaded.scene.transferFunction = defaultTransfer(loaded.mesh, loaded.field, "");
  std::vector<glm::dvec3> points(loaded.mesh.pointCount());
  for (size_t i = 0; i < points.size(); i++) points[i] = loaded.mesh.point(i);
  loaded.scene.camera = framingCamera(points, loaded.scene.size);
  return loaded;
}

std::optional<std::uint64_t> countAttribute(const std::filesystem::path& path, const char* name) {
  const auto text = readExrAttribute(path, name);
  std::uint64_t value = 0;
  if (!text || std::from_chars(text->data(), text->data() + text->size(), value).ec != std::errc()) return std::nullopt;
  return value;
}

}  // namespace

std::string contentHash(std::string_view bytes) {
  Fnv1a hash;
  hash.add(bytes.data(), bytes.size());
  return hash.text();
}

std::string sceneHash(const LoadedScene& loaded) {
  Fnv1a hash;
  std::visit([&](const auto& points) { hash.addAll(points); }, loaded.mesh.points);
  hash.addAll(loaded.mesh.cells);
  hash.addAll(loaded.field.values);
  // Numbers as text: structures have gaps between their members.
  const Camera& c = loaded.scene.camera;
  std::string text =
      fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", static_cast<int>(c.projection), c.eye.x, c.eye.y, c.eye.z,
                  c.center.x, c.center.y, c.center.z, c.up.x, c.up.y, c.up.z, c.fovyDegrees, c.heightWorld);
  const TransferFunction& transfer = loaded.scene.transferFunction;
  text += fmt::format(" {}", static_cast<int>(transfer.emission()));
  for (const ControlPoint& p : transfer.points())
    text += fmt::format(" {} {} {} {} {}", p.s, p.rgb.x, p.rgb.y, p.rgb.z, p.tau);
  hash.add(text.data(), text.size());
  return hash.text();
}

LoadedChartScene::LoadedChartScene(const ChartScene& scene, const SceneOptions& options, std::filesystem::path folder)
    : name_(scene.name),
      folder_(std::move(folder)),
      loaded_(scene.path.empty() ? generate(scene, options) : loadScene(scene.path, options)),
      hash_(sceneHash(loaded_)) {
  // Most of what a chart compares cannot draw it.
  if (!loaded_.scene.appearance.isPlain())
    fail(ErrorCode::Usage, "{}: found more than a volume to show, expected a scene with a transfer function alone",
         scene.path);
}

const ExactPicture& LoadedChartScene::exactPicture() {
  if (exact_) return *exact_;
  const ImageSize size = loaded_.scene.size;
  const auto path = folder_ / fmt::format("{}-{}x{}-{}.exr", name_, size.width, size.height, hash_.substr(0, 8));
  exact_ = readExact(path);
  if (!exact_) exact_ = renderExact(path);
  return *exact_;
}

std::optional<ExactPicture> LoadedChartScene::readExact(const std::filesystem::path& path) const {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const auto segments = countAttribute(path, "tetralux.segments");
  const auto pieces = countAttribute(path, "tetralux.pieces");
  if (!segments || !pieces || readExrAttribute(path, "tetralux.scene") != hash_) return std::nullopt;
  return ExactPicture{readExr(path), *segments, *pieces};
}

ExactPicture LoadedChartScene::renderExact(const std::filesystem::path& path) const {
  const Scene& scene = loaded_.scene;
  const auto pixels =
      reference::renderPixels({loaded_.mesh, loaded_.field, scene.transferFunction, scene.camera, scene.size});
  ExactPicture exact;
  exact.image = reference::toImage(pixels, scene.size);
  for (const reference::ReferencePixel& pixel : pixels) {
    exact.segments += pixel.layers;
    exact.pieces += pixel.pieces;
  }
  ExrOptions exr;
  exr.attributes = {{"tetralux.version", versionString()},
                    {"tetralux.method", "reference"},
                    {"tetralux.scene", hash_},
                    {"tetralux.segments", fmt::format("{}", exact.segments)},
                    {"tetralux.pieces", fmt::format("{}", exact.pieces)}};
  writeExr(exact.image, path, exr);
  return exact;
}

}  // namespace tetralux::cli
