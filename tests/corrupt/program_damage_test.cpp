#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <string>

#include "unstep/program.h"

namespace unstep {
namespace {

std::string sample(const char* name) {
  std::ifstream file(std::string(UNSTEP_SOURCE_DIR "/tests/programs/") + name,
                     std::ios::binary);
  return {std::istreambuf_iterator<char>(file),
          std::istreambuf_iterator<char>()};
}

/// An error of one line that says where, or a program that can be used.
void expect_sound(const std::string& text) {
  const Result<Program> program = read_gcode(text, {});
  if (!program) {
    EXPECT_NE(program.error().code, ErrorCode::internal);
    EXPECT_EQ(program.error().message.rfind("line ", 0), 0U)
        << program.error().message;
    EXPECT_EQ(program.error().message.find('\n'), std::string::npos);
    return;
  }
  CompactOptions options;
  options.tolerance_mm = 0.01;
  EXPECT_TRUE(compact(*program, options));
}

constexpr const char* kSamples[] = {"arcs.ngc", "inch.ngc", "incremental.ngc",
                                    "offsets.ngc", "parameters.ngc"};

TEST(damaged_programs, are_sound_when_cut_at_every_byte) {
  for (const char* name : kSamples) {
    const std::string whole = sample(name);
    ASSERT_FALSE(whole.empty()) << name;
    for (std::size_t size = 0; size < whole.size(); ++size) {
      expect_sound(whole.substr(0, size));
    }
  }
}

TEST(damaged_programs, are_sound_with_every_bit_flipped) {
  for (const char* name : kSamples) {
    std::string text = sample(name);
    for (std::size_t bit = 0; bit < text.size() * 8; ++bit) {
      text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
      expect_sound(text);
      text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
    }
  }
}

TEST(hostile_programs, end_in_an_error_and_in_time) {
  const auto begin = std::chrono::steady_clock::now();
  expect_sound(std::string(1 << 20, '('));
  expect_sound(std::string(1 << 20, 'G'));
  expect_sound("G1 X" + std::string(60'000, '[') + "\n");
  expect_sound("G1 X" + std::string(60'000, '#') + "1\n");
  expect_sound("G1 X[" + std::string(30'000, '-') + "1]\n");
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "#[#1+1]=#1\n/M123\n";
  expect_sound(text);
  // Back and forth: every vertex is a turning point of the last one's line.
  text = "G0 X0 Y0 Z0\nG1 F9\n";
  for (int i = 0; i < 20'000; ++i) {
    text += "X" + std::to_string(i % 2 == 0 ? 0.009 : -0.0004) + "\n";
  }
  expect_sound(text);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

}  // namespace
}  // namespace unstep
