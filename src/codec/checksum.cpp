#include "codec/checksum.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace unstep::codec {
namespace {

Error bad_chain(std::size_t chain, const std::string& reason) {
  return Error{ErrorCode::invalid_argument,
               "chain " + std::to_string(chain + 1) + ": " + reason};
}

struct Bounds {
  Point low{kMaxCoord, kMaxCoord};
  Point high{-kMaxCoord, -kMaxCoord};

  void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

bool in_range(Point p) {
  return p.x >= -kMaxCoord && p.x <= kMaxCoord && p.y >= -kMaxCoord &&
         p.y <= kMaxCoord;
}

Status walk(const Chain& chain, std::size_t number, YAxis axis,
            Bounds& bounds) {
  if (chain.connectivity != Connectivity::four &&
      chain.connectivity != Connectivity::eight) {
    return bad_chain(number, "connectivity is neither 4 nor 8");
  }
  if (!in_range(chain.origin)) {
    return bad_chain(number, "origin is out of range");
  }
  const std::uint8_t odd = chain.connectivity == Connectivity::four ? 1 : 0;
  Point at = chain.origin;
  bounds.add(at);
  for (std::size_t i = 0; i < chain.steps.size(); ++i) {
    const Step step = chain.steps[i];
    if (step > 7 || (step & odd) != 0) {
      return bad_chain(number, "step " + std::to_string(i + 1) +
                                   " does not fit the connectivity");
    }
    const Point move = step_delta(step, axis);
    at = {at.x + move.x, at.y + move.y};  // |at| <= 2^30 before the check
    if (!in_range(at)) {
      return bad_chain(number,
                       "step " + std::to_string(i + 1) + " leaves the range");
    }
    bounds.add(at);
  }
  if (chain.closed && at != chain.origin) {
    return bad_chain(number, "closed chain does not return to its origin");
  }
  return {};
}

void put_le(std::uint8_t* out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    out[i] = static_cast<std::uint8_t>(value >> (8 * i));
  }
}

}  // namespace

std::uint32_t crc_bytes(std::span<const std::uint8_t> bytes,
                        std::uint32_t seed) {
  if (bytes.empty()) return seed;  // zlib starts anew at a null pointer
  return static_cast<std::uint32_t>(
      ::crc32_z(seed, bytes.data(), bytes.size()));
}

std::uint32_t crc_join(std::uint32_t first, std::uint32_t second,
                       std::uint64_t second_bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_combine(first, second, static_cast<z_off_t>(second_bytes)));
}

std::uint32_t crc_split(std::uint32_t joined, std::uint32_t first,
                        std::uint64_t second_bytes) {
  // crc_join is linear: shift(first) xor second.
  return joined ^ crc_join(first, 0, second_bytes);
}

std::uint32_t crc_rows(const Bitmap& ink, std::int32_t first_row,
                       std::int32_t rows) {
  constexpr std::int32_t kTogether = 32;  // zlib likes long runs of bytes
  const std::size_t row = row_bytes(ink.width());
  std::vector<std::uint8_t> bytes(row * kTogether);
  std::uint32_t crc = 0;
  for (std::int32_t y = 0; y < rows;) {
    const std::int32_t end = y + std::min(kTogether, rows - y);
    std::span<std::uint8_t> rest = bytes;
    for (; y < end; ++y, rest = rest.subspan(row)) {
      ink.get_row_bytes(first_row + y, rest.first(row), false);
    }
    crc = crc_bytes(std::span(bytes).first(bytes.size() - rest.size()), crc);
  }
  return crc;
}

std::uint32_t crc_chains(std::span<const Chain> chains) {
  std::uint32_t crc = 0;
  for (const Chain& chain : chains) {
    std::array<std::uint8_t, 17> head{};
    put_le(&head[0], static_cast<std::uint32_t>(chain.origin.x), 4);
    put_le(&head[4], static_cast<std::uint32_t>(chain.origin.y), 4);
    head[8] = static_cast<std::uint8_t>(
        static_cast<unsigned>(chain.connectivity) | (chain.closed ? 1U : 0U));
    put_le(&head[9], chain.steps.size(), 8);
    crc = crc_bytes(chain.steps, crc_bytes(head, crc));
  }
  return crc;
}

Result<ChainSurvey> survey_chains(std::span<const Chain> chains, YAxis axis) {
  ChainSurvey survey;
  Bounds bounds;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (Status valid = walk(chains[i], i, axis, bounds); !valid) {
      return valid.error();
    }
    survey.steps += chains[i].steps.size();
  }
  if (!chains.empty()) {
    survey.box = {bounds.low.x, bounds.low.y,
                  static_cast<std::uint32_t>(bounds.high.x - bounds.low.x),
                  static_cast<std::uint32_t>(bounds.high.y - bounds.low.y)};
  }
  return survey;
}

}  // namespace unstep::codec
