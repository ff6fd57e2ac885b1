// SPDX-License-Identifier: MIT
#include "tests/cli/process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace evenmesh::testing {
namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void close_end(std::size_t end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }
  /// Appends what there is; false at the end.
  bool drain(std::string& text) {
    std::array<char, 4096> buffer;
    const ssize_t count = ::read(ends[0], buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return true;
    if (count <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
  }

  std::array<int, 2> ends{-1, -1};
};

// In the child, where nothing but system calls is allowed.
[[noreturn]] void become(char* const* arguments, char* const* environment,
                         const RunOptions& options, int out, int err) {
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGPIPE, SIG_DFL);
  if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) ::_exit(126);
  const int in = ::open("/dev/null", O_RDONLY);
  if (!options.out.empty()) out = ::open(options.out.c_str(), O_WRONLY);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (options.close_out) ::close(STDOUT_FILENO);
  ::execve(EVENMESH_PROGRAM, arguments, environment);
  ::_exit(127);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

pid_t start(const std::vector<std::string>& arguments, const RunOptions& options, Pipe& out,
            Pipe& err) {
  std::vector<std::string> words{"evenmesh"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = options.environment;
  for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
  const std::vector<char*> argv = pointers(words);
  const std::vector<char*> envp = pointers(variables);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become(argv.data(), envp.data(), options, out.ends[1], err.ends[1]);
  out.close_end(1);
  err.close_end(1);
  return child;
}

// Reads both streams until the child has closed them; kills it when its time is over.
void collect(pid_t child, Pipe& out, Pipe& err, Clock::time_point end, Outcome& outcome) {
  while (out.ends[0] >= 0 || err.ends[0] >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    std::array<pollfd, 2> streams{{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
    const int wait = static_cast<int>(std::max<long>(0, left.count()));
    const int ready = ::poll(streams.data(), streams.size(), wait);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) {
      outcome.timed_out = true;
      ::kill(child, SIGKILL);
      return;
    }
    if (streams[0].revents != 0 && !out.drain(outcome.out)) out.close_end(0);
    if (streams[1].revents != 0 && !err.drain(outcome.err)) err.close_end(0);
  }
}

}  // namespace

Outcome run(const std::vector<std::string>& arguments, const RunOptions& options) {
  Outcome outcome;
  Pipe out;
  Pipe err;
  const pid_t child = start(arguments, options, out, err);
  const auto limit = std::chrono::duration<double>(options.time_limit_seconds);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  if (options.meanwhile) options.meanwhile(child);
  collect(child, out, err, end, outcome);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  return outcome;
}

}  // namespace evenmesh::testing
