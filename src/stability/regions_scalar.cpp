// Extreme scalars, extinctions and transfer functions on an ordinary mesh.
#include <cmath>

#include "mesh/generate.h"
#include "stability/parts.h"

namespace tetralux::stability {
namespace {

RegionCases depths(std::initializer_list<double> exponents) {
  RegionCases cases;
  for (const double exponent : exponents) {
    TetMesh mesh = unitMesh();
    const Camera camera = outside(mesh);
    cases.pictures.push_back(picture("depth 1e" + std::to_string(static_cast<int>(exponent)), std::move(mesh), camera,
                                     std::pow(10.0, exponent)));
  }
  return cases;
}

RegionCases range(double low, double high) {
  TetMesh mesh = withRange(unitMesh(), low, high);
  RegionCases cases;
  for (const Camera& camera : {outside(mesh), inside(mesh)}) cases.pictures.push_back(picture("range", mesh, camera));
  return cases;
}

// About 1 such scalars would have no more than 4500 values in double precision, and no exact picture.
RegionCases narrowRanges() {
  RegionCases cases = range(0.0, 1e-12);
  for (PictureCase& c : range(1e-5, 1e-5 + 1e-12).pictures) cases.pictures.push_back(std::move(c));
  return cases;
}

RegionCases wideRanges() { return range(-5e11, 5e11); }

RegionCases constantField() {
  TetMesh mesh = withRange(unitMesh(), 0.25, 0.25);
  const Camera camera = outside(mesh);
  const TransferFunction slope({{0.0, {1, 0.2, 0}, 0.0}, {1.0, {0, 0.6, 1}, 8.0}}, "slope");
  const TransferFunction step({{0.25, {1, 0.2, 0}, 0.0}, {0.25, {0, 0.6, 1}, 3.0}}, "step");
  return {{{"on a slope", mesh, slope, camera}, {"on a step", mesh, step, camera}}, {}};
}

RegionCases steps() {
  std::vector<ControlPoint> points;
  for (int i = 0; i <= 8; i++) {
    const double s = i / 8.0;
    const bool odd = i % 2 != 0;
    points.push_back({s, {odd ? 1.0 : 0.1, 0.5, odd ? 0.0 : 0.9}, odd ? 4.0 : 0.2});
    points.push_back({s, {odd ? 0.1 : 1.0, 0.5, odd ? 0.9 : 0.0}, odd ? 0.2 : 4.0});
  }
  const TransferFunction transfer(points, "steps");
  const TetMesh mesh = unitMesh();
  return {{{"outside", mesh, transfer, outside(mesh)}, {"inside", mesh, transfer, inside(mesh)}}, {}};
}

// Four peaks, each 1e-4 of the range wide and of an optical depth of about 1 where a ray crosses it.
RegionCases narrowPeaks() {
  std::vector<ControlPoint> points;
  for (const double s : {0.2, 0.4, 0.6, 0.8}) {
    points.push_back({s - 5e-5, {0.9, 0.4 + 0.5 * s, s}, 0.0});
    points.push_back({s, {0.9, 0.4 + 0.5 * s, s}, 3e4});
    points.push_back({s + 5e-5, {0.9, 0.4 + 0.5 * s, s}, 0.0});
  }
  const TransferFunction transfer(points, "peaks");
  const TetMesh mesh = unitMesh();
  return {{{"outside", mesh, transfer, outside(mesh)}, {"inside", mesh, transfer, inside(mesh)}}, {}};
}

// Light per unit of length, without any extinction and with some.
RegionCases emissionPerLength() {
  RegionCases cases;
  const TetMesh mesh = unitMesh();
  const auto add = [&](const char* name, double light, double extinction) {
    const TransferFunction glow({{0.0, {0.0, 0.2 * light, light}, extinction},
                                 {0.4, {light, 0.0, 0.1 * light}, 0.0},
                                 {0.6, {0.3 * light, light, 0.0}, 0.5 * extinction},
                                 {1.0, {0.0, 0.0, light}, 0.1 * extinction}},
                                "glow", Emission::PerLength);
    cases.pictures.push_back({std::string(name) + ", outside", mesh, glow, outside(mesh)});
    cases.pictures.push_back({std::string(name) + ", inside", mesh, glow, inside(mesh)});
  };
  add("light alone", 0.7, 0.0);
  add("ordinary", 2.0, 3.0);
  return cases;
}

}  // namespace

std::vector<Region> scalarRegions() {
  return {{"thin", "extinction times length from 1e-8 to 1e-2",
           [] {
             return depths({-8, -5, -2});
           }},
          {"dense", "extinction times length from 1e2 to 1e8",
           [] {
             return depths({2, 5, 8});
           }},
          {"narrow range", "scalars that differ by 1e-12, about 0 and about 1e-5", narrowRanges},
          {"wide range", "scalars over a range of 1e12", wideRanges},
          {"constant field", "one scalar everywhere, on a slope and on a step", constantField},
          {"steps", "a transfer function of steps", steps},
          {"narrow peaks", "peaks 1e-4 of the range wide", narrowPeaks},
          {"emission per length", "light per unit of length, with and without extinction", emissionPerLength}};
}

}  // namespace tetralux::stability
