#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "formats/pulse_chain.h"
#include "formats/text_scanner.h"

/// Sessions of sigrok (sigrok.org, "File format:Sigrok/v2"): a zip archive with
/// a text "metadata" and the samples, "logic-1-1", "logic-1-2" and so on.
namespace unstep {
namespace {

/// The archive in memory, for minizip to read and seek in.
struct MemoryFile {
  std::span<const std::uint8_t> bytes;
  std::uint64_t at = 0;
};

MemoryFile& file_of(voidpf stream) { return *static_cast<MemoryFile*>(stream); }

zlib_filefunc64_def memory_functions(MemoryFile& file) {
  zlib_filefunc64_def functions{};
  functions.opaque = &file;
  functions.zopen64_file = [](voidpf opaque, const void*, int) -> voidpf {
    return opaque;
  };
  functions.zread_file = [](voidpf, voidpf stream, void* to,
                            uLong size) -> uLong {
    MemoryFile& from = file_of(stream);
    const std::uint64_t left = from.bytes.size() - from.at;
    const auto count =
        static_cast<std::size_t>(std::min<std::uint64_t>(size, left));
    if (count > 0) std::memcpy(to, from.bytes.data() + from.at, count);
    from.at += count;
    return static_cast<uLong>(count);
  };
  functions.ztell64_file = [](voidpf, voidpf stream) -> ZPOS64_T {
    return file_of(stream).at;
  };
  functions.zseek64_file = [](voidpf, voidpf stream, ZPOS64_T offset,
                              int origin) -> long {
    MemoryFile& in = file_of(stream);
    const std::uint64_t from = origin == ZLIB_FILEFUNC_SEEK_CUR ? in.at
                               : origin == ZLIB_FILEFUNC_SEEK_END
                                   ? in.bytes.size()
                                   : 0;
    if (offset > in.bytes.size() - from) return -1;
    in.at = from + offset;
    return 0;
  };
  functions.zclose_file = [](voidpf, voidpf) { return 0; };
  functions.zerror_file = [](voidpf, voidpf) { return 0; };
  return functions;
}

class Archive {
 public:
  explicit Archive(std::span<const std::uint8_t> bytes) : memory_{bytes, 0} {
    zlib_filefunc64_def functions = memory_functions(memory_);
    zip_ = unzOpen2_64("", &functions);
  }
  ~Archive() {
    if (zip_ != nullptr) unzClose(zip_);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  [[nodiscard]] bool is_open() const { return zip_ != nullptr; }
  bool find(const std::string& name) {
    return unzLocateFile(zip_, name.c_str(), 1) == UNZ_OK;
  }

  /// Gives the found file piece by piece. The CRC counts at the end.
  template <class Take>
  Status read(const std::string& name, const Take& take) {
    if (unzOpenCurrentFile(zip_) != UNZ_OK) {
      return Error{ErrorCode::corrupt, name + ": cannot be unpacked"};
    }
    std::array<char, 1 << 16> piece{};
    int size = 0;
    Status taken;
    while (taken &&
           (size = unzReadCurrentFile(zip_, piece.data(), piece.size())) > 0) {
      taken =
          take(std::string_view(piece.data(), static_cast<std::size_t>(size)));
    }
    const int closed = unzCloseCurrentFile(zip_);
    if (!taken) return taken;
    if (size < 0) return Error{ErrorCode::corrupt, name + ": damaged"};
    if (closed == UNZ_CRCERROR) {
      return Error{ErrorCode::checksum_mismatch,
                   name + ": is not what was packed"};
    }
    return {};
  }

 private:
  MemoryFile memory_;
  unzFile zip_ = nullptr;
};

struct Session {
  std::string samples = "logic-1";
  std::size_t unit = 0;  ///< bytes a sample
  double rate = 0;       ///< Hz; 0: unknown
  std::vector<std::string> names;
  std::vector<std::size_t> bits;  ///< of the names
};

/// "24 MHz", "1000000"
double parse_rate(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, value);
  if (failed != std::errc{} || !(value > 0)) return 0;
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  if (unit.find("GHz") != std::string_view::npos) return value * 1e9;
  if (unit.find("MHz") != std::string_view::npos) return value * 1e6;
  if (unit.find("kHz") != std::string_view::npos) return value * 1e3;
  return value;
}

/// Of the first device. Keys and values are parted by "=".
Result<Session> parse_metadata(std::string_view text) {
  Session session;
  std::size_t devices = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with("[device")) ++devices;
    const std::size_t equals = line.find('=');
    if (devices != 1 || equals == std::string_view::npos) continue;
    const std::string_view key = line.substr(0, equals);
    const std::string_view value = line.substr(equals + 1);
    std::size_t number = 0;
    if (key == "capturefile") {
      session.samples = value.substr(0, 200);
    } else if (key == "samplerate") {
      session.rate = parse_rate(value);
    } else if (key == "unitsize") {
      if (!parse_whole(value, session.unit)) session.unit = 0;
    } else if (key.starts_with("probe") && parse_whole(key.substr(5), number) &&
               number >= 1) {
      session.names.emplace_back(value);
      session.bits.push_back(number - 1);
    }
  }
  constexpr std::size_t kMostBytes = 64;
  if (session.unit < 1 || session.unit > kMostBytes) {
    return Error{ErrorCode::unsupported,
                 "metadata: no logic channels (unitsize 1 to 64)"};
  }
  for (const std::size_t bit : session.bits) {
    if (bit / 8 >= session.unit) {
      return Error{ErrorCode::corrupt, "metadata: probe" +
                                           std::to_string(bit + 1) +
                                           " is beyond the bytes of a sample"};
    }
  }
  return session;
}

