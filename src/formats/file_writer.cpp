#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <string>

#include "formats/descriptor.h"
#include "formats/file.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

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

/// The file that a symbolic link leads to, so that the link stays.
std::string resolve(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string resolved = real;
  std::free(real);
  return resolved;
}

}  // namespace

void remove_temporaries() noexcept {
  for (TemporarySlot& slot : temporaries) {
    if (slot.state == TemporarySlot::live) ::unlink(slot.name.data());
  }
}

struct FileWriter::Impl {
  enum class Kind { standard_output, special, replaced };

  std::string path;  ///< of the file itself, not of a link to it
  bool overwrite = false;
  Kind kind = Kind::replaced;
  std::optional<Temporary> temporary;
  std::optional<Descriptor> descriptor;

  Status open();
  Status open_temporary(const mode_t* mode);
  Status commit();
};

Status FileWriter::Impl::open() {
  if (path == "-") {
    kind = Kind::standard_output;
    descriptor.emplace(STDOUT_FILENO);
    return {};
  }
  struct stat about {};
  const bool found = ::stat(path.c_str(), &about) == 0;
  if (found && S_ISDIR(about.st_mode)) {
    return system_error("cannot write", EISDIR);
  }
  if (found && !S_ISREG(about.st_mode)) {
    // A pipe, a terminal, /dev/null: there is nothing to replace.
    kind = Kind::special;
    descriptor.emplace(
        retry([&] { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC); }));
    return *descriptor ? Status{} : system_error("cannot open", errno);
  }
  if (found && !overwrite) return exists();
  if (found) path = resolve(path);
  return open_temporary(found ? &about.st_mode : nullptr);
}

/// `mode`: of the file that is replaced, null if there is none.
Status FileWriter::Impl::open_temporary(const mode_t* mode) {
  temporary.emplace(path);
  descriptor.emplace(temporary->descriptor());
  if (!*descriptor) return system_error("cannot create", temporary->error());
  if (mode != nullptr) (void)::fchmod(descriptor->get(), *mode & 0777);
  return {};
}

Status FileWriter::Impl::commit() {
  if (kind == Kind::standard_output) return {};
  if (kind == Kind::replaced &&
      retry([&] { return ::fsync(descriptor->get()); }) != 0) {
    return system_error("cannot write", errno);
  }
  if (const int error = descriptor->close(); error != 0) {
    return system_error("cannot write", error);
  }
  if (kind == Kind::special) return {};
  const int error = overwrite ? rename_over(temporary->name(), path.c_str())
                              : rename_to_new(temporary->name(), path.c_str());
  if (error == EEXIST) return exists();
  if (error != 0) return system_error("cannot rename", error);
  temporary->set_renamed();
  sync_folder(path);
  return {};
}

FileWriter::FileWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FileWriter::~FileWriter() = default;
FileWriter::FileWriter(FileWriter&&) noexcept = default;
FileWriter& FileWriter::operator=(FileWriter&&) noexcept = default;

Result<FileWriter> FileWriter::create(const std::string& path, bool overwrite) {
  try {
    auto impl = std::make_unique<Impl>();
    impl->path = path;
    impl->overwrite = overwrite;
    if (Status opened = impl->open(); !opened) return opened.error();
    return FileWriter(std::move(impl));
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the file's name"};
  }
}

Status FileWriter::write(std::span<const std::uint8_t> bytes) {
  return write_all(impl_->descriptor->get(), bytes);
}

Status FileWriter::commit() { return impl_->commit(); }

Status write_file(const std::string& path, std::span<const std::uint8_t> bytes,
                  bool overwrite) {
  Result<FileWriter> file = FileWriter::create(path, overwrite);
  if (!file) return file.error();
  if (Status written = file->write(bytes); !written) return written;
  return file->commit();
}

}  // namespace unstep
