#include "cli/frame_sequence.h"

#include <fmt/format.h>

#include <cctype>

#include "base/error.h"

namespace tetralux::cli {

FramePattern::FramePattern(std::string text) {
  std::string* part = &before_;
  for (size_t i = 0; i < text.size(); i++) {
    if (text[i] != '%') {
      *part += text[i];
      continue;
    }
    size_t end = i + 1;
    if (end < text.size() && text[end] == '%') {
      *part += '%';
      i = end;
      continue;
    }
    const bool zero = end < text.size() && text[end] == '0';
    std::uint32_t width = 0;
    for (; end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) && width < 100; end++)
      width = width * 10 + static_cast<std::uint32_t>(text[end] - '0');
    if (end >= text.size() || text[end] != 'd' || hasNumber_ || width > 20)
      fail(ErrorCode::Usage,
           "-o: found '{}', expected at most one %d or %0Nd for the frame's number (%% for a percent sign)", text);
    hasNumber_ = true;
    zeroPadded_ = zero;
    width_ = width;
    part = &after_;
    i = end;
  }
}

std::string FramePattern::name(std::uint32_t frame) const {
  if (!hasNumber_) return before_;
  const std::string number = zeroPadded_ ? fmt::format("{:0{}}", frame, width_) : fmt::format("{:{}}", frame, width_);
  return before_ + number + after_;
}

}  // namespace tetralux::cli
