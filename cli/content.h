#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "unstep/codec.h"
#include "unstep/result.h"

/// What the pages of a .ustp file hold, counted.
namespace unstep::cli {

struct Content {
  std::uint64_t pixels = 0;
  std::uint64_t chains = 0;
  std::uint64_t paths = 0;
  std::uint64_t lines = 0;
  std::uint64_t arcs = 0;
  std::uint64_t steps = 0;  ///< of chains, or that lines and arcs draw
  /// Strokes: how many paths a pen of each width draws, path units.
  std::map<std::int32_t, std::uint64_t> pens;

  Content& operator+=(const Content& more);
};

struct Contents {
  std::vector<Content> pages;
  Content sum;
};

/// Pages of ink and chains are counted by their heads; pages of
/// paths are decoded, and drawn to know their steps: 4-connected if they are
/// filled or the device's, else 8-connected.
Result<Contents> contents_of(const UstpReader& reader,
                             const DecodeLimits& limits);

/// 0 of nothing.
[[nodiscard]] double bits_per(std::uint64_t bytes, std::uint64_t count);

[[nodiscard]] std::string coder_name(std::uint8_t coder);
[[nodiscard]] std::string_view form_name(FileInfo::Form form);
[[nodiscard]] std::string_view kind_name(PageKind kind);
[[nodiscard]] std::string_view fidelity_name(const Fidelity& fidelity);

}  // namespace unstep::cli