/// Bytes to samples, across pieces.
class Samples {
 public:
  Samples(const Session& session, std::vector<std::size_t> bits,
          PulseChain& chain)
      : session_(session), bits_(std::move(bits)), chain_(chain) {
    sample_.reserve(session.unit);
  }

  Status take(std::string_view piece) {
    while (!piece.empty()) {
      const std::size_t count =
          std::min(piece.size(), session_.unit - sample_.size());
      sample_ += piece.substr(0, count);
      piece.remove_prefix(count);
      if (sample_.size() < session_.unit) continue;
      if (Status done = count_sample(); !done) return done;
      sample_.clear();
    }
    return {};
  }

  [[nodiscard]] bool is_whole() const { return sample_.empty(); }

 private:
  Status count_sample() {
    unsigned levels = 0;
    for (std::size_t i = 0; i < bits_.size(); ++i) {
      const auto byte = static_cast<unsigned char>(sample_[bits_[i] / 8]);
      levels |= (byte >> bits_[i] % 8 & 1U) << i;
    }
    const Result<bool> illegal = chain_.sample(levels);
    if (!illegal) return illegal.error();
    if (*illegal) {
      const auto index = static_cast<double>(chain_.samples() - 1);
      chain_.note_illegal(session_.rate > 0
                              ? time_text(index / session_.rate)
                              : "sample " + std::to_string(chain_.samples()));
    }
    return {};
  }

  const Session& session_;
  std::vector<std::size_t> bits_;
  PulseChain& chain_;
  std::string sample_;
};

Result<Session> read_session(Archive& archive) {
  constexpr std::size_t kMost = 1 << 20;
  if (!archive.find("metadata")) {
    return Error{ErrorCode::bad_magic, "not a sigrok session: no metadata"};
  }
  std::string text;
  Status read = archive.read("metadata", [&](std::string_view piece) -> Status {
    text += piece;
    if (text.size() <= kMost) return {};
    return Error{ErrorCode::limit_exceeded, "metadata of more than 1 MiB"};
  });
  if (!read) return read.error();
  return parse_metadata(text);
}

}  // namespace

bool is_sigrok(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 4> kZip{'P', 'K', 3, 4};
  if (bytes.size() < kZip.size() ||
      !std::equal(kZip.begin(), kZip.end(), bytes.begin())) {
    return false;
  }
  Archive archive(bytes);
  return archive.is_open() && archive.find("metadata");
}

Result<VectorPage> read_pulse_sigrok(std::span<const std::uint8_t> bytes,
                                     const PulseReadOptions& options) {
  Archive archive(bytes);
  if (!archive.is_open()) {
    return Error{ErrorCode::bad_magic, "not a zip archive, or a damaged one"};
  }
  const Result<Session> session = read_session(archive);
  if (!session) return session.error();
  const auto chosen = choose_channels(session->names, options.channels);
  if (!chosen) return chosen.error();
  std::vector<std::size_t> bits;
  for (const std::size_t i : *chosen) bits.push_back(session->bits[i]);
  PulseChain chain(options, bits.size());
  Samples samples(*session, std::move(bits), chain);
  const auto read = [&](const std::string& name) {
    return archive.read(
        name, [&](std::string_view piece) { return samples.take(piece); });
  };
  if (archive.find(session->samples)) {
    if (Status done = read(session->samples); !done) return done.error();
  } else {
    for (std::size_t part = 1;; ++part) {
      const std::string name = session->samples + "-" + std::to_string(part);
      if (archive.find(name)) {
        if (Status done = read(name); !done) return done.error();
      } else if (part == 1 || archive.find(session->samples + "-" +
                                           std::to_string(part + 1))) {
        return Error{ErrorCode::truncated, name + " is missing"};
      } else {
        break;
      }
    }
  }
  if (!samples.is_whole()) {
    return Error{ErrorCode::truncated,
                 session->samples + " ends inside a sample"};
  }
  return chain.finish("sigrok");
}

}  // namespace unstep
