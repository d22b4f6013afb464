// How light is integrated through a cell: the methods, and the forms of their tables.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gpu/pipeline.h"
#include "gpu/sampled_image.h"

namespace tetralux::render {

// docs/integration.md tells what each assumes and where it errs.
enum class Integration {
  Exact,           // the walk over the transfer function's pieces
  Moments,         // exact opacity, light from two moments of the luminance in optical depth
  Linear,          // exact for optics that are linear between the segment's ends
  Ppi,             // the same by a table: Moreland and Angel 2004
  Average,         // the mean scalar classified: Marroquim et al. 2008, basic variant
  Vertex,          // colours at the fan's vertices: Shirley and Tuchman 1990
  Opacity2d,       // opacity by a table: Stein, Becker and Max 1994
  Preint2d,        // pre-integrated for the mean thickness: Roettger, Kraus and Ertl 2000, section 4
  Preint3d,        // pre-integrated: the same, section 3
  Preint3dLog,     // logarithmic axis of thickness: Kraus, Qiao and Ebert 2004, equation 1
  Preint3dOctave,  // the same entries with a coordinate that is linear between them
};

// What is interpolated over a fan's triangles.
enum class Interpolation {
  Perspective,  // what is linear in space: Kraus, Qiao and Ebert 2004, section 2.2
  Screen,       // scalars and thickness linearly on the screen, as before
};

enum class TableFormat { Unorm8, Unorm16, F16, F32 };

// How the entries of a three-dimensional table are made.
enum class TableBuild {
  Exact,        // each by itself
  Incremental,  // slice by slice from those before: Weiler et al. 2003, Kraus, Qiao and Ebert 2004
};

// Names on the command line and in statistics; parsing throws Error(Usage).
const std::vector<std::string>& integrationNames();
const char* integrationName(Integration integration);
Integration parseIntegration(const std::string& name);
const std::vector<std::string>& interpolationNames();
const char* interpolationName(Interpolation interpolation);
Interpolation parseInterpolation(const std::string& name);
const std::vector<std::string>& tableFormatNames();
const char* tableFormatName(TableFormat format);
TableFormat parseTableFormat(const std::string& name);
const std::vector<std::string>& tableBuildNames();
const char* tableBuildName(TableBuild build);
TableBuild parseTableBuild(const std::string& name);

// Whether a method integrates emission per length. Moments has luminance over optical depth, which is not there without
// extinction; Ppi's table has Psi but not X (volume/optical_model.h).
bool carriesEmissionPerLength(Integration integration);

// 2 or 3 for a method that looks into a table of so many dimensions, 0 for the others.
int tableDimensions(Integration integration);

// Numbers per entry: 1 or 4.
int tableChannels(Integration integration);

// What a table is made of; what is left open is chosen by method.
struct TableOptions {
  // Entries along each axis, 2 or more: of the first, the second (that of the first if 0), the third (the method's own
  // if 0). All 0: psi 512 x 512, opacity2d and preint2d 256 x 256, the three-dimensional ones 128 x 128 x 32.
  std::array<std::uint32_t, 3> size = {0, 0, 0};
  // Default: unorm16. Values are scaled to its range.
  std::optional<TableFormat> format;
  // The shader interpolates, even where the device can: fractions then have all their digits.
  bool forceFetch = false;

  TableBuild build = TableBuild::Exact;  // of tables of three dimensions

  bool operator==(const TableOptions&) const = default;
};

// Parses "N", "NxM" or "NxMxL". Throws Error(Usage) unless every number is from 2 to 4096.
std::array<std::uint32_t, 3> parseTableSize(const std::string& text);

// Size of a method's table. The method must have one.
gpu::ImageExtent tableExtent(Integration integration, const TableOptions& options);

VkFormat imageFormat(TableFormat format, int channels);

// By which polynomials the exact method integrates its parts.
enum class PartAccuracy { Full, Fine, Medium, Coarse };
const char* partAccuracyName(PartAccuracy accuracy);
// Largest errors of a part's opacity, and of V = Psi - zeta, relative to the opacity.
struct PartError {
  double opacity;
  double moment;
};
PartError partError(PartAccuracy accuracy);

// exp(-16): what lies behind is below a rounding error.
inline constexpr float kLeastTransmittance = 1.1e-7f;

// What the shaders that draw segments are specialised for.
struct IntegrationVariant {
  Integration integration = Integration::Exact;
  Interpolation interpolation = Interpolation::Perspective;
  bool tableFetch = false;  // the shader interpolates between the table's entries
  PartAccuracy accuracy = PartAccuracy::Full;
  float leastTransmittance = kLeastTransmittance;  // what lies behind it is left out

  gpu::SpecConstants specConstants() const;
  auto operator<=>(const IntegrationVariant&) const = default;
};

}  // namespace tetralux::render
