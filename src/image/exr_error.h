// Exceptions of the OpenEXR library as tetralux::Error.
#pragma once

#include <filesystem>
#include <new>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/error.h"

namespace tetralux {

// OpenEXR's text without what the caller says already: it puts 'Cannot read image file "<name>". ' and the like before
// the cause, once for every function passed, and ends with a full stop.
inline std::string exrCause(std::string text, const std::string& name) {
  const std::string mark = '"' + name + "\". ";
  const size_t last = text.rfind(mark);
  if (last != std::string::npos && last + mark.size() < text.size()) text.erase(0, last + mark.size());
  while (!text.empty() && (text.back() == '.' || text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

// Calls action(). Whatever OpenEXR throws becomes Error(code, "<path>: <what>: <cause>"); errors of tetralux itself and
// running out of memory pass through. OpenEXR must know the file by path.filename().
template <typename Action>
auto withExrErrors(ErrorCode code, const std::filesystem::path& path, const char* what, Action&& action) {
  try {
    return std::forward<Action>(action)();
  } catch (const Error&) {
    throw;
  } catch (const CheckFailure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    fail(code, "{}: {}: {}", path.string(), what, exrCause(e.what(), path.filename().string()));
  }
}

}  // namespace tetralux
