#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Recordings of encoders, made by the tests.
namespace unstep::test {

/// A zip archive of files that are not compressed (APPNOTE.TXT 4.3).
inline std::string make_zip(
    const std::vector<std::pair<std::string, std::string>>& files) {
  std::string zip;
  std::string directory;
  const auto put = [](std::string& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> 8 * i);
  };
  for (const auto& [name, text] : files) {
    const std::uint64_t crc =
        crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
    std::string common;
    put(common, 20, 2);         // version needed
    put(common, 0, 2 + 2 + 4);  // flags, stored, no time
    put(common, crc, 4);
    put(common, text.size(), 4);
    put(common, text.size(), 4);
    put(common, name.size(), 2);
    put(common, 0, 2);  // extra field
    directory += "PK\1\2";
    put(directory, 20, 2);
    directory += common;
    put(directory, 0, 2 + 2 + 2 + 4);  // comment, disk, attributes
    put(directory, zip.size(), 4);
    directory += name;
    zip += "PK\3\4" + common + name + text;
  }
  const std::size_t at = zip.size();
  zip += directory + "PK\5\6";
  put(zip, 0, 4);
  put(zip, files.size(), 2);
  put(zip, files.size(), 2);
  put(zip, directory.size(), 4);
  put(zip, at, 4);
  put(zip, 0, 2);
  return zip;
}

/// A session of sigrok with one byte a sample, in two pieces.
inline std::string make_session(const std::string& probes,
                                const std::string& samples) {
  const std::size_t half = samples.size() / 2;
  return make_zip({{"version", "2"},
                   {"metadata",
                    "[global]\nsigrok version=0.5.2\n\n[device 1]\n"
                    "capturefile=logic-1\ntotal probes=8\n"
                    "samplerate=2 MHz\ntotal analog=0\n" +
                        probes + "unitsize=1\n"},
                   {"logic-1-1", samples.substr(0, half)},
                   {"logic-1-2", samples.substr(half)}});
}

}  // namespace unstep::test
