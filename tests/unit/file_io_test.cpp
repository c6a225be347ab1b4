#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "formats/file.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

class FileIo : public testing::Test {
 protected:
  FileIo() : folder_(fs::path(testing::TempDir()) / unique_name()) {
    fs::create_directories(folder_);
  }
  ~FileIo() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  /// The names in the folder, sorted.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  static std::string unique_name() {
    return "unstep-file-" + std::to_string(::getpid()) + "-" +
           testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  fs::path folder_;
};

constexpr std::uint64_t kNoLimit = UINT64_MAX;

TEST_F(FileIo, ReadsBackWhatItWrote) {
  for (const std::size_t size : {0U, 1U, 4096U, 65536U, 300000U}) {
    const Bytes bytes(size, 7);
    ASSERT_TRUE(write_file(path("a"), bytes, true));
    const Result<Bytes> read = read_file(path("a"), size);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, bytes);
    EXPECT_EQ(*read_file(path("a"), kNoLimit), bytes);
  }
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(FileIo, RefusesToOverwriteUnlessTold) {
  const Bytes one{1};
  const Bytes two{2};
  ASSERT_TRUE(write_file(path("a"), one, false));
  const Status refused = write_file(path("a"), two, false);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::output_exists);
  EXPECT_EQ(*read_file(path("a"), kNoLimit), one);
  fs::create_symlink("nowhere", path("dangling"));
  EXPECT_EQ(write_file(path("dangling"), two, false).error().code,
            ErrorCode::output_exists);
  ASSERT_TRUE(write_file(path("a"), two, true));
  EXPECT_EQ(*read_file(path("a"), kNoLimit), two);
}

TEST_F(FileIo, LetsOneOfManyWritersCreateAFile) {
  std::atomic<int> created{0};
  std::vector<std::thread> writers;
  for (std::uint8_t i = 0; i < 8; ++i) {
    writers.emplace_back([&, i] {
      if (write_file(path("a"), Bytes(1000, i), false)) ++created;
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(created, 1);
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(FileIo, KeepsPermissionsAndSymbolicLinks) {
  ASSERT_TRUE(write_file(path("a"), Bytes{1}, false));
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  fs::create_symlink("a", path("link"));
  ASSERT_TRUE(write_file(path("link"), Bytes{2}, true));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(*read_file(path("a"), kNoLimit), Bytes{2});
  struct stat about {};
  ASSERT_EQ(::stat(path("a").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0640U);
}

TEST_F(FileIo, NeverReplacesDevicesAndPipes) {
  EXPECT_TRUE(write_file("/dev/null", Bytes{1}, true));
  struct stat about {};
  ASSERT_EQ(::stat("/dev/null", &about), 0);
  EXPECT_TRUE(S_ISCHR(about.st_mode));
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer(
      [&] { EXPECT_TRUE(write_file(path("pipe"), Bytes(200000, 3), false)); });
  EXPECT_EQ(*read_file(path("pipe"), kNoLimit), Bytes(200000, 3));
  writer.join();
  EXPECT_EQ(names(), std::vector<std::string>{"pipe"});
}

TEST_F(FileIo, StopsAtTheLimitWhileItReads) {
  ASSERT_TRUE(write_file(path("a"), Bytes(1000, 1), false));
  EXPECT_EQ(read_file(path("a"), 999).error().code, ErrorCode::limit_exceeded);
  EXPECT_TRUE(read_file(path("a"), 1000));
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer([&] {
    (void)write_file(path("pipe"), Bytes(2000000, 3), false);  // EPIPE
  });
  EXPECT_EQ(read_file(path("pipe"), 70000).error().code,
            ErrorCode::limit_exceeded);
  writer.join();
  EXPECT_EQ(read_file("/dev/zero", 100000).error().code,
            ErrorCode::limit_exceeded);
}

TEST_F(FileIo, GivesTheSystemsReason) {
  EXPECT_EQ(read_file(path("none"), kNoLimit).error().message,
            "cannot open: No such file or directory");
  EXPECT_EQ(read_file(path(""), kNoLimit).error().message,
            "cannot read: Is a directory");
  EXPECT_EQ(write_file(path(""), Bytes{1}, true).error().message,
            "cannot write: Is a directory");
  const Status no_folder = write_file(path("none/a"), Bytes{1}, true);
  ASSERT_FALSE(no_folder);
  EXPECT_EQ(no_folder.error().code, ErrorCode::io_error);
  EXPECT_EQ(no_folder.error().message,
            "cannot create: No such file or directory");
  EXPECT_EQ(write_file("/dev/full", Bytes{1}, true).error().message,
            "cannot write: No space left on device");
}

TEST_F(FileIo, TellsOfAClosedPipeWithoutASignal) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const std::string name = "/dev/fd/" + std::to_string(ends[1]);
  const Status written = write_file(name, Bytes{1}, false);
  ::close(ends[1]);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::io_error);
}

/// In a child: a file size limit makes the write fail half way; a signal
/// handler ends the process while the temporary is there.
TEST_F(FileIo, LeavesNothingBehindWhenWritingFails) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const Status written = write_file(path("a"), Bytes(5000, 1), false);
    ::_exit(!written && written.error().code == ErrorCode::io_error ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(names().empty());
}

TEST_F(FileIo, RemovesTemporariesFromASignalHandler) {
  const pid_t child = ::fork();
  if (child == 0) {
    // The size limit's signal comes while the temporary is open.
    ::signal(SIGXFSZ, [](int) {
      remove_temporaries();
      ::_exit(42);
    });
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    (void)write_file(path("a"), Bytes(5000, 1), false);
    ::_exit(1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 42);
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace unstep
