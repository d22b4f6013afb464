// The regions where methods fail: what is drawn there.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"
#include "stability/segments.h"
#include "view/camera.h"
#include "volume/transfer_function.h"

namespace tetralux::stability {

// A picture of a mesh's preferred field.
struct PictureCase {
  std::string name;  // within the region
  TetMesh mesh;
  TransferFunction transfer;
  Camera camera;
  ImageSize size{48, 36};
};

// Segments alone, without a mesh.
struct SegmentCase {
  std::string name;
  TransferFunction transfer;
  std::vector<Segment> segments;
};

struct RegionCases {
  std::vector<PictureCase> pictures;
  std::vector<SegmentCase> segments;
};

struct Region {
  std::string name;                    // in tables and on the command line; no comma
  std::string what;                    // one line for the reader
  std::function<RegionCases()> cases;  // made when they are needed; the same on every machine
};

// All regions, in the order of the map.
const std::vector<Region>& regions();

// The parts of that list, by what is extreme.
std::vector<Region> segmentRegions();
std::vector<Region> scalarRegions();
std::vector<Region> shapeRegions();
std::vector<Region> placeRegions();
std::vector<Region> viewRegions();

}  // namespace tetralux::stability
