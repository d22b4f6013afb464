// Options that several commands have.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "cli/appearance_options.h"
#include "gpu/context.h"
#include "render/renderer.h"
#include "view/camera.h"

namespace tetralux::cli {

// --size, --camera, --field, --tf, --opacity-scale and those of AppearanceOptions: what is drawn.
struct SceneOptions {
  std::string size;  // "WxH"
  std::string cameraFile;
  std::string field;
  std::string transfer;       // file or preset
  double opacityScale = 1.0;  // multiplies every extinction, > 0
  AppearanceOptions appearance;

  void add(CLI::App& app);
  void addTransfer(CLI::App& app);  // --field and --tf alone
};

// --device, --validate, --target, --order, --k: what it is drawn on, and how.
struct DeviceOptions {
  std::string device;
  bool validate = false;
  std::string target = "rgba32f";
  std::uint32_t chunkCells = 0;
  std::string forcePath;
  std::string projection = "auto";
  std::string order = "auto";
  std::uint32_t kBuffer = 6;
  std::string integration = "exact";
  std::string interpolation = "perspective";
  std::string tolerance;    // empty: none
  std::string tableSize;    // empty: the method's
  std::string tableFormat;  // empty: the method's
  std::string tableBuild = "exact";

  void add(CLI::App& app);
  // Parts of add() for commands that draw nothing.
  void addDevice(CLI::App& app);  // --device and --validate
  void addTable(CLI::App& app);   // --table-size, --table-format, --table-build
  gpu::ContextOptions contextOptions() const;
  render::RendererOptions rendererOptions() const;
  // Everything that is chosen per frame; not timed. Throws Error(Usage).
  render::RenderOptions renderOptions() const;
  render::TableOptions tableOptions() const;
  // Throws Error(Usage).
  std::optional<double> toleranceValue() const;
};

// --quiet: no progress, no log lines below errors.
void addQuiet(CLI::App& app);

// Parses an error, "0.002" or "1/510", above 0 and at most 1. Throws Error(Usage).
double parseTolerance(const std::string& text);

// Parses "WxH". Throws Error(Usage).
ImageSize parseSize(const std::string& text);

// Throws Error(Device) when validation reported anything since the last call.
void failOnValidationMessages();

}  // namespace tetralux::cli
