#include "mesh/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetralux {
namespace {

// What a character means: 0..63 are digits.
constexpr std::uint8_t kSpace = 64;
constexpr std::uint8_t kPadding = 65;
constexpr std::uint8_t kForeign = 66;

constexpr std::array<std::uint8_t, 256> kMeaning = [] {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> meaning{};
  meaning.fill(kForeign);
  for (size_t i = 0; i < digits.size(); i++) {
    meaning[static_cast<std::uint8_t>(digits[i])] = static_cast<std::uint8_t>(i);
  }
  for (const char c : {' ', '\t', '\n', '\r', '\v', '\f'}) meaning[static_cast<std::uint8_t>(c)] = kSpace;
  meaning['='] = kPadding;
  return meaning;
}();

std::uint8_t meaningOf(char c) { return kMeaning[static_cast<std::uint8_t>(c)]; }

// Three bytes of four digits.
void storeGroup(std::uint32_t bits, std::byte* out) {
  out[0] = static_cast<std::byte>(bits >> 16);
  out[1] = static_cast<std::byte>(bits >> 8);
  out[2] = static_cast<std::byte>(bits);
}

}  // namespace

// Takes one group of up to four digits to pending_. False at the text's end and at a character that may not stand here.
bool Base64Reader::decodeGroup() {
  std::uint32_t bits = 0;
  int digits = 0;
  int paddings = 0;
  while (digits + paddings < 4 && position_ < text_.size()) {
    const std::uint8_t meaning = meaningOf(text_[position_]);
    if (meaning == kForeign || (meaning == kPadding && digits < 2) || (meaning < 64 && paddings > 0)) return false;
    if (meaning == kPadding) paddings++;
    if (meaning < 64) {
      bits = bits << 6 | meaning;
      digits++;
    }
    position_++;
  }
  if (digits < 2) return false;  // the end; a single digit holds no whole byte
  storeGroup(bits << (6 * (4 - digits)), pending_);
  pendingCount_ = static_cast<size_t>(digits) - 1;
  return true;
}

size_t Base64Reader::read(std::byte* out, size_t count) {
  size_t done = 0;
  while (done < count) {
    if (pendingCount_ > 0) {
      const size_t taken = std::min(pendingCount_, count - done);
      std::copy_n(pending_, taken, out + done);
      std::copy(pending_ + taken, pending_ + pendingCount_, pending_);
      pendingCount_ -= taken;
      done += taken;
      continue;
    }
    // Nearly all groups are four digits in a row: straight to the output.
    while (count - done >= 3 && text_.size() - position_ >= 4) {
      const char* c = text_.data() + position_;
      const std::uint32_t a = meaningOf(c[0]), b = meaningOf(c[1]), d = meaningOf(c[2]), e = meaningOf(c[3]);
      if ((a | b | d | e) >= 64) break;
      storeGroup(a << 18 | b << 12 | d << 6 | e, out + done);
      done += 3;
      position_ += 4;
    }
    if (done < count && !decodeGroup()) break;
  }
  return done;
}

}  // namespace tetralux
