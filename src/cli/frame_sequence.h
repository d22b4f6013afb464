// File names of the frames of a sequence.
#pragma once

#include <cstdint>
#include <string>

namespace tetralux::cli {

// A name with one place for a frame's number, "%d" or "%04d"; "%%" is a percent sign.
class FramePattern {
 public:
  // Throws Error(Usage) when the text has another conversion or more than one number.
  explicit FramePattern(std::string text);

  bool hasNumber() const { return hasNumber_; }
  std::string name(std::uint32_t frame) const;

 private:
  std::string before_;
  std::string after_;
  bool hasNumber_ = false;
  bool zeroPadded_ = false;
  std::uint32_t width_ = 0;
};

}  // namespace tetralux::cli
