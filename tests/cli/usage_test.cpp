// SPDX-License-Identifier: MIT
//
// Wrong use: the exit code says what kind of mistake it was, the message what to do, and no file
// is touched.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/cli/meshes.h"
#include "tests/cli/process.h"
#include "tests/io/temporary_folder.h"

namespace evenmesh {
namespace {

using testing::Outcome;
using testing::read_bytes;
using testing::run;
using testing::TemporaryFolder;

constexpr int kUsage = 2;
constexpr int kFile = 3;

class Usage : public ::testing::Test {
 protected:
  Usage() { folder_.write("in.obj", testing::kCanImprove); }

  /// Runs in a folder that holds in.obj and nothing else, and expects that to stay so.
  Outcome expect_failure(int exit_code, const std::vector<std::string>& arguments,
                         const std::string& part_of_message) {
    const std::size_t files = folder_.count_files();
    const Outcome outcome = run(arguments, {.folder = folder_.path().string()});
    const std::string shown = ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << shown << outcome.err;
    EXPECT_EQ(outcome.out, "") << shown;
    EXPECT_NE(outcome.err.find("evenmesh: "), std::string::npos) << shown << outcome.err;
    EXPECT_NE(outcome.err.find(part_of_message), std::string::npos) << shown << outcome.err;
    EXPECT_EQ(folder_.count_files(), files) << shown;
    EXPECT_EQ(read_bytes(folder_.path() / "in.obj"), testing::kCanImprove) << shown;
    return outcome;
  }
  void expect_bad_option(const std::string& option, const std::string& value,
                         const std::string& part_of_message) {
    expect_failure(kUsage, {"in.obj", "-o", "out.obj", option, value}, part_of_message);
  }

