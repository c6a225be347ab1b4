#include "formats/external_program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

extern "C" char** environ;  // NOLINT

namespace unstep {
namespace {

/// A pipe that other programs do not inherit; both ends are closed at the end.
class Pipe {
 public:
  Pipe() { good_ = ::pipe2(ends_.data(), O_CLOEXEC) == 0; }
  ~Pipe() {
    close(0);
    close(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] bool is_good() const { return good_; }
  [[nodiscard]] int end(std::size_t i) const { return ends_[i]; }
  void close(std::size_t i) {
    if (ends_[i] >= 0) ::close(ends_[i]);
    ends_[i] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
  bool good_ = false;
};

Error io_error(const std::string& what) {
  return {ErrorCode::io_error, what + ": " + std::strerror(errno)};
}

struct Pipes {
  Pipe output;
  Pipe errors;
  Pipe failure;  ///< errno, if the program cannot be started
};

rlimit both(std::uint64_t value) {
  return {static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
}

/// In the child: system calls only.
[[noreturn]] void become(const Pipes& pipes, char* const* arguments,
                         char* const* environment, const RunLimits& limits) {
  const rlimit core = both(0);
  const rlimit time = both(limits.seconds);
  const rlimit file = both(limits.file_bytes);
  ::setrlimit(RLIMIT_CORE, &core);
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_FSIZE, &file);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(pipes.output.end(1), STDOUT_FILENO);
  ::dup2(pipes.errors.end(1), STDERR_FILENO);
  ::execvpe(arguments[0], arguments, environment);
  const int reason = errno;
  [[maybe_unused]] const ssize_t written =
      ::write(pipes.failure.end(1), &reason, sizeof reason);
  ::_exit(127);
}

/// Both streams until they end; what is above a limit is read and dropped.
struct Heard {
  std::string output;
  std::string errors;
  bool too_much = false;
};

Heard listen(Pipes& pipes, std::uint64_t most) {
  constexpr std::size_t kMostErrors = 4096;
  Heard heard;
  std::array<char, 1 << 14> piece{};
  std::array<pollfd, 2> waits{pollfd{pipes.output.end(0), POLLIN, 0},
                              pollfd{pipes.errors.end(0), POLLIN, 0}};
  while (waits[0].fd >= 0 || waits[1].fd >= 0) {
    if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) break;
    for (std::size_t i = 0; i < waits.size(); ++i) {
      if (waits[i].fd < 0 || waits[i].revents == 0) continue;
      const ssize_t size = ::read(waits[i].fd, piece.data(), piece.size());
      if (size < 0 && errno == EINTR) continue;
      if (size <= 0) {
        waits[i].fd = -1;
        continue;
      }
      std::string& text = i == 0 ? heard.output : heard.errors;
      const std::uint64_t room = (i == 0 ? most : kMostErrors) - text.size();
      const auto count = static_cast<std::size_t>(
          std::min<std::uint64_t>(room, static_cast<std::uint64_t>(size)));
      text.append(piece.data(), count);
      heard.too_much =
          heard.too_much || (i == 0 && count < static_cast<std::size_t>(size));
    }
  }
  return heard;
}

std::string first_line(const std::string& text) {
  std::string line = text.substr(0, std::min(text.find('\n'), text.size()));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c < ' '; }, ' ');
  return line.substr(0, 200);
}

Status judge(const std::string& name, int status, const Heard& heard) {
  if (heard.too_much) {
    return Error{ErrorCode::limit_exceeded, name + " prints too much"};
  }
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const bool limit = signal == SIGXCPU || signal == SIGXFSZ;
    return Error{limit ? ErrorCode::limit_exceeded : ErrorCode::corrupt,
                 name + (signal == SIGXCPU   ? " takes too long"
                         : signal == SIGXFSZ ? " writes too large a file"
                                             : " was ended by signal " +
                                                   std::to_string(signal))};
  }
  if (WEXITSTATUS(status) == 0) return {};
  const std::string reason = first_line(heard.errors);
  return Error{
      ErrorCode::corrupt,
      name + ": " +
          (reason.empty() ? "exit code " + std::to_string(WEXITSTATUS(status))
                          : reason)};
}

/// argv and envp: pointers into texts that stay.
std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (std::string& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

std::vector<std::string> plain_environment() {
  std::vector<std::string> out;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    if (!text.starts_with("LC_") && !text.starts_with("LANG")) {
      out.emplace_back(text);
    }
  }
  out.emplace_back("LC_ALL=C");
  return out;
}

}  // namespace

Result<TemporaryFolder> TemporaryFolder::create() {
  const char* chosen = std::getenv("TMPDIR");
  std::string path = chosen != nullptr && *chosen != '\0' ? chosen : "/tmp";
  path += "/unstep-" + std::string(6, 'X');
  if (::mkdtemp(path.data()) == nullptr) {
    return io_error("no temporary folder " + path);
  }
  return TemporaryFolder(std::move(path));
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  if (path_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Result<std::string> run_program(const std::vector<std::string>& arguments,
                                const RunLimits& limits) {
  const std::string& name = arguments[0];
  Pipes pipes;
  if (!pipes.output.is_good() || !pipes.errors.is_good() ||
      !pipes.failure.is_good()) {
    return io_error("no pipe to " + name);
  }
  std::vector<std::string> texts = arguments;
  std::vector<std::string> environment = plain_environment();
  const std::vector<char*> argv = pointers(texts);
  const std::vector<char*> envp = pointers(environment);
  const pid_t child = ::fork();
  if (child < 0) return io_error("cannot start " + name);
  if (child == 0) become(pipes, argv.data(), envp.data(), limits);
  for (Pipe* pipe : {&pipes.output, &pipes.errors, &pipes.failure}) {
    pipe->close(1);
  }
  const Heard heard = listen(pipes, limits.output_bytes);
  int reason = 0;
  const bool not_started =
      ::read(pipes.failure.end(0), &reason, sizeof reason) == sizeof reason;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (not_started) {
    return Error{
        ErrorCode::unsupported,
        "the program " + name + " cannot be started: " + std::strerror(reason)};
  }
  if (Status good = judge(name, status, heard); !good) return good.error();
  return heard.output;
}

}  // namespace unstep
