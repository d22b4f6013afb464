// Failures that a user can cause or meet. One line of text: place, value found, value expected.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace tetralux {

// What went wrong, by the exit status that the program ends with.
enum class ErrorCode {
  Limit = 1,   // the result missed a limit that was asked for
  Usage = 2,   // the command line is wrong
  Input = 3,   // an input file is missing, damaged or holds a wrong value
  Device = 4,  // no usable device, or out of memory
  Output = 5,  // an output file could not be written
};

// Thrown by every library here. what() is one line without the program's name and without a full stop.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message);
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

// Throws Error(code, formatted text). Control characters in the text are replaced, so that it stays one line.
template <typename... Args>
[[noreturn]] void fail(ErrorCode code, fmt::format_string<Args...> format, Args&&... args) {
  throw Error(code, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace tetralux
