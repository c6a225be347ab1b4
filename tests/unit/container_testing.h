#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "codec/block_coder.h"
#include "codec/checksum.h"
#include "codec/container_encoder.h"
#include "codec/stored_coder.h"
#include "unstep/codec.h"

/// What the tests of the container share.
namespace unstep::testing {

using Bytes = std::vector<std::uint8_t>;

/// Ink with runs: every pixel repeats its left neighbour more often than not.
inline Bitmap random_ink(std::int32_t width, std::int32_t height,
                         unsigned seed) {
  Bitmap ink = *Bitmap::create(width, height);
  std::mt19937 random(seed);
  bool now = false;
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      if (random() % 5 == 0) now = !now;
      ink.set(x, y, now);
    }
  }
  return ink;
}

/// Ink from rows of '.' and '#'.
inline Bitmap ink_of(const std::vector<std::string>& rows) {
  Bitmap ink = *Bitmap::create(static_cast<std::int64_t>(rows.at(0).size()),
                               static_cast<std::int64_t>(rows.size()));
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      ink.set(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
              rows[y][x] == '#');
    }
  }
  return ink;
}

/// A page of coder 0, whatever the default coder is.
inline codec::PageParts stored_page(const Bitmap& ink, std::int32_t bands,
                                    PageInfo info = {}) {
  codec::PageParts page;
  page.canvas = {ink.width(), ink.height(), YAxis::down};
  page.info = std::move(info);
  page.checksum = ink.crc32();
  for (std::int32_t i = 0; i < bands; ++i) {
    const auto edge = [&](std::int32_t k) { return ink.height() * k / bands; };
    codec::BlockParts block;
    block.first_row = edge(i);
    block.rows = edge(i + 1) - edge(i);
    block.encoded.payload =
        *codec::encode_stored(ink, block.first_row, block.rows);
    block.checksum = codec::crc_rows(ink, block.first_row, block.rows);
    block.box = {0, block.first_row, static_cast<std::uint32_t>(ink.width()),
                 static_cast<std::uint32_t>(block.rows)};
    page.blocks.push_back(std::move(block));
  }
  return page;
}

inline Bytes write_pages(std::span<const Bitmap> pages, EncodeOptions options,
                         const PageInfo& info = {}) {
  UstpWriter writer(std::move(options));
  for (const Bitmap& ink : pages) {
    const Status added = writer.add_page(ink, info);
    EXPECT_TRUE(added) << added.error().message;
  }
  Result<Bytes> file = writer.finish();
  EXPECT_TRUE(file) << file.error().message;
  return file ? *std::move(file) : Bytes{};
}

inline Result<UstpReader> open(std::span<const std::uint8_t> file,
                               int jobs = 1) {
  DecodeOptions options;
  options.jobs = jobs;
  return UstpReader::open(file, std::move(options));
}

}  // namespace unstep::testing
