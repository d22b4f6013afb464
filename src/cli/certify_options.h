// --certify: a picture's error, measured.
#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"
#include "reference/picture_check.h"

namespace tetralux::cli {

// --certify N, --certify-tolerance E
struct CertifyOptions {
  std::uint32_t count = 0;             // pixels recomputed; 0: none
  std::optional<double> ownTolerance;  // --certify-tolerance
  double tolerance = 1.0 / 510.0;

  void add(CLI::App& app);
  // Settles what a picture is held to: its own tolerance, or else the one that it is drawn with, or else 1/510.
  void settle(std::optional<double> drawnWith) { tolerance = ownTolerance.value_or(drawnWith.value_or(tolerance)); }
};

// The certificates of a sequence of pictures.
class Certifier {
 public:
  explicit Certifier(const CertifyOptions& options) : options_(options) {}

  // Certifies a frame, each with a seed of its own, and returns what its header says of it; nothing where it was not
  // asked for.
  std::vector<std::pair<std::string, std::string>> certify(const reference::ReferenceScene& scene,
                                                           const Image& picture);

  // The worst frame's certificate under its fixed names: that with the largest error. Null before the first.
  nlohmann::ordered_json json() const;

  // Prints it as one line. Throws Error(Limit) where it misses the tolerance.
  //   place   begins the error's message
  void report(const std::string& place) const;

 private:
  CertifyOptions options_;
  std::uint32_t frames_ = 0;
  std::uint32_t worstFrame_ = 0;
  std::uint32_t missed_ = 0;  // frames
  std::optional<reference::Certificate> worst_;
};

}  // namespace tetralux::cli
