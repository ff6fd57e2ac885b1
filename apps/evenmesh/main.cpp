// SPDX-License-Identifier: MIT
//
// The command line: parse, call, report, exit code. No mathematics.
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/config.h"
#include "apps/evenmesh/exit_code.h"
#include "apps/evenmesh/options.h"
#include "evenmesh/base/error.h"
#include "evenmesh/base/version.h"

namespace evenmesh::app {
namespace {

std::atomic<bool> interrupt_asked = false;

// The first Ctrl-C asks the solver to stop at its best iterate, the second ends the program.
extern "C" void on_interrupt(int signal) {
  interrupt_asked = true;
  std::signal(signal, SIG_DFL);
}

constexpr const char* kExamples = R"(Examples:
  evenmesh part.obj -o even.obj          make it even; shape, features and groups are kept
  evenmesh check part.stl                measure it; exit code 4 if a cell is inverted
  evenmesh report a.obj b.obj -o r.html  see how two files with the same cells differ
  evenmesh grid.obj -o out.obj --cost local=0.3,barycenter=0.3 --fix boundary

Makes the cells of a mesh even by moving its vertices, never its connectivity, and never
hands back a mesh that is worse. Reads and patches OBJ, STL, OFF, PLY, Gmsh MSH,
VTK (.vtk, .vtu, .vtp), MEDIT (.mesh, .meshb), SU2, Exodus, AVS UCD and decks of Abaqus,
CalculiX and Nastran, gzipped or not.
)";

constexpr const char* kExitCodes = R"(
Selectors (SEL): all, none, boundary, features, corners, interface, non_manifold, id:1,5-9,
  box:x0,y0,z0,x1,y1,z1, group:NAME, nset:NAME, elset:NAME, marker:NAME,
  array:NAME==1, combined with + - & from left to right.
Exit codes: 0 done; 1 internal error; 2 wrong usage; 3 a file cannot be read or written;
  4 check found inverted cells, or a demand is not met (what could be had was written);
  5 refused, nothing written; 130 interrupted.
)";

// The command line, quoted so that a shell takes it back.
std::string command_line(int argc, char** argv) {
  std::string text;
  for (int i = 0; i < argc; ++i) {
    const std::string argument = argv[i];
    if (i > 0) text += ' ';
    if (!argument.empty() &&
        argument.find_first_of(" \t\n'\"\\$`&|;<>()*?[]#~!{}") == std::string::npos) {
      text += argument;
      continue;
    }
    text += '\'';
    for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

// An option of smoothing that stands before a verb, where it would have no effect; empty if none.
std::string misplaced_option(CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (name == "--threads" || name == "--quiet" || name == "--verbose") continue;
    if (option->count() > 0) return option->get_positional() ? option->as<std::string>() : name;
  }
  return "";
}

std::string neither(const std::string& word) {
  return fmt::format(
      "'{}' is neither a file nor a command; the commands are check, info, report and demo", word);
}

// What the parser makes of a misspelt verb ("too many files") is no help.
std::string explain(const CLI::ParseError& error, const std::string& file) {
  const bool surplus = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  return surplus && !file.empty() && !std::filesystem::exists(file) ? neither(file) : error.what();
}

int wrong_usage(const std::string& what) {
  fmt::print(stderr, "evenmesh: {}\nTry: evenmesh --help\n", what);
  return kBadUsage;
}

int run(int argc, char** argv) {
  SmoothArguments smooth;
  CheckArguments checked;
  InputArguments inspected;
  CompareArguments compared;
  DemoArguments shown;
  CommonArguments common;
  smooth.command = checked.command = compared.command = command_line(argc, argv);

  CLI::App app{kExamples, "evenmesh"};
  app.footer(kExitCodes);
  app.set_version_flag("--version", std::string("evenmesh ") + kVersion);
  app.require_subcommand(0, 1);
  add_input(app, smooth.input, false);
  add_smooth_options(app, smooth);
  add_common(app, common);

  CLI::App* check = app.add_subcommand("check", "measure the cells of a mesh");
  add_input(*check, checked.input, true);
  add_html(*check, checked.html);
  CLI::App* info = app.add_subcommand("info", "say what is in a mesh file");
  add_input(*info, inspected, true);
  CLI::App* report = app.add_subcommand(
      "report", "show in a browser how two files with the same cells differ (HTML)");
  report->add_option("BEFORE", compared.before.path, "a mesh file")->required();
  report->add_option("AFTER", compared.after, "one with the same cells")->required();
  report->add_option("-o,--output", compared.html.path, "the report to write")->required();
  add_html_size(*report, compared.html);
  add_analysis(*report, compared.before);
  CLI::App* demo = app.add_subcommand("demo", "repeat figures of the paper, and write pictures");
  demo->add_option("figures", shown.figures, "fig5 ... fig31, all, or list; none: fig5 fig7 fig9");
  demo->add_option("-o,--output", shown.folder, "a folder for pictures; none: no files")
      ->type_name("FOLDER");
  for (CLI::App* verb : {check, info, report, demo}) add_common(*verb, common);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return wrong_usage(explain(error, smooth.input.path));
  }
  for (const CLI::App* verb : app.get_subcommands()) {
    const std::string misplaced = misplaced_option(app);
    if (misplaced.empty()) continue;
    return wrong_usage(fmt::format("'{}' before {} has no meaning", misplaced, verb->get_name()));
  }

  if (!smooth.config.empty()) read_config(smooth.config, app);
  smooth.effective = effective_options(app);

  Console console(common.quiet     ? Verbosity::quiet
                  : common.verbose ? Verbosity::verbose
                                   : Verbosity::normal);
  checked.threads = compared.threads = common.threads;
  if (*check) return check_command(checked, console);
  if (*report) return compare_command(compared, console);
  if (*info) return info_command(inspected, console);
  if (*demo) return demo_command(shown, console);
  if (smooth.input.path.empty()) {
    fmt::print(stderr, "evenmesh: no mesh file given\nTry: evenmesh part.obj -o even.obj\n");
    return kBadUsage;
  }
  if (smooth.output.empty() && !std::filesystem::exists(smooth.input.path)) {
    return wrong_usage(neither(smooth.input.path));
  }
  // Who started it in the background may have asked to ignore Ctrl-C.
  if (std::signal(SIGINT, on_interrupt) == SIG_IGN) std::signal(SIGINT, SIG_IGN);
  smooth.threads = common.threads;
  return smooth_command(smooth, console, [] { return interrupt_asked.load(); });
}

// A mesh file must not get the number of a standard stream that the caller closed: what is printed
// would end up in it.
void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // open() takes the lowest free number, which is this one.
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) ::open("/dev/null", O_RDWR);
  }
}

// Results that did not arrive (a full disk behind stdout) are no success.
int flushed(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr, "evenmesh: what was to be printed did not reach standard output\n");
  return code == kDone ? kBadFile : code;
}

}  // namespace
}  // namespace evenmesh::app

int main(int argc, char** argv) {
  using namespace evenmesh;
  const auto fail = [](const char* what, int code) {
    fmt::print(stderr, "evenmesh: {}\n", what);
    return code;
  };
  app::open_closed_streams();
  try {
    return app::flushed(app::run(argc, argv));
  } catch (const InvalidOption& error) {
    return fail(error.what(), app::kBadUsage);
  } catch (const Error& error) {
    return fail(error.what(), app::kBadFile);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", app::kInternalError);
  } catch (const std::exception& error) {
    return fail(error.what(), app::kInternalError);
  }
}
