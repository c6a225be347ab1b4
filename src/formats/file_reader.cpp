#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <exception>
#include <string>

#include "formats/descriptor.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

Error too_long(std::uint64_t max_bytes) {
  return {ErrorCode::limit_exceeded, "the file is longer than the limit of " +
                                         std::to_string(max_bytes) + " bytes"};
}

Result<std::vector<std::uint8_t>> read_all(int descriptor,
                                           std::uint64_t max_bytes) {
  struct stat about {};
  if (::fstat(descriptor, &about) != 0)
    return system_error("cannot read", errno);
  std::uint64_t expected = 64 << 10;
  if (S_ISREG(about.st_mode) && about.st_size > 0) {
    expected = static_cast<std::uint64_t>(about.st_size);
    if (expected > max_bytes) return too_long(max_bytes);
  }
  std::vector<std::uint8_t> bytes;
  std::size_t size = 0;
  for (;;) {
    if (size == bytes.size()) {
      // The size of a regular file at first; then, and for pipes, half more.
      const std::uint64_t wanted =
          bytes.empty() ? expected : bytes.size() + bytes.size() / 2 + 4096;
      // One byte above the limit is enough to see that it is passed.
      bytes.resize(static_cast<std::size_t>(
          std::min(wanted, std::max(max_bytes, max_bytes + 1))));
    }
    const ssize_t count = retry([&] {
      return ::read(descriptor, bytes.data() + size, bytes.size() - size);
    });
    if (count < 0) return system_error("cannot read", errno);
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
    if (size > max_bytes) return too_long(max_bytes);
    if (size == bytes.size() && size == expected) {
      // Usually the end: ask before growing.
      std::uint8_t one = 0;
      const ssize_t more = retry([&] { return ::read(descriptor, &one, 1); });
      if (more < 0) return system_error("cannot read", errno);
      if (more == 0) break;
      if (size == max_bytes) return too_long(max_bytes);
      bytes.push_back(one);
      ++size;
    }
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

Result<std::vector<std::uint8_t>> read_file(const std::string& path,
                                            std::uint64_t max_bytes) {
  try {
    if (path == "-") return read_all(STDIN_FILENO, max_bytes);
    const Descriptor descriptor(
        retry([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }));
    if (!descriptor) return system_error("cannot open", errno);
    return read_all(descriptor.get(), max_bytes);
  } catch (const std::exception&) {  // bad_alloc, length_error
    return Error{ErrorCode::limit_exceeded, "no memory for the file"};
  }
}

}  // namespace unstep
