// Bytes and speed of the library over a folder of images, in one process.
//
//     unstep_bench [--runs N] [--pages] FOLDER
//
// Every sub-folder is a set; images directly in FOLDER are a set too. Every
// page is encoded and decoded N times (default 3) on one thread, without the
// check that compress makes; the medians count, and each decoded page is
// compared. Prints a Markdown table; --pages adds a row per page.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "unstep/bitmap.h"
#include "unstep/codec.h"
#include "unstep/formats.h"

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 32;

struct Totals {
  int pages = 0;
  std::uint64_t pixels = 0;
  std::uint64_t steps = 0;
  std::uint64_t bytes = 0;
  double encode_s = 0;
  double decode_s = 0;

  void operator+=(const Totals& other) {
    pages += other.pages;
    pixels += other.pixels;
    steps += other.steps;
    bytes += other.bytes;
    encode_s += other.encode_s;
    decode_s += other.decode_s;
  }
};

std::uint64_t ones(std::uint64_t word) {
  return static_cast<std::uint64_t>(__builtin_popcountll(word));
}

// Cracks between ink and paper, the unit steps of all contours. Pixels
// outside are paper, so each row starts and ends with one.
std::uint64_t crack_steps(const unstep::Bitmap& ink) {
  std::uint64_t steps = 0;
  for (std::int32_t y = 0; y < ink.height(); ++y) {
    const auto row = ink.row(y);
    std::uint64_t before = 0;  // the pixel left of the word, in bit 0
    for (std::size_t i = 0; i < row.size(); ++i) {
      steps += ones(row[i] ^ (row[i] >> 1 | before << 63));
      if (y == 0) steps += ones(row[i]);
      steps += ones(y + 1 < ink.height() ? row[i] ^ ink.row(y + 1)[i] : row[i]);
      before = row[i] & 1;
    }
    steps += before;
  }
  return steps;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Seconds that `work` takes; false from it is a failure.
template <class Work>
bool time_it(std::vector<double>& seconds, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  if (!work()) return false;
  const std::chrono::duration<double> spent =
      std::chrono::steady_clock::now() - start;
  seconds.push_back(spent.count());
  return true;
}

bool measure_page(const unstep::Bitmap& ink, int runs, Totals& totals) {
  std::vector<std::uint8_t> file;
  std::vector<double> encode_s;
  std::vector<double> decode_s;
  for (int i = 0; i < runs; ++i) {
    const bool encoded = time_it(encode_s, [&] {
      unstep::EncodeOptions options;
      options.verify = false;
      unstep::UstpWriter writer(options);
      if (!writer.add_page(ink, {})) return false;
      auto result = writer.finish();
      if (result) file = std::move(*result);
      return bool{result};
    });
    if (!encoded) return false;

    unstep::Bitmap decoded;
    const bool read = time_it(decode_s, [&] {
      const auto reader = unstep::UstpReader::open(file, {});
      if (!reader) return false;
      auto page = reader->read_page(0);
      if (page) decoded = std::move(page->ink);
      return bool{page};
    });
    if (!read || decoded != ink) return false;
  }
  totals = {1,           ink.pixels(),     crack_steps(ink),
            file.size(), median(encode_s), median(decode_s)};
  return true;
}

void print_header() {
  std::printf(
      "| set | pages | Mpx | bytes | bits/step | encode Mpx/s | decode Mpx/s "
      "| encode ns/step | decode ns/step |\n|---|--:|--:|--:|--:|--:|--:|--:|"
      "--:|\n");
}

void print_row(const std::string& name, const Totals& t) {
  const double mpx = static_cast<double>(t.pixels) / 1e6;
  const double steps = static_cast<double>(std::max<std::uint64_t>(t.steps, 1));
  std::printf(
      "| %s | %d | %.2f | %llu | %.3f | %.1f | %.1f | %.1f | %.1f |\n",
      name.c_str(), t.pages, mpx, static_cast<unsigned long long>(t.bytes),
      static_cast<double>(t.bytes) * 8 / steps, mpx / t.encode_s,
      mpx / t.decode_s, t.encode_s * 1e9 / steps, t.decode_s * 1e9 / steps);
}

struct Options {
  int runs = 3;
  bool pages = false;
  std::string folder;
};

// Adds the pages of one file. Files that are no two-valued images are named
// and passed over; a page that fails to come back is an error.
bool measure_file(const fs::path& path, const Options& options, Totals& set) {
  auto bytes = unstep::read_file(path.string(), kMaxFileBytes);
  if (!bytes) return false;
  auto file = unstep::RasterReader::open(std::move(*bytes), {});
  for (std::size_t i = 0; file && i < file->page_count(); ++i) {
    const auto page = file->read(i);
    if (!page) {
      std::fprintf(stderr, "passed over: %s: %s\n", path.c_str(),
                   page.error().message.c_str());
      continue;
    }
    Totals one;
    if (!measure_page(page->ink, options.runs, one)) {
      std::fprintf(stderr, "FAILED: %s page %zu\n", path.c_str(), i + 1);
      return false;
    }
    if (options.pages) print_row(path.filename().string(), one);
    set += one;
  }
  return true;
}

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--runs" && i + 1 < argc) {
      options.runs = std::atoi(argv[++i]);
    } else if (word == "--pages") {
      options.pages = true;
    } else if (options.folder.empty() && word.substr(0, 1) != "-") {
      options.folder = word;
    } else {
      return false;
    }
  }
  return options.runs > 0 && !options.folder.empty();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    std::fprintf(stderr, "usage: unstep_bench [--runs N] [--pages] FOLDER\n");
    return 2;
  }

  std::map<std::string, std::vector<fs::path>> sets;
  std::error_code error;
  for (fs::recursive_directory_iterator at(options.folder, error), end;
       at != end; at.increment(error)) {
    if (at->is_regular_file(error)) {
      const fs::path folder = at->path().parent_path();
      sets[folder == options.folder ? "." : folder.filename().string()]
          .push_back(at->path());
    }
  }
  if (error || sets.empty()) {
    std::fprintf(stderr, "unstep_bench: no files in %s\n",
                 options.folder.c_str());
    return 2;
  }

  print_header();
  Totals total;
  for (auto& [name, paths] : sets) {
    std::sort(paths.begin(), paths.end());
    Totals set;
    for (const fs::path& path : paths) {
      if (!measure_file(path, options, set)) return 1;
    }
    if (set.pages == 0) continue;
    print_row(name, set);
    total += set;
  }
  if (total.pages > 0) print_row("total", total);
  return 0;
}
