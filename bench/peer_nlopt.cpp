// SPDX-License-Identifier: MIT
//
// usage: peer_nlopt VERTICES TARGET [CPU_SECONDS]
//
// NLopt's L-BFGS on the case `triangles`, until its cost is within 1e-6 of TARGET; one JSON object.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <nlopt.h>

#include "bench/support/contest.h"

namespace evenmesh::bench {
namespace {

struct Player {
  Contest& contest;
  nlopt_opt optimiser;
};

double objective(unsigned n, const double* y, double* gradient, void* data) {
  const auto& [contest, optimiser] = *static_cast<Player*>(data);
  const double cost = contest.evaluate({y, n}, {gradient, gradient == nullptr ? 0 : n});
  if (contest.over(cost)) nlopt_force_stop(optimiser);
  return cost;
}

nlohmann::json play(Contest& contest) {
  std::vector<double> y = contest.start();
  const nlopt_opt optimiser = nlopt_create(NLOPT_LD_LBFGS, static_cast<unsigned>(y.size()));
  Player player{contest, optimiser};
  nlopt_set_min_objective(optimiser, objective, &player);

  contest.start_clock();
  double cost = 0.0;
  const nlopt_result status = nlopt_optimize(optimiser, y.data(), &cost);
  nlopt_destroy(optimiser);

  int major = 0, minor = 0, bugfix = 0;
  nlopt_version(&major, &minor, &bugfix);
  nlohmann::json result = contest.result();
  result["peer"] = "NLopt LD_LBFGS";
  result["version"] =
      std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(bugfix);
  result["status"] = nlopt_result_to_string(status);
  return result;
}

}  // namespace
}  // namespace evenmesh::bench

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::fputs("usage: peer_nlopt VERTICES TARGET [CPU_SECONDS]\n", stderr);
    return 2;
  }
  try {
    evenmesh::bench::Contest contest(std::strtoull(argv[1], nullptr, 10), std::atof(argv[2]),
                                     argc > 3 ? std::atof(argv[3]) : 300.0);
    std::puts(evenmesh::bench::play(contest).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer_nlopt: %s\n", error.what());
    return 1;
  }
  return 0;
}
