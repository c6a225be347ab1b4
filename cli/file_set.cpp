#include "cli/file_set.h"

#include <glob.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <utility>

#include "cli/output_format.h"
#include "unstep/formats.h"

namespace unstep::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxListBytes = std::uint64_t{1} << 30;
constexpr std::array<std::string_view, 12> kDrawings{
    ".pbm", ".pgm", ".pnm", ".png",  ".tif", ".tiff",
    ".bmp", ".dib", ".jpg", ".jpeg", ".pdf", ".fc"};

Error io_problem(int number) {
  return {ErrorCode::io_error,
          std::error_code(number, std::generic_category()).message()};
}

/// `path` as a place below another folder.
fs::path without_root(const fs::path& path) {
  fs::path place;
  for (const fs::path& part : path.lexically_normal().relative_path()) {
    if (part != ".." && part != "." && !part.empty()) place /= part;
  }
  return place;
}

class Collector {
 public:
  explicit Collector(const FileSetOptions& options) : options_(options) {
    struct stat status = {};
    if (stat(options.output_folder.c_str(), &status) == 0) {
      output_ = {status.st_dev, status.st_ino};
    }
  }

  Result<FileSet> run() {
    for (const std::string& argument : options_.arguments) {
      add_argument(argument);
    }
    for (const std::string& list : options_.lists) add_list(list);
    if (Status distinct = sort_inputs(); !distinct) return distinct.error();
    return std::move(set_);
  }

 private:
  /// Device and inode: what a folder is, whatever it is called.
  using FolderId = std::pair<dev_t, ino_t>;

  void add_argument(const std::string& argument) {
    struct stat status = {};
    if (stat(argument.c_str(), &status) == 0) {
      const bool folder = S_ISDIR(status.st_mode);
      add_path(argument, folder ? fs::path() : fs::path(argument).filename());
    } else if (argument.starts_with('@')) {
      add_list(argument.substr(1));
    } else if (argument.find_first_of("*?[") != std::string::npos) {
      add_glob(argument);
    } else {
      set_.problems.push_back({argument, io_problem(errno)});
    }
  }

  /// A file or a folder that was named, not found.
  void add_path(const fs::path& path, const fs::path& place) {
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) {
      set_.problems.push_back({path.string(), io_problem(errno)});
    } else if (S_ISDIR(status.st_mode)) {
      add_folder(path, place, {status.st_dev, status.st_ino});
    } else {
      add_file(path, place, status);
    }
  }

  void add_file(const fs::path& path, const fs::path& place,
                const struct stat& status) {
    set_.inputs.push_back({path.string(), place.string(),
                           static_cast<std::uint64_t>(status.st_size)});
  }

  void add_folder(const fs::path& path, const fs::path& place, FolderId id) {
    // A folder that is its own ancestor was reached through a link: a loop.
    if (std::find(open_.begin(), open_.end(), id) != open_.end()) return;
    if (id == output_ && !open_.empty()) return;
    std::error_code failure;
    std::vector<fs::path> names;
    for (fs::directory_iterator entry(path, failure), end;
         !failure && entry != end; entry.increment(failure)) {
      names.push_back(entry->path().filename());
    }
    if (failure) {
      set_.problems.push_back({path.string(), io_problem(failure.value())});
    }
    std::sort(names.begin(), names.end());
    open_.push_back(id);
    for (const fs::path& name : names) add_entry(path / name, place / name);
    open_.pop_back();
  }

  /// Something found in a folder: only drawings count.
  void add_entry(const fs::path& path, const fs::path& place) {
    struct stat status = {};
    const bool there = stat(path.c_str(), &status) == 0;
    if (there && S_ISDIR(status.st_mode)) {
      add_folder(path, place, {status.st_dev, status.st_ino});
    } else if (!wanted(path.string())) {
      ++set_.passed_over;
    } else if (!there) {
      set_.problems.push_back({path.string(), io_problem(errno)});
    } else if (S_ISREG(status.st_mode)) {
      add_file(path, place, status);
    } else {
      ++set_.passed_over;
    }
  }

  [[nodiscard]] bool wanted(const std::string& path) const {
    if (options_.ustp) return has_suffix(path, ".ustp");
    return std::any_of(
        kDrawings.begin(), kDrawings.end(),
        [&](std::string_view ending) { return has_suffix(path, ending); });
  }

  void add_glob(const std::string& pattern) {
    const std::size_t wildcard = pattern.find_first_of("*?[");
    const std::size_t slash = pattern.rfind('/', wildcard);
    const std::size_t fixed = slash == std::string::npos ? 0 : slash + 1;
    glob_t matches = {};
    const int failure = glob(pattern.c_str(), 0, nullptr, &matches);
    if (failure == 0) {
      for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
        const std::string path = matches.gl_pathv[i];
        add_path(path, path.substr(fixed));
      }
    } else {
      set_.problems.push_back(
          {pattern, {ErrorCode::io_error, "matches no file"}});
    }
    globfree(&matches);
  }

  /// One path per line; separated by NUL if there is one, as find -print0
  /// writes them.
  void add_list(const std::string& list) {
    const Result<std::vector<std::uint8_t>> text =
        read_file(list, kMaxListBytes);
    if (!text) {
      set_.problems.push_back({list, text.error()});
      return;
    }
    const bool by_nul = std::find(text->begin(), text->end(), 0) != text->end();
    const char separator = by_nul ? '\0' : '\n';
    std::string line;
    const auto take = [&] {
      if (!by_nul && line.ends_with('\r')) line.pop_back();
      if (!line.empty()) add_path(line, without_root(line));
      line.clear();
    };
    for (const std::uint8_t byte : *text) {
      if (static_cast<char>(byte) == separator) {
        take();
      } else {
        line += static_cast<char>(byte);
      }
    }
    take();
  }

  Status sort_inputs() {
    std::vector<BatchInput>& inputs = set_.inputs;
    std::sort(inputs.begin(), inputs.end(),
              [](const BatchInput& a, const BatchInput& b) {
                return std::tie(a.relative, a.path) <
                       std::tie(b.relative, b.path);
              });
    std::vector<BatchInput> distinct;
    for (BatchInput& input : inputs) {
      if (distinct.empty() || distinct.back().relative != input.relative) {
        distinct.push_back(std::move(input));
        continue;
      }
      std::error_code failure;
      if (!fs::equivalent(distinct.back().path, input.path, failure)) {
        return Error{ErrorCode::invalid_argument,
                     distinct.back().path + " and " + input.path +
                         " would become the same file; name a folder that "
                         "holds both, or a list"};
      }
    }
    inputs = std::move(distinct);
    return {};
  }

  const FileSetOptions& options_;
  FileSet set_;
  FolderId output_{};
  std::vector<FolderId> open_;  ///< the folders being searched, outermost first
};

}  // namespace

Result<FileSet> collect_files(const FileSetOptions& options) {
  return Collector(options).run();
}

}  // namespace unstep::cli
