// Runs commands in turn, A B A B, and prints what their processes cost.
//
//     process_cost RUNS COMMAND ARG... -- COMMAND ARG...
//
// One line per command: median wall ms, median processor ms (user + system)
// and the greatest resident set in bytes. Standard output of the commands is
// dropped. A small parent, because the kernel counts the parent's resident
// pages at the fork as the child's.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

extern char** environ;

namespace {

struct Command {
  std::vector<char*> argv;  // ends with nullptr
  std::vector<double> wall_ms;
  std::vector<double> cpu_ms;
  long max_rss_kib = 0;
};

double milliseconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) * 1e3 +
         static_cast<double>(t.tv_usec) / 1e3;
}

bool run(Command& command, posix_spawn_file_actions_t* actions) {
  const auto start = std::chrono::steady_clock::now();
  pid_t pid = 0;
  if (posix_spawnp(&pid, command.argv[0], actions, nullptr, command.argv.data(),
                   environ) != 0) {
    std::fprintf(stderr, "process_cost: cannot run %s\n", command.argv[0]);
    return false;
  }
  int status = 0;
  rusage usage{};
  if (wait4(pid, &status, 0, &usage) != pid || !WIFEXITED(status) ||
      WEXITSTATUS(status) != 0) {
    std::fprintf(stderr, "process_cost: %s failed\n", command.argv[0]);
    return false;
  }
  const std::chrono::duration<double, std::milli> wall =
      std::chrono::steady_clock::now() - start;
  command.wall_ms.push_back(wall.count());
  command.cpu_ms.push_back(milliseconds(usage.ru_utime) +
                           milliseconds(usage.ru_stime));
  command.max_rss_kib = std::max(command.max_rss_kib, usage.ru_maxrss);
  return true;
}

double median(std::vector<double> values) {
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Command> parse(int argc, char** argv) {
  std::vector<Command> commands;
  for (int i = 2; i < argc; ++i) {
    if (i == 2 || std::string_view(argv[i]) == "--") {
      if (!commands.empty()) commands.back().argv.push_back(nullptr);
      commands.emplace_back();
    }
    if (std::string_view(argv[i]) != "--") {
      commands.back().argv.push_back(argv[i]);
    }
  }
  if (!commands.empty()) commands.back().argv.push_back(nullptr);
  return commands;
}

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 2 ? std::atoi(argv[1]) : 0;
  std::vector<Command> commands = parse(argc, argv);
  const bool complete =
      std::all_of(commands.begin(), commands.end(),
                  [](const Command& c) { return c.argv.size() > 1; });
  if (runs < 1 || commands.empty() || !complete) {
    std::fprintf(stderr,
                 "usage: process_cost RUNS COMMAND ARG... [-- COMMAND ...]\n");
    return 2;
  }

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  for (int i = 0; i < runs; ++i) {
    for (Command& command : commands) {
      if (!run(command, &actions)) return 1;
    }
  }
  posix_spawn_file_actions_destroy(&actions);

  for (const Command& command : commands) {
    std::printf("%.3f %.3f %ld\n", median(command.wall_ms),
                median(command.cpu_ms), command.max_rss_kib * 1024);
  }
  return 0;
}
