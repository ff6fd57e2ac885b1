// SPDX-License-Identifier: MIT
//
// usage: oracle_ipopt SHAPE VERTICES SEED NOISE LEAST fixed|slide [CPU_SECONDS [OPTION=VALUE ...]]
//        oracle_ipopt --check
//
// Ipopt with exact derivatives on the cost `local` under the limits of AreaLimits; one JSON object.
// SHAPE is disk (shapes::disk_triangles) or square (shapes::irregular_triangles with a jitter of
// 0.3). Every triangle keeps LEAST times the mean area of
// the mesh without noise, so that all starts have the same limit. `slide` leaves boundary vertices
// on the unit circle, `fixed` leaves them where they are. OPTION=VALUE are for Ipopt: digits alone
// are an integer, other numbers a real.
// --check has Ipopt compare all derivatives with differences and prints what it says.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <nlohmann/json.hpp>

#include "bench/area_limits.h"
#include "bench/support/case.h"
#include "evenmesh/base/error.h"
#include "evenmesh/base/timer.h"
#include "tests/support/shapes.h"

namespace evenmesh::bench {
namespace {

using Ipopt::Index;
using Ipopt::Number;

constexpr double kActive = 1e-5;  // how close to its limit, in mean areas, a triangle is at it

std::span<const double> view(const Number* values, Index count) {
  return {values, static_cast<std::size_t>(count)};
}
std::span<double> view(Number* values, Index count) {
  return {values, static_cast<std::size_t>(count)};
}

class Adapter final : public Ipopt::TNLP {
 public:
  explicit Adapter(const AreaLimits& limits) : limits_(limits) {}

  int iterations() const { return iterations_; }
  double cost() const { return cost_; }
  const std::vector<double>& solution() const { return solution_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(limits_.unknowns());
    m = static_cast<Index>(limits_.constraints());
    jacobian_entries = static_cast<Index>(limits_.jacobian_rows().size());
    hessian_entries = static_cast<Index>(limits_.hessian().entries());
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* least,
                       Number* greatest) override {
    std::fill(lower, lower + n, -2e19);  // its word for infinite
    std::fill(upper, upper + n, 2e19);
    limits_.bounds(view(least, m), view(greatest, m));
    return true;
  }

  bool get_starting_point(Index, bool, Number* y, bool, Number*, Number*, Index, bool,
                          Number*) override {
    const std::vector<double> start = limits_.start();
    std::copy(start.begin(), start.end(), y);
    return true;
  }

  bool eval_f(Index n, const Number* y, bool, Number& value) override {
    value = limits_.cost(view(y, n), {});
    return true;
  }

  bool eval_grad_f(Index n, const Number* y, bool, Number* gradient) override {
    limits_.cost(view(y, n), view(gradient, n));
    return true;
  }

  bool eval_g(Index n, const Number* y, bool, Index m, Number* values) override {
    limits_.evaluate(view(y, n), view(values, m));
    return true;
  }

  bool eval_jac_g(Index n, const Number* y, bool, Index, Index entries, Index* rows, Index* columns,
                  Number* values) override {
    if (values == nullptr) {
      std::copy(limits_.jacobian_rows().begin(), limits_.jacobian_rows().end(), rows);
      std::copy(limits_.jacobian_columns().begin(), limits_.jacobian_columns().end(), columns);
    } else {
      limits_.jacobian(view(y, n), view(values, entries));
    }
    return true;
  }

  bool eval_h(Index n, const Number* y, bool, Number factor, Index m, const Number* multipliers,
              bool, Index entries, Index* rows, Index* columns, Number* values) override {
    const LocalHessian& pattern = limits_.hessian();
    if (values == nullptr) {
      std::copy(pattern.rows().begin(), pattern.rows().end(), rows);
      std::copy(pattern.columns().begin(), pattern.columns().end(), columns);
    } else {
      limits_.hessian(view(y, n), factor, view(multipliers, m), view(values, entries));
    }
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number, Number, Number, Number,
                             Number, Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    iterations_ = iteration;
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* y, const Number*,
                         const Number*, Index, const Number*, const Number*, Number cost,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    solution_.assign(y, y + n);
    cost_ = cost;
  }

