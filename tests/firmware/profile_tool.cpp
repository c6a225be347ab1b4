#include <cstdio>
#include <fstream>
#include <string>

#include "unstep/step_stream.h"

/// profile_tool FOLDER: a device profile of lines and arcs of every size and
/// direction, as FOLDER/profile.h, and the words of its steps by make_steps,
/// as FOLDER/expected.
namespace unstep {
namespace {

std::string steps(int count) {
  return std::to_string(count / 100) + "." +
         std::to_string(count % 100 + 100).substr(1);
}
std::string signed_steps(int count) {
  return count < 0 ? "-" + steps(-count) : steps(count);
}

std::string sample() {
  std::string text = "G21 G90\nG0 X0 Y0\nG91\n";
  const auto move = [&text](const char* word, int x, int y) {
    text += std::string(word) + " X" + signed_steps(x) + " Y" +
            signed_steps(y) + " F600\n";
  };
  for (const int size : {1, 7, 120, 129, 900}) {
    for (int i = 0; i < 8; ++i) {
      const int x = (i & 1 ? -1 : 1) * (i & 4 ? size : size * 3 / 8 + 1);
      const int y = (i & 2 ? -1 : 1) * (i & 4 ? size / 3 : size);
      move(i % 3 == 0 ? "G0" : "G1", x, y);
    }
  }
  const auto arc = [&text](const char* word, int x, int y, int i, int j) {
    text += std::string(word) + " X" + signed_steps(x) + " Y" +
            signed_steps(y) + " I" + signed_steps(i) + " J" + signed_steps(j) +
            " F600\n";
  };
  for (const int radius : {1, 5, 77, 300}) {
    for (const char* word : {"G2", "G3"}) {
      arc(word, 0, 0, radius, 0);
      arc(word, 2 * radius, 0, radius, 0);
      arc(word, radius, -radius, 0, -radius);
      arc(word, -radius, -radius, -radius, 0);
      arc(word, 0, 0, 3 * radius, -4 * radius);
      arc(word, 7 * radius, -1 * radius, 3 * radius, -4 * radius);
    }
  }
  // Radius and sums that need all bits.
  text += "G2 X0.5 Y0.01 I0.251 J-300\nG1 X340 Y0.4\nM2\n";
  return text;
}

int write(const std::string& folder) {
  const Result<Program> program = read_gcode(sample(), {});
  if (!program) {
    std::fprintf(stderr, "%s\n", program.error().message.c_str());
    return 1;
  }
  const Result<std::string> profile = write_device_profile(*program, {});
  const Result<StepStream> stream = make_steps(*program, StepMakeOptions{});
  if (!profile || !stream) {
    std::fprintf(stderr, "%s\n",
                 (profile ? stream.error() : profile.error()).message.c_str());
    return 1;
  }
  std::ofstream header(folder + "/profile.h");
  header << "#include <avr/pgmspace.h>\n#include <stdint.h>\n"
            "static const uint8_t profile[] PROGMEM = {";
  for (const char byte : *profile) {
    header << static_cast<int>(static_cast<unsigned char>(byte)) << ",";
  }
  header << "};\n";
  std::ofstream expected(folder + "/expected", std::ios::binary);
  for (const StepRun& run : stream->runs) {
    for (const StepWord word : run.words) {
      expected.put(static_cast<char>(word | (run.rapid ? 16 : 0)));
    }
  }
  return header && expected ? 0 : 1;
}

}  // namespace
}  // namespace unstep

int main(int argc, char** argv) {
  return argc == 2 ? unstep::write(argv[1]) : 2;
}
