#include "cli/batch_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <system_error>
#include <utility>

#include "cli/compare.h"
#include "cli/source.h"
#include "cli/unpack.h"
#include "unstep/formats.h"

namespace unstep::cli {
namespace {

namespace fs = std::filesystem;

/// What an existing output means for a batch.
enum class Existing : std::uint8_t {
  none,      ///< nothing there, or --force: write
  finished,  ///< --resume: skip
  stale,     ///< --resume: damaged, or of another source: write again
  foreign,   ///< not ours to overwrite
};

JobResult failure(JobResult result, std::string path, Error error) {
  result.status = error.code == ErrorCode::cancelled
                      ? JobResult::Status::not_run
                      : JobResult::Status::failed;
  result.failed_path = std::move(path);
  result.error = std::move(error);
  return result;
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

bool is_damage(ErrorCode code) {
  return code == ErrorCode::truncated || code == ErrorCode::corrupt ||
         code == ErrorCode::checksum_mismatch;
}

Error output_exists(Existing existing, bool resume) {
  const bool foreign = resume && existing == Existing::foreign;
  return {ErrorCode::output_exists,
          foreign ? "exists and was not made from this input; --force "
                    "overwrites it"
                  : "exists; --force overwrites it, --resume skips it if it "
                    "is finished"};
}

std::string record_of_size(const Source& source) {
  return std::to_string(source.bytes());
}

std::string record_of_crc(const Source& source) {
  return fmt::format("{:08x}", source.crc32());
}

std::string value_of(const Metadata& metadata, std::string_view key) {
  for (const auto& [name, value] : metadata) {
    if (name == key) return value;
  }
  return {};
}

/// UstpReader::open checks the CRC of every block of the block form; the one
/// of the short form is of what is drawn.
bool is_intact(const UstpReader& reader) {
  return reader.info().form == FileInfo::Form::block_form ||
         static_cast<bool>(reader.read_page(0));
}

Existing judge_ustp(const std::string& path, const Source& source,
                    const JobOptions& options) {
  if (options.force || !exists(path)) return Existing::none;
  if (!options.resume) return Existing::foreign;
  const Result<std::vector<std::uint8_t>> bytes =
      read_file(path, options.read.limits.max_memory);
  if (!bytes) return Existing::foreign;
  const Result<UstpReader> reader =
      UstpReader::open(*bytes, {options.read.limits, options.jobs, {}});
  if (!reader) {
    return is_damage(reader.error().code) ? Existing::stale : Existing::foreign;
  }
  const Metadata& metadata = reader->info().metadata;
  const std::string size = value_of(metadata, kSourceSizeKey);
  const std::string crc = value_of(metadata, kSourceCrcKey);
  if (size.empty() || crc.empty()) return Existing::foreign;
  return size == record_of_size(source) && crc == record_of_crc(source) &&
                 is_intact(*reader)
             ? Existing::finished
             : Existing::stale;
}

/// A raster or text file has no record of its source: it is finished if it
/// holds the same drawing.
Existing judge_file(const OutputFile& file, const UstpReader& reader,
                    const JobOptions& options) {
  if (options.force || !exists(file.path)) return Existing::none;
  if (!options.resume) return Existing::foreign;
  Result<Source> there = Source::open(file.path, options.read);
  if (!there) {
    return is_damage(there.error().code) ? Existing::stale : Existing::foreign;
  }
  if (there->page_count() != file.pages.size()) return Existing::foreign;
  for (std::size_t i = 0; i < file.pages.size(); ++i) {
    const Result<SourcePage> old = there->read(i);
    if (!old) {
      return is_damage(old.error().code) ? Existing::stale : Existing::foreign;
    }
    const Result<Page> page = reader.read_page(file.pages[i]);
    if (!page) return Existing::foreign;
    if (first_difference(old->page, *page)) return Existing::foreign;
  }
  return Existing::finished;
}

Status make_folder_of(const std::string& path) {
  std::error_code failed;
  const fs::path folder = fs::path(path).parent_path();
  fs::create_directories(folder, failed);
  if (!failed) return {};
  return Error{ErrorCode::io_error,
               "cannot make its folder: " + failed.message()};
}

/// Writes one output; true if it was finished before.
Result<bool> write_output(
    const std::string& path, Existing existing, const JobOptions& options,
    const std::function<Result<std::vector<std::uint8_t>>()>& encode,
    std::uint64_t& bytes_written, bool& output_failed) {
  output_failed = true;
  if (existing == Existing::finished) return true;
  if (existing == Existing::foreign) {
    return output_exists(existing, options.resume);
  }
  output_failed = false;
  const Result<std::vector<std::uint8_t>> bytes = encode();
  if (!bytes) return bytes.error();
  output_failed = true;
  if (const Status made = make_folder_of(path); !made) return made.error();
  const bool overwrite = options.force || existing == Existing::stale;
  if (const Status written = write_file(path, *bytes, overwrite); !written) {
    return written.error();
  }
  bytes_written += bytes->size();
  return false;
}

struct DecompressPlan {
  OutputFormat format = OutputFormat::png;
  std::vector<OutputFile> files;
};

/// Which files NAME.ustp becomes.
Result<DecompressPlan> plan_job(const BatchInput& input,
                                const JobOptions& options,
                                const FileInfo& info) {
  std::string relative = input.relative;
  if (has_suffix(relative, ".ustp")) relative.resize(relative.size() - 5);
  std::vector<std::size_t> pages(info.pages.size());
  std::iota(pages.begin(), pages.end(), std::size_t{0});
  const std::optional<OutputFormat> named = format_of_name(relative);
  DecompressPlan plan;
  if (options.to) {
    if (const Status fits = check_kinds(info, pages, *options.to); !fits) {
      return fits.error();
    }
    plan.format = *options.to;
  } else {
    const Result<OutputFormat> natural = natural_format(info, pages);
    if (!natural) return natural.error();
    plan.format = *natural;
    const bool holds = named && check_kinds(info, pages, *named) &&
                       (pages.size() == 1 || holds_pages(*named) ||
                        *named == OutputFormat::pbm);
    if (holds) plan.format = *named;
  }
  if (named != plan.format) {
    relative += '.' + std::string(extension(plan.format));
  }
  const std::string path =
      (fs::path(options.output_folder) / relative).string();
  plan.files = plan_files(path, pages, plan.format, !options.to);
  return plan;
}

/// The bytes of one output file.
Result<std::vector<std::uint8_t>> bytes_of(
    const UstpReader& reader, const std::vector<std::size_t>& pages,
    OutputFormat format, const DecodeLimits& limits, const Listener& listener,
    std::vector<std::string>& notes) {
  std::vector<std::uint8_t> bytes;
  const auto keep = [&](std::string_view more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
    return Status();
  };
  Result<PageWriter> writer =
      PageWriter::create(format, keep, {}, Effort::standard, limits);
  if (!writer) return writer.error();
  const Status unpacked =
      unpack([&](std::size_t page) { return reader.read_page(page); },
             reader.info().pages.size(), pages, std::move(*writer),
             [&] { return listener(0, 0); }, notes);
  if (!unpacked) return unpacked.error();
  return bytes;
}

void count_pages(const FileInfo& info, JobResult& result) {
  result.pages = info.pages.size();
  for (const PageEntry& page : info.pages) {
    if (page.kind != PageKind::ink) continue;
    result.pixels += static_cast<std::uint64_t>(page.canvas.width) *
                     static_cast<std::uint64_t>(page.canvas.height);
  }
}

}  // namespace

bool Claims::claim(const std::string& path) {
  const std::lock_guard lock(mutex_);
  return paths_.insert(path).second;
}

JobResult compress_job(const BatchInput& input, const JobOptions& options,
                       const Listener& listener) {
  JobResult result;
  result.input_bytes = input.bytes;
  const std::string output =
      (fs::path(options.output_folder) / (input.relative + ".ustp")).string();
  result.outputs = {output};
  if (!options.force && !options.resume && exists(output)) {
    return failure(std::move(result), output,
                   output_exists(Existing::foreign, false));
  }
  Result<Source> source = Source::open(input.path, options.read);
  if (!source) return failure(std::move(result), input.path, source.error());
  if (source->is_ustp()) {
    return failure(std::move(result), input.path,
                   {ErrorCode::unsupported, "is a .ustp file already"});
  }
  PackOptions pack_options = options.pack;
  if (options.record) {
    pack_options.metadata.emplace_back(kSourceSizeKey, record_of_size(*source));
    pack_options.metadata.emplace_back(kSourceCrcKey, record_of_crc(*source));
  }
  const auto encode = [&]() -> Result<std::vector<std::uint8_t>> {
    Result<Packed> packed = pack(*source, pack_options, options.jobs, listener);
    if (!packed) return packed.error();
    result.pages = packed->pages;
    result.pixels = packed->pixels;
    result.lossless = packed->lossless;
    result.pixel_work = std::move(packed->pixel_work);
    result.notes = std::move(packed->notes);
    return std::move(packed->bytes);
  };
  bool output_failed = false;
  const Result<bool> finished =
      write_output(output, judge_ustp(output, *source, options), options,
                   encode, result.output_bytes, output_failed);
  if (!finished) {
    return failure(std::move(result), output_failed ? output : input.path,
                   finished.error());
  }
  result.status =
      *finished ? JobResult::Status::skipped : JobResult::Status::done;
  return result;
}

JobResult decompress_job(const BatchInput& input, const JobOptions& options,
                         Claims& claims, const Listener& listener) {
  JobResult result;
  result.input_bytes = input.bytes;
  const Result<std::vector<std::uint8_t>> bytes =
      read_file(input.path, options.read.limits.max_memory);
  if (!bytes) return failure(std::move(result), input.path, bytes.error());
  const Result<UstpReader> reader = UstpReader::open(
      *bytes, {options.read.limits, options.jobs,
               [&](std::uint64_t, std::uint64_t) { return listener(0, 0); }});
  if (!reader) return failure(std::move(result), input.path, reader.error());
  const Result<DecompressPlan> plan = plan_job(input, options, reader->info());
  if (!plan) return failure(std::move(result), input.path, plan.error());
  count_pages(reader->info(), result);
  result.status = JobResult::Status::skipped;
  for (const OutputFile& file : plan->files) {
    result.outputs.push_back(file.path);
    if (!claims.claim(file.path)) {
      return failure(std::move(result), file.path,
                     {ErrorCode::output_exists,
                      "another file of this batch has this name"});
    }
    const auto encode = [&] {
      return bytes_of(*reader, file.pages, plan->format, options.read.limits,
                      listener, result.notes);
    };
    bool output_failed = false;
    const Result<bool> finished =
        write_output(file.path, judge_file(file, *reader, options), options,
                     encode, result.output_bytes, output_failed);
    if (!finished) {
      return failure(std::move(result), output_failed ? file.path : input.path,
                     finished.error());
    }
    if (!*finished) result.status = JobResult::Status::done;
  }
  return result;
}

}  // namespace unstep::cli
