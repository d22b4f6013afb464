#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/load_scene.h"
#include "cli/write_image.h"
#include "render/integration/integration_tables.h"
#include "scene/transfer_file.h"

namespace tetralux::cli {
namespace {

// Names of tables; psi is what --integration ppi looks into.
const std::vector<std::string>& tableKinds() {
  static const std::vector<std::string> kinds = {"psi", "opacity2d", "preint2d", "preint3d", "preint3d-log"};
  return kinds;
}

class TableCommand : public Command {
 public:
  explicit TableCommand(CLI::App& app) {
    app.add_option("kind", kind_, "Which table")->required()->check(CLI::IsMember(tableKinds()));
    app.add_option("-o,--output", output_,
                   "EXR to write: first axis to the right, second downwards, slices of the third side by side; with "
                   "emission per length, light is per world unit of the segment")
        ->required()
        ->type_name("FILE.exr");
    app.add_option("--scene", scene_,
                   "Scene or mesh whose transfer function, range of scalars and cell sizes the table is made for")
        ->type_name("SCENE|MESH");
    app.add_option(
           "--length", length_,
           "Largest thickness, or the one of preint2d, world units (default: the scene's cells' longest edge or "
           "mean thickness; 1 without a scene)")
        ->check(CLI::PositiveNumber);
    sceneOptions_.addTransfer(app);
    deviceOptions_.addDevice(app);
    deviceOptions_.addTable(app);
    exrOptions_.add(app);
    addQuiet(app);
  }

  int run() override {
    checkImageName(output_, /*pngAllowed=*/false);
    const render::Integration integration = kind_ == "psi" ? render::Integration::Ppi : render::parseIntegration(kind_);
    const render::TableOptions options = deviceOptions_.tableOptions();
    ExrOptions exr = exrOptions_.exrOptions();
    if (integration != render::Integration::Ppi && scene_.empty() && sceneOptions_.transfer.empty())
      fail(ErrorCode::Usage, "table {}: neither --scene nor --tf, expected one of them", kind_);

    Scene scene;
    render::MeshSpace space;
    std::optional<LoadedScene> loaded;
    if (!scene_.empty()) {
      loaded = loadScene(scene_, sceneOptions_);
      scene = loaded->scene;
      space = render::makeMeshSpace(loaded->mesh, loaded->field);
    } else if (!sceneOptions_.transfer.empty()) {
      scene.transferFunction = transferAlone().scaled(sceneOptions_.opacityScale);
      const auto& points = scene.transferFunction.points();
      space.scalarCenter = 0.5 * points.front().s + 0.5 * points.back().s;
      if (points.back().s > points.front().s) space.scalarRange = points.back().s - points.front().s;
    }
    const gpu::Context context(deviceOptions_.contextOptions());
    render::CellLengths lengths;
    if (loaded) {
      // By address, which reaches meshes of every size.
      const render::GpuMesh mesh(context, loaded->mesh, loaded->field);
      lengths = render::measureCellLengths(context, mesh, /*wideAddressing=*/true);
    }
    if (length_ > 0.0) lengths.longest = lengths.mean = static_cast<float>(length_ / space.scale);

    const render::TransferBuffer transfer(context, scene.transferFunction, space);
    render::IntegrationTables tables(context);
    tables.build(integration, options, {transfer, lengths});
    std::vector<glm::vec4> entries = tables.read();
    if (render::tableChannels(integration) == 4 && transfer.emission() == Emission::PerLength) {
      for (glm::vec4& entry : entries) entry = glm::vec4(glm::vec3(entry) / static_cast<float>(space.scale), entry.w);
    }
    const Image image = sideBySide(entries, tables.extent());
    failOnValidationMessages();
    const bool isMean = integration == render::Integration::Preint2d;
    exr.attributes = {{"tetralux.version", versionString()},
                      {"tetralux.table", kind_},
                      {"tetralux.scalars", fmt::format("{} {}", space.scalarCenter - 0.5 * space.scalarRange,
                                                       space.scalarCenter + 0.5 * space.scalarRange)},
                      {"tetralux.length",
                       fmt::format("{}", static_cast<double>(isMean ? lengths.mean : lengths.longest) * space.scale)}};
    writeExr(image, output_, exr);
    return 0;
  }

 private:
  // A preset has scalars from 0 to 1 and weights for extinctions.
  TransferFunction transferAlone() const {
    if (const auto preset = transferPreset(sceneOptions_.transfer))
      return TransferFunction(*preset, sceneOptions_.transfer);
    return readTransferFunction(sceneOptions_.transfer);
  }

  static Image sideBySide(const std::vector<glm::vec4>& entries, const gpu::ImageExtent& extent) {
    const std::uint32_t slices = std::max(extent.depth, 1u);
    Image image(extent.width * slices, extent.height);
    for (std::uint32_t z = 0; z < slices; z++) {
      for (std::uint32_t y = 0; y < extent.height; y++) {
        const glm::vec4* row = entries.data() + (size_t{z} * extent.height + y) * extent.width;
        std::copy_n(row, extent.width, &image.at(z * extent.width, y));
      }
    }
    return image;
  }

  std::string kind_;
  std::string output_;
  std::string scene_;
  double length_ = 0.0;  // 0: not given
  SceneOptions sceneOptions_;
  DeviceOptions deviceOptions_;
  ExrFormatOptions exrOptions_;
};

}  // namespace

std::unique_ptr<Command> makeTableCommand(CLI::App& app) { return std::make_unique<TableCommand>(app); }

}  // namespace tetralux::cli