  TemporaryFolder folder_;
};

TEST_F(Usage, NoArgumentsShowWhatToType) { expect_failure(kUsage, {}, "Try: evenmesh part.obj"); }

TEST_F(Usage, UnknownOptionsAreNamed) {
  expect_failure(kUsage, {"in.obj", "-o", "out.obj", "--bogus"}, "--bogus");
  expect_failure(kUsage, {"--bogus"}, "Try: evenmesh --help");
}

TEST_F(Usage, OptionsOfOneSolverAreNotForAnother) {
  expect_bad_option("--eta", "1e-3", "--eta is where --solver dense stops");
}

TEST_F(Usage, UnknownMethodsGetASuggestion) {
  expect_bad_option("--method", "laplacain", "did you mean 'laplacian'?");
  expect_bad_option("--method", "newton", "known are lagrange_newton, laplacian,");
}

TEST_F(Usage, ClassicMethodsRefuseWhatTheyCannotDo) {
  const std::vector<std::string> laplacian = {"in.obj", "-o", "out.obj", "--method", "laplacian"};
  const auto with = [&](const std::string& option, const std::string& value) {
    std::vector<std::string> arguments = laplacian;
    arguments.insert(arguments.end(), {option, value});
    return arguments;
  };
  expect_failure(kUsage, with("--solver", "newton"), "--method laplacian has no use for it");
  expect_failure(kUsage, with("--min-jacobian", "0.1"),
                 "the method laplacian cannot keep cells above a least size or Jacobian");
  expect_failure(kUsage, with("--keep", "area"), "the method laplacian cannot keep");
}

TEST_F(Usage, MisspeltVerbsAreTakenAsSuch) {
  expect_failure(kUsage, {"chekc", "in.obj"}, "'chekc' is neither a file nor a command");
  expect_failure(kUsage, {"chekc"}, "the commands are check, info, report and demo");
}

TEST_F(Usage, VerbsTakeNoOptionsWithoutMeaning) {
  expect_failure(kUsage, {"check", "in.obj", "-o", "out.obj"}, "-o");
  expect_failure(kUsage, {"-o", "out.obj", "check", "in.obj"}, "'--output' before check");
  expect_failure(kUsage, {"check", "in.obj", "other.obj"}, "other.obj");
  expect_failure(kUsage, {"demo", "fig5", "--fix", "boundary"}, "--fix");
}

TEST_F(Usage, InputThatIsNoFileIsNamed) {
  expect_failure(kFile, {"missing.obj", "-o", "out.obj"}, "missing.obj: cannot be opened");
  expect_failure(kFile, {".", "-o", "out.obj"}, ".: is a folder");
  expect_failure(kFile, {"/dev/null", "-o", "out.obj"}, "/dev/null: is not a regular file");
  ASSERT_EQ(::mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  expect_failure(kFile, {"pipe", "-o", "out.obj"}, "pipe: is not a regular file");
  for (const char* verb : {"check", "info"}) {
    expect_failure(kFile, {verb, "missing.obj"}, "missing.obj: cannot be opened");
  }
}

TEST_F(Usage, OutputMustBeNamedAndNotTheInput) {
  expect_failure(kUsage, {"in.obj"}, "add -o OUT");
  expect_failure(kUsage, {"in.obj", "-o", "in.obj"}, "use --in-place");
  expect_failure(kUsage, {"in.obj", "-o", "./in.obj"}, "use --in-place");
  std::filesystem::create_symlink("in.obj", folder_.path() / "link.obj");
  expect_failure(kUsage, {"in.obj", "-o", "link.obj"}, "use --in-place");
  expect_failure(kUsage, {"in.obj", "-o", "out.obj", "--in-place"}, "exclude each other");
}

TEST_F(Usage, OutputThatCannotBeWrittenIsFoundBeforeTheWork) {
  const Outcome missing =
      expect_failure(kFile, {"in.obj", "-o", "no/out.obj"}, "no/out.obj: cannot be written");
  EXPECT_EQ(missing.err.find("converged"), std::string::npos) << missing.err;
  expect_failure(kFile, {"in.obj", "-o", "."}, ".: is a folder");
  expect_failure(kFile, {"in.obj", "-o", "/dev/null"}, "/dev/null: is not a regular file");
  expect_failure(kFile, {"in.obj", "-o", "out.stl"}, "does not convert");
}

TEST_F(Usage, FoldersWithoutPermissionAreRefused) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const auto closed = folder_.path() / "closed";
  std::filesystem::create_directory(closed);
  std::filesystem::permissions(closed, std::filesystem::perms::owner_read);
  expect_failure(kFile, {"in.obj", "-o", "closed/out.obj"}, "Permission denied");
  expect_failure(kFile, {"in.obj", "-o", "out.obj", "--json", "closed/r.json"},
                 "closed/r.json: cannot be written: Permission denied");
}

TEST_F(Usage, ReportMustNotOverwriteAMesh) {
  expect_bad_option("--json", "in.obj", "would overwrite the mesh");
  expect_bad_option("--json", "out.obj", "would overwrite the mesh");
  expect_failure(kFile, {"in.obj", "-o", "out.obj", "--json", "no/r.json"}, "no/r.json");
  expect_failure(kFile, {"in.obj", "-o", "out.obj", "--json", "."}, ".: is a folder");
}

TEST_F(Usage, BadCostsAreExplained) {
  expect_bad_option("--cost", "bogus", "known are local, global, barycenter");
  expect_bad_option("--cost", "", "leave the option out for the default");
  expect_bad_option("--cost", ",", "a cost without a name");
  expect_bad_option("--cost", "local,", "a cost without a name");
  expect_bad_option("--cost", "local=", "'' is no weight");
  expect_bad_option("--cost", "local=0.3x", "'0.3x' is no weight");
  expect_bad_option("--cost", "local=1,3", "no cost named '3'");
  for (const char* weight : {"nan", "0", "-1"}) {
    expect_bad_option("--cost", std::string("local=") + weight, "must be positive");
  }
  for (const char* weight : {"inf", "1e308", "1e-320"}) {
    expect_bad_option("--cost", std::string("local=") + weight, "1e-100 and 1e100");
  }
}

TEST_F(Usage, CostsBeyondDoublePrecisionAreRefused) {
  expect_failure(kUsage,
                 {"in.obj", "-o", "out.obj", "--cost", "global", "--global-length", "1e200"},
                 "exceeds double precision");
}

TEST_F(Usage, BadSelectorsListTheKnownWords) {
  for (const char* word : {"boundary", "features", "corners", "interface", "id:", "box:"}) {
    expect_bad_option("--fix", "bogus", word);
    expect_bad_option("--fix", "", word);
  }
  expect_bad_option("--fix", "id:99", "99");
  expect_failure(kUsage, {"in.obj", "-o", "out.obj", "--cost", "local", "--fix", "none"},
                 "fix some (--fix boundary)");
}

TEST_F(Usage, NumbersOutsideTheirRangeAreNamed) {
  for (const char* value : {"-1", "0", "1", "nan", "inf", "1e308"}) {
    expect_bad_option("--tolerance", value, "the tolerance must lie between 0 and 1");
  }
  for (const char* value : {"0", "-5", "180", "nan", "inf", "1e308"}) {
    expect_bad_option("--feature-angle", value, "is not between 0 and 180");
  }
  for (const char* value : {"-1", "nan", "inf"}) {
    expect_bad_option("--weld", value, "--weld must be a length");
    expect_bad_option("--global-length", value, "--global-length must be a positive length");
  }
  for (const char* value : {"-1", "nan"}) {
    expect_bad_option("--time-limit", value, "the time limit must not be negative");
  }
  for (const char* value : {"-1", "1025"}) {
    expect_bad_option("--threads", value, "must lie between 0 and 1024");
  }
  expect_bad_option("--iterations", "-1", "must not be negative: -1");
  expect_bad_option("--iterations", "99999999999", "--iterations");
  expect_bad_option("--iterations", "1.5", "--iterations");
}

TEST_F(Usage, OptionsAreJudgedBeforeTheFileIsRead) {
  expect_failure(kUsage, {"missing.obj", "-o", "out.obj", "--tolerance", "2"}, "tolerance");
}

}  // namespace
}  // namespace evenmesh
