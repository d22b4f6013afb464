// Base64 text as VTK's XML formats hold it.
#pragma once

#include <cstddef>
#include <string_view>

namespace tetralux {

// Decodes a text from its beginning on. '=' ends a run and the next character begins a new one: VTK writes the header
// of an array and its data as separate runs, one after the other. White space may stand anywhere.
class Base64Reader {
 public:
  explicit Base64Reader(std::string_view text) : text_(text) {}

  // Writes the next `count` bytes to `out`. Returns how many there were: fewer where the text ends or has a character
  // that does not belong there.
  size_t read(std::byte* out, size_t count);

  // Upper bound of the bytes that read() still delivers.
  size_t available() const { return pendingCount_ + (3 * (text_.size() - position_) + 3) / 4; }

  // Characters taken so far. Where read() fell short of `count` before the text's end, this one does not belong there.
  size_t position() const { return position_; }
  bool atEnd() const { return position_ == text_.size(); }

 private:
  bool decodeGroup();

  std::string_view text_;
  size_t position_ = 0;
  std::byte pending_[3] = {};  // decoded and not yet delivered
  size_t pendingCount_ = 0;
};

}  // namespace tetralux
