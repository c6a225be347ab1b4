#include "formats/file.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include "unstep/formats.h"

namespace unstep {
namespace {

Error system_error(const char* doing, int number) {
  return {ErrorCode::io_error,
          std::string(doing) + ": " + std::generic_category().message(number)};
}

/// An owned file descriptor; 0 and 1 are borrowed.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > 1) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] explicit operator bool() const { return number_ >= 0; }
  /// The close that tells of delayed write errors. 0 or an errno.
  int close() {
    const int number = std::exchange(number_, -1);
    return number > 1 && ::close(number) != 0 && errno != EINTR ? errno : 0;
  }

 private:
  int number_;
};

template <class Call>
auto retry(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

/// Keeps SIGPIPE from ending the process while this thread writes, so that a
/// closed pipe is an error value. A signal that came meanwhile is swallowed.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoPipeSignal() {
    const timespec now{0, 0};
    if (!was_pending_) {
      retry([&] { return sigtimedwait(&pipe_, nullptr, &now); });
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

Status write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  const NoPipeSignal quiet;
  while (!bytes.empty()) {
    const ssize_t count =
        retry([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
    if (count < 0) return system_error("cannot write", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

/// The names of live temporaries, where a signal handler can read them.
struct TemporarySlot {
  enum State : int { unused, filling, live };
  std::atomic<int> state{unused};
  std::array<char, PATH_MAX> name{};
};
static_assert(std::atomic<int>::is_always_lock_free);
std::array<TemporarySlot, 64> temporaries;

/// A new file beside `path`. Removed on destruction unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::string folder =
        slash == std::string::npos ? "" : path.substr(0, slash + 1);
    static std::atomic<unsigned> counter{0};
    do {
      name_ = folder + ".unstep-" + std::to_string(::getpid()) + "-" +
              std::to_string(counter++) + ".tmp";
      enlist();
      descriptor_ =
          ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      error_ = errno;
      if (descriptor_ < 0) release();
    } while (descriptor_ < 0 && (error_ == EEXIST || error_ == EINTR));
  }
  ~Temporary() {
    if (descriptor_ >= 0 && !renamed_) ::unlink(name_.c_str());
    release();
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  [[nodiscard]] const char* name() const { return name_.c_str(); }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] int error() const { return error_; }
  void set_renamed() { renamed_ = true; }

 private:
  /// Without a free slot, or with a name too long, a signal may leave the file
  /// behind; nothing else depends on the slot.
  void enlist() {
    for (TemporarySlot& slot : temporaries) {
      int expected = TemporarySlot::unused;
      if (name_.size() >= slot.name.size() ||
          !slot.state.compare_exchange_strong(expected,
                                              TemporarySlot::filling)) {
        continue;
      }
      std::memcpy(slot.name.data(), name_.c_str(), name_.size() + 1);
      slot.state = TemporarySlot::live;
      slot_ = &slot;
      return;
    }
  }
  void release() {
    if (slot_ != nullptr) slot_->state = TemporarySlot::unused;
    slot_ = nullptr;
  }

  std::string name_;
  int descriptor_ = -1;
  int error_ = 0;
  bool renamed_ = false;
  TemporarySlot* slot_ = nullptr;
};

/// Gives `from` the name `to`, which must not exist. 0 or an errno.
int rename_to_new(const char* from, const char* to) {
  if (::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0) {
    return 0;
  }
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // A file system without the flag: link refuses an existing name too.
  if (::link(from, to) != 0) return errno;
  ::unlink(from);
  return 0;
}

int rename_over(const char* from, const char* to) {
  return ::rename(from, to) == 0 ? 0 : errno;
}

/// So that the new name survives a crash. Best effort: some file systems
/// cannot sync folders, and the data itself is safe by now.
void sync_folder(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder =
      slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const Descriptor descriptor(
      ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor) ::fsync(descriptor.get());
}

Error exists() { return {ErrorCode::output_exists, "the output exists"}; }

/// `mode`: of the file that is replaced, null if there is none.
Status write_by_rename(const std::string& path,
                       std::span<const std::uint8_t> bytes, bool overwrite,
                       const mode_t* mode) {
  Temporary temporary(path);
  Descriptor descriptor(temporary.descriptor());
  if (!descriptor) return system_error("cannot create", temporary.error());
  if (mode != nullptr) (void)::fchmod(descriptor.get(), *mode & 0777);
  if (Status written = write_all(descriptor.get(), bytes); !written) {
    return written;
  }
  if (retry([&] { return ::fsync(descriptor.get()); }) != 0) {
    return system_error("cannot write", errno);
  }
  if (const int error = descriptor.close(); error != 0) {
    return system_error("cannot write", error);
  }
  const int error = overwrite ? rename_over(temporary.name(), path.c_str())
                              : rename_to_new(temporary.name(), path.c_str());
  if (error == EEXIST) return exists();
  if (error != 0) return system_error("cannot rename", error);
  temporary.set_renamed();
  sync_folder(path);
  return {};
}

/// A pipe, a terminal, /dev/null: there is nothing to replace.
Status write_special(const std::string& path,
                     std::span<const std::uint8_t> bytes) {
  Descriptor descriptor(
      retry([&] { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC); }));
  if (!descriptor) return system_error("cannot open", errno);
  if (Status written = write_all(descriptor.get(), bytes); !written) {
    return written;
  }
  const int error = descriptor.close();
  return error == 0 ? Status{} : Status(system_error("cannot write", error));
}

/// The file that a symbolic link leads to, so that the link stays.
std::string resolve(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string resolved = real;
  std::free(real);
  return resolved;
}

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

void remove_temporaries() noexcept {
  for (TemporarySlot& slot : temporaries) {
    if (slot.state == TemporarySlot::live) ::unlink(slot.name.data());
  }
}

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

Status write_file(const std::string& path, std::span<const std::uint8_t> bytes,
                  bool overwrite) {
  try {
    if (path == "-") return write_all(STDOUT_FILENO, bytes);
    struct stat about {};
    const bool found = ::stat(path.c_str(), &about) == 0;
    if (found && S_ISDIR(about.st_mode)) {
      return system_error("cannot write", EISDIR);
    }
    if (found && !S_ISREG(about.st_mode)) return write_special(path, bytes);
    if (found && !overwrite) return exists();
    if (!found) return write_by_rename(path, bytes, overwrite, nullptr);
    return write_by_rename(resolve(path), bytes, true, &about.st_mode);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the file's name"};
  }
}

}  // namespace unstep