 private:
  const AreaLimits& limits_;
  int iterations_ = 0;
  double cost_ = 0.0;
  std::vector<double> solution_;
};

struct Request {
  std::string shape;
  std::size_t vertices = 0;
  std::uint64_t seed = 1;
  double noise = 0.0;
  double least = 0.0;
  Rim rim = Rim::fixed;
  double most_cpu_seconds = 600.0;
  std::vector<std::string> options = {};
};

Mesh mesh_of(const Request& request) {
  if (request.shape == "disk") {
    return shapes::disk_triangles(request.vertices, request.seed, request.noise);
  }
  if (request.shape == "square" && request.rim == Rim::fixed) {
    return shapes::irregular_triangles(request.vertices, 0.3, request.seed, request.noise);
  }
  throw InvalidOption("SHAPE must be disk, or square with a fixed boundary");
}

void set_option(Ipopt::OptionsList& options, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) throw InvalidOption(setting + ": OPTION=VALUE expected");
  const std::string name = setting.substr(0, equals);
  const std::string value = setting.substr(equals + 1);
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  bool known = false;
  if (value.find_first_not_of("0123456789") == std::string::npos) {
    known = options.SetIntegerValue(name, static_cast<Index>(number));
  } else if (*end == '\0') {
    known = options.SetNumericValue(name, number);
  } else {
    known = options.SetStringValue(name, value);
  }
  if (!known) throw InvalidOption(setting + ": Ipopt does not accept this");
}

Ipopt::SmartPtr<Ipopt::IpoptApplication> make_ipopt(const Request& request) {
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = IpoptApplicationFactory();
  ipopt->Options()->SetIntegerValue("print_level", 0);
  ipopt->Options()->SetStringValue("sb", "yes");  // no banner: stdout is for the result
  ipopt->Options()->SetStringValue("linear_solver", "mumps");
  ipopt->Options()->SetNumericValue("tol", 1e-9);
  // It would widen limits by 1e-8, and more where they are large.
  ipopt->Options()->SetNumericValue("bound_relax_factor", 0.0);
  ipopt->Options()->SetIntegerValue("max_iter", 5000);
  ipopt->Options()->SetNumericValue("max_cpu_time", request.most_cpu_seconds);
  for (const std::string& setting : request.options) set_option(*ipopt->Options(), setting);
  ipopt->Initialize();
  return ipopt;
}

// What is true of the triangles at y.
nlohmann::json describe(const AreaLimits& limits, std::span<const double> y, const Mesh& mesh,
                        double least) {
  const auto cells = static_cast<std::ptrdiff_t>(mesh.cells().size());
  std::vector<double> values(limits.constraints());
  limits.evaluate(y, values);
  const auto end_of_areas = values.begin() + cells;
  double off_circle = 0.0;
  std::for_each(end_of_areas, values.end(), [&](double value) {
    off_circle = std::max(off_circle, std::abs(std::sqrt(2.0 * value / limits.radius()) - 1.0));
  });
  return {
      {"inverted", std::count_if(values.begin(), end_of_areas, [](double a) { return a <= 0; })},
      {"at_limit",
       std::count_if(values.begin(), end_of_areas, [&](double a) { return a < least + kActive; })},
      {"worst_area_over_mean", *std::min_element(values.begin(), end_of_areas)},
      {"off_circle", off_circle}};
}

nlohmann::json solve(const Request& request) {
  const Mesh mesh = mesh_of(request);
  Request valid = request;
  valid.noise = 0.0;
  const double unit_area = mean_area(mesh_of(valid));
  const Mesh unit_mesh = shapes::scaled(mesh, 1.0 / std::sqrt(unit_area));
  const AreaLimits limits(unit_mesh, request.least, request.rim);
  Ipopt::SmartPtr<Adapter> adapter = new Adapter(limits);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = make_ipopt(request);

  const double started = cpu_seconds();
  const Ipopt::ApplicationReturnStatus status = ipopt->OptimizeTNLP(adapter);
  const double used = cpu_seconds() - started;
  return {{"peer", "Ipopt, exact Hessian"},
          {"version", IPOPT_VERSION},
          {"shape", request.shape},
          {"vertices", mesh.point_count()},
          {"cells", mesh.cells().size()},
          {"seed", request.seed},
          {"noise", request.noise},
          {"least", request.least},
          {"mean_area", unit_area},
          {"least_area", request.least * unit_area},
          {"rim", request.rim == Rim::fixed ? "fixed" : "slide"},
          {"unknowns", limits.unknowns()},
          {"status", static_cast<int>(status)},
          {"solved", status == Ipopt::Solve_Succeeded},
          {"cost", adapter->cost() * unit_area},
          {"iterations", adapter->iterations()},
          {"cpu_seconds", used},
          {"before", describe(limits, limits.start(), mesh, request.least)},
          {"after", describe(limits, adapter->solution(), mesh, request.least)}};
}

int check_derivatives() {
  for (const Rim rim : {Rim::on_circle, Rim::fixed}) {
    const Request request{
        .shape = "disk",
        .vertices = 60,
        .noise = 0.8,
        .least = 0.2,
        .rim = rim,
        .options = {"print_level=5", "derivative_test=second-order",
                    "derivative_test_perturbation=1e-7", "derivative_test_tol=1e-4", "max_iter=0"}};
    const Mesh mesh = mesh_of(request);
    const AreaLimits limits(mesh, request.least, rim);
    Ipopt::SmartPtr<Adapter> adapter = new Adapter(limits);
    make_ipopt(request)->OptimizeTNLP(adapter);
  }
  return 0;
}

int usage() {
  std::fputs(
      "usage: oracle_ipopt disk|square VERTICES SEED NOISE LEAST fixed|slide [CPU_SECONDS "
      "[OPTION=VALUE ...]] | --check\n",
      stderr);
  return 2;
}

int run(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--check") == 0) return check_derivatives();
  if (argc < 7) return usage();
  const std::string_view rim = argv[6];
  if (rim != "fixed" && rim != "slide") return usage();
  Request request{.shape = argv[1],
                  .vertices = std::strtoull(argv[2], nullptr, 10),
                  .seed = std::strtoull(argv[3], nullptr, 10),
                  .noise = std::atof(argv[4]),
                  .least = std::atof(argv[5]),
                  .rim = rim == "fixed" ? Rim::fixed : Rim::on_circle};
  if (argc > 7) request.most_cpu_seconds = std::atof(argv[7]);
  for (int i = 8; i < argc; ++i) request.options.emplace_back(argv[i]);
  std::puts(solve(request).dump().c_str());
  return 0;
}

}  // namespace
}  // namespace evenmesh::bench

int main(int argc, char** argv) {
  try {
    return evenmesh::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "oracle_ipopt: %s\n", error.what());
    return 1;
  }
}
