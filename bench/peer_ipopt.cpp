// SPDX-License-Identifier: MIT
//
// usage: peer_ipopt VERTICES TARGET [CPU_SECONDS]
//        peer_ipopt --check
//
// Ipopt with exact second derivatives on the case `triangles`, until its cost is within 1e-6 of
// TARGET; one JSON object. --check compares the derivatives with differences instead.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <nlohmann/json.hpp>

#include "bench/local_hessian.h"
#include "bench/support/contest.h"

namespace evenmesh::bench {
namespace {

using Ipopt::Index;
using Ipopt::Number;

class Player final : public Ipopt::TNLP {
 public:
  explicit Player(Contest& contest)
      : contest_(contest), hessian_(contest.mesh(), contest.first_unknown()) {}

  int iterations() const { return iterations_; }

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(contest_.unknowns());
    m = jacobian_entries = 0;
    hessian_entries = static_cast<Index>(hessian_.entries());
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lower, Number* upper, Index, Number*, Number*) override {
    std::fill(lower, lower + n, -2e19);  // its word for infinite
    std::fill(upper, upper + n, 2e19);
    return true;
  }

  bool get_starting_point(Index, bool, Number* y, bool, Number*, Number*, Index, bool,
                          Number*) override {
    const std::vector<double> start = contest_.start();
    std::copy(start.begin(), start.end(), y);
    return true;
  }

  bool eval_f(Index n, const Number* y, bool, Number& value) override {
    value = contest_.evaluate({y, static_cast<std::size_t>(n)}, {});
    return true;
  }

  bool eval_grad_f(Index n, const Number* y, bool, Number* gradient) override {
    const auto count = static_cast<std::size_t>(n);
    contest_.evaluate({y, count}, {gradient, count});
    return true;
  }

  bool eval_g(Index, const Number*, bool, Index, Number*) override { return true; }

  bool eval_jac_g(Index, const Number*, bool, Index, Index, Index*, Index*, Number*) override {
    return true;
  }

  bool eval_h(Index n, const Number* y, bool, Number factor, Index, const Number*, bool, Index,
              Index* rows, Index* columns, Number* values) override {
    if (values == nullptr) {
      std::copy(hessian_.rows().begin(), hessian_.rows().end(), rows);
      std::copy(hessian_.columns().begin(), hessian_.columns().end(), columns);
    } else {
      hessian_.evaluate({y, static_cast<std::size_t>(n)}, factor, {}, {values, hessian_.entries()});
    }
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number cost, Number, Number,
                             Number, Number, Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    iterations_ = iteration;
    return !contest_.over(cost);
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number*, const Number*, const Number*,
                         Index, const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {}

 private:
  Contest& contest_;
  LocalHessian hessian_;
  int iterations_ = 0;
};

nlohmann::json play(Contest& contest, double most_cpu_seconds) {
  Ipopt::SmartPtr<Player> player = new Player(contest);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = IpoptApplicationFactory();
  ipopt->Options()->SetIntegerValue("print_level", 0);
  ipopt->Options()->SetStringValue("sb", "yes");  // no banner: stdout is for the result
  ipopt->Options()->SetStringValue("linear_solver", "mumps");
  ipopt->Options()->SetStringValue("hessian_approximation", "exact");
  ipopt->Options()->SetNumericValue("tol", 1e-12);  // the contest says when it is over
  ipopt->Options()->SetNumericValue("max_cpu_time", 2.0 * most_cpu_seconds);
  ipopt->Initialize();

  contest.start_clock();
  const Ipopt::ApplicationReturnStatus status = ipopt->OptimizeTNLP(player);

  nlohmann::json result = contest.result();
  result["peer"] = "Ipopt, exact Hessian";
  result["version"] = IPOPT_VERSION;
  result["status"] = static_cast<int>(status);
  result["iterations"] = player->iterations();
  return result;
}

// The largest difference between second derivatives and differences of gradients, over the largest
// of them.
double derivative_error() {
  Contest contest(300, 1.0, 1.0);
  const LocalHessian hessian(contest.mesh(), contest.first_unknown());
  const std::size_t n = contest.unknowns();
  std::vector<double> y = contest.start();
  std::vector<double> values(hessian.entries());
  hessian.evaluate(y, 1.0, {}, values);
  std::vector<double> dense(n * n, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto row = static_cast<std::size_t>(hessian.rows()[i]);
    const auto column = static_cast<std::size_t>(hessian.columns()[i]);
    dense[row * n + column] = dense[column * n + row] = values[i];
  }
  constexpr double kStep = 1e-6;
  double error = 0.0;
  double size = 0.0;
  std::vector<double> ahead(n), behind(n);
  for (std::size_t j = 0; j < n; ++j) {
    const double here = y[j];
    y[j] = here + kStep;
    contest.evaluate(y, ahead);
    y[j] = here - kStep;
    contest.evaluate(y, behind);
    y[j] = here;
    for (std::size_t i = 0; i < n; ++i) {
      const double difference = (ahead[i] - behind[i]) / (2.0 * kStep);
      error = std::max(error, std::abs(difference - dense[i * n + j]));
      size = std::max(size, std::abs(difference));
    }
  }
  return error / size;
}

}  // namespace
}  // namespace evenmesh::bench

int main(int argc, char** argv) {
  try {
    if (argc == 2 && std::strcmp(argv[1], "--check") == 0) {
      const double error = evenmesh::bench::derivative_error();
      std::printf("relative error of the second derivatives: %.1e\n", error);
      return error < 1e-6 ? 0 : 1;
    }
    if (argc < 3 || argc > 4) {
      std::fputs("usage: peer_ipopt VERTICES TARGET [CPU_SECONDS] | --check\n", stderr);
      return 2;
    }
    const double most_cpu_seconds = argc > 3 ? std::atof(argv[3]) : 300.0;
    evenmesh::bench::Contest contest(std::strtoull(argv[1], nullptr, 10), std::atof(argv[2]),
                                     most_cpu_seconds);
    std::puts(evenmesh::bench::play(contest, most_cpu_seconds).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer_ipopt: %s\n", error.what());
    return 1;
  }
  return 0;
}
