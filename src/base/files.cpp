#include "base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "base/error.h"

namespace tetralux {
namespace fs = std::filesystem;
namespace {

struct CloseFile {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

template <typename Container>
Container readInto(const fs::path& path) {
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (!fs::exists(status)) fail(ErrorCode::Input, "{}: no such file", path.string());
  if (fs::is_directory(status)) fail(ErrorCode::Input, "{}: is a directory, expected a file", path.string());
  FileHandle file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(ErrorCode::Input, "{}: cannot be opened: {}", path.string(), std::strerror(errno));
  Container content;
  if (fs::is_regular_file(status)) {
    const auto size = fs::file_size(path, ec);
    if (ec) fail(ErrorCode::Input, "{}: size unknown: {}", path.string(), ec.message());
    content.resize(size);
    const size_t got = size == 0 ? 0 : std::fread(content.data(), 1, size, file.get());
    content.resize(got);
  } else {  // a pipe has no size
    char block[1 << 16];
    size_t got = 0;
    while ((got = std::fread(block, 1, sizeof block, file.get())) > 0) {
      const size_t old = content.size();
      content.resize(old + got);
      std::memcpy(content.data() + old, block, got);
    }
  }
  if (std::ferror(file.get())) fail(ErrorCode::Input, "{}: read error: {}", path.string(), std::strerror(errno));
  if (content.empty()) fail(ErrorCode::Input, "{}: is empty", path.string());
  return content;
}

}  // namespace

std::vector<std::byte> readFile(const fs::path& path) { return readInto<std::vector<std::byte>>(path); }

std::string readTextFile(const fs::path& path) { return readInto<std::string>(path); }

PendingFile::PendingFile(fs::path path) : path_(std::move(path)) {
  if (path_.empty() || path_.filename().empty()) fail(ErrorCode::Output, "'{}': not a file name", path_.string());
  std::error_code ec;
  if (fs::is_directory(path_, ec)) fail(ErrorCode::Output, "{}: is a directory, expected a file name", path_.string());
  const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ec)) fail(ErrorCode::Output, "{}: no such folder {}", path_.string(), folder.string());
  // The extension is kept: writers choose a format by it.
  temporary_ = folder / fmt::format(".{}.{}.tmp{}", path_.stem().string(), ::getpid(), path_.extension().string());
  const int descriptor = ::open(temporary_.c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(ErrorCode::Output, "{}: cannot be written: {}", path_.string(), std::strerror(errno));
  ::close(descriptor);
}

PendingFile::~PendingFile() {
  if (committed_) return;
  std::error_code ec;
  fs::remove(temporary_, ec);
}

void PendingFile::commit() {
  std::error_code ec;
  fs::rename(temporary_, path_, ec);
  if (ec) fail(ErrorCode::Output, "{}: cannot be written: {}", path_.string(), ec.message());
  committed_ = true;
}

void writeFile(const fs::path& path, const void* bytes, size_t size) {
  PendingFile pending(path);
  FileHandle file(std::fopen(pending.temporaryPath().c_str(), "wb"));
  if (!file) fail(ErrorCode::Output, "{}: cannot be written: {}", path.string(), std::strerror(errno));
  const bool written = std::fwrite(bytes, 1, size, file.get()) == size;
  if (std::fclose(file.release()) != 0 || !written)
    fail(ErrorCode::Output, "{}: cannot be written: {}", path.string(), std::strerror(errno));
  pending.commit();
}

void writeFile(const fs::path& path, const std::string& text) { writeFile(path, text.data(), text.size()); }

}  // namespace tetralux
