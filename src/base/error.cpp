#include "base/error.h"

namespace tetralux {
namespace {

// Names in files may hold anything; an error stays one readable line whatever they hold.
std::string oneLine(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  constexpr size_t kLongest = 400;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& message) : std::runtime_error(oneLine(message)), code_(code) {}

}  // namespace tetralux
