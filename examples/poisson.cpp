// SPDX-License-Identifier: MIT
//
// What a solver makes of a mesh: -Laplace u = f on tets and hexes with linear finite elements,
// where u is known beforehand and given on the skin. Prints how many iterations conjugate gradients
// take and how far the result is from u: a poor mesh costs both.
//
//   example_poisson MESH [--linear] [--json]
//
// u = sin(2x) cos(3y) exp(z), or 1 + x + 2y + 3z with --linear, which these elements have exactly.
// The mesh is moved and scaled to have its greatest extent in [0, 1], and errors are relative to u.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include "evenmesh/base/error.h"
#include "evenmesh/io/mesh_file.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"

namespace {

using namespace evenmesh;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// ---- the problem ----

struct Exact {
  double (*value)(const Vec3& p);
  Vec3 (*gradient)(const Vec3& p);
  double (*source)(const Vec3& p);  // f = -Laplace u
};

double wave(const Vec3& p) { return std::sin(2 * p.x()) * std::cos(3 * p.y()) * std::exp(p.z()); }

constexpr Exact kWave{wave,
                      [](const Vec3& p) {
                        const double e = std::exp(p.z());
                        return Vec3(2 * std::cos(2 * p.x()) * std::cos(3 * p.y()) * e,
                                    -3 * std::sin(2 * p.x()) * std::sin(3 * p.y()) * e, wave(p));
                      },
                      [](const Vec3& p) { return (4 + 9 - 1) * wave(p); }};

constexpr Exact kLinear{[](const Vec3& p) { return 1 + p.dot(Vec3(1, 2, 3)); },
                        [](const Vec3&) { return Vec3(1, 2, 3); },  //
                        [](const Vec3&) { return 0.0; }};

/// A mesh, and which of its vertices are unknowns.
struct Grid {
  MeshFile file;
  std::vector<Vec3> points;  // scaled
  Orientation orientation;   // files may wind their cells either way
  std::vector<Index> cells;  // the volume cells
  std::vector<int> unknown;  // per vertex; -1 where u is given
  Eigen::Index unknowns = 0;

  CellKind kind(Index cell) const { return file.mesh.cells().kind(cell); }
  std::span<const Index> vertices(Index cell) const { return file.mesh.cells().vertices(cell); }
};

std::vector<Vec3> scaled(Points points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double extent = (high - low).maxCoeff();
  std::vector<Vec3> result;
  for (const Vec3& p : points) result.push_back((p - low) / extent);
  return result;
}

/// Surface cells of a volume mesh take no part: in most files they say where something acts.
std::vector<Index> volume_cells(const MeshFile& file) {
  const Cells& cells = file.mesh.cells();
  std::vector<Index> result;
  for (Index i = 0; i < cells.size(); ++i) {
    const CellKind kind = cells.kind(i);
    if (traits(kind).dimension == 2) continue;
    if (kind != CellKind::tet && kind != CellKind::hex) {
      throw Error(file.path.string() + ": " + file.patch->cell_name(i) + " is a " +
                  std::string(traits(kind).name) + "; this example takes tets and hexes");
    }
    result.push_back(i);
  }
  if (result.empty()) throw Error(file.path.string() + ": has no tets and no hexes");
  if (!file.followers.empty()) {
    throw Error(file.path.string() + ": has cells of second order; this example takes linear ones");
  }
  return result;
}

Grid read_grid(std::string_view path) {
  Grid grid;
  grid.file = read_mesh(path);
  const Mesh& mesh = grid.file.mesh;
  grid.cells = volume_cells(grid.file);
  grid.points = scaled(mesh.points());
  grid.orientation = find_orientation(mesh);
  const Topology topology = find_topology(mesh, grid.orientation);
  grid.unknown.assign(mesh.point_count(), -1);
  for (std::size_t v = 0; v < mesh.point_count(); ++v) {
    if (topology.used[v] && !topology.boundary[v]) {
      grid.unknown[v] = static_cast<int>(grid.unknowns++);
    }
  }
  if (grid.unknowns == 0) {
    throw Error(grid.file.path.string() + ": all vertices are on the skin, where u is given");
  }
  return grid;
}

// ---- elements ----

using PerVertex = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;
using PerVertex3 = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 8, 3>;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;

/// A quadrature point of the reference cell with the shape functions there.
struct Sample {
  double weight;
  PerVertex shape;
  PerVertex3 slope;
};
using Rule = std::vector<Sample>;

Sample tet_sample(const Vec3& at, double weight) {
  Sample sample{weight, PerVertex(4), PerVertex3(4, 3)};
  sample.shape << 1 - at.sum(), at;
  sample.slope << -Eigen::RowVector3d::Ones(), Eigen::Matrix3d::Identity();
  return sample;
}

Sample hex_sample(const Vec3& at, double weight) {
  Sample sample{weight, PerVertex(8), PerVertex3(8, 3)};
  const auto corners = traits(CellKind::hex).ideal;  // of the unit cube
  for (int v = 0; v < 8; ++v) {
    // A product of x or 1 - x, y or 1 - y, z or 1 - z.
    Vec3 factor, slope;
    for (int axis = 0; axis < 3; ++axis) {
      slope[axis] = corners[v][axis] > 0 ? 1 : -1;
      factor[axis] = corners[v][axis] > 0 ? at[axis] : 1 - at[axis];
    }
    sample.shape[v] = factor.prod();
    sample.slope.row(v) << slope[0] * factor[1] * factor[2], factor[0] * slope[1] * factor[2],
        factor[0] * factor[1] * slope[2];
  }
  return sample;
}

/// Gauss-Legendre on [0, 1] with 1, 2 or 4 points.
struct LinePoint {
  double at, weight;
};
std::vector<LinePoint> gauss(int points) {
  const auto pair = [](double half, double weight) {
    return std::vector<LinePoint>{{0.5 - half, weight}, {0.5 + half, weight}};
  };
  if (points == 1) return {{0.5, 1.0}};
  if (points == 2) return pair(std::sqrt(1.0 / 12), 0.5);
  const double root = std::sqrt(4.8), share = std::sqrt(30.0) / 72;
  auto inner = pair(std::sqrt((3 - root) / 28), 0.25 + share);
  const auto outer = pair(std::sqrt((3 + root) / 28), 0.25 - share);
  inner.insert(inner.end(), outer.begin(), outer.end());
  return inner;
}

/// Products of the points on lines; for a tet on a cube of which one face is drawn together to an
/// edge and another to a point.
Rule make_rule(CellKind kind, int points) {
  Rule rule;
  for (const auto& a : gauss(points)) {
    for (const auto& b : gauss(points)) {
      for (const auto& c : gauss(points)) {
        const double weight = a.weight * b.weight * c.weight;
        if (kind == CellKind::hex) {
          rule.push_back(hex_sample({a.at, b.at, c.at}, weight));
        } else {
          const double rest = 1 - a.at, last = rest * (1 - b.at);
          rule.push_back(tet_sample({a.at, rest * b.at, last * c.at}, rest * last * weight));
        }
      }
    }
  }
  return rule;
}

/// Exact for the stiffness of a tet, which is constant; 2 x 2 x 2 points for a hex.
const Rule& stiffness_rule(CellKind kind) {
  static const Rule kTet{tet_sample(Vec3::Constant(0.25), 1.0 / 6)};
  static const Rule kHex = make_rule(CellKind::hex, 2);
  return kind == CellKind::tet ? kTet : kHex;
}

/// For f and for errors, which are no polynomials: 4 x 4 x 4 points, exact for degree 5 and more.
const Rule& fine_rule(CellKind kind) {
  static const Rule kTet = make_rule(CellKind::tet, 4);
  static const Rule kHex = make_rule(CellKind::hex, 4);
  return kind == CellKind::tet ? kTet : kHex;
}

/// A quadrature point of a cell of the mesh.
struct CellSample {
  double volume;  // weight times determinant
  const PerVertex& shape;
  PerVertex3 gradient;  // of each shape function
  Vec3 place;
};

/// Calls body(sample) at each point of the rule.
/// @throws Error  the cell is inverted at one of them
template <typename Body>
void for_samples(const Grid& grid, Index cell, const Rule& rule, const Body& body) {
  const auto vertices = grid.vertices(cell);
  PerVertex3 corners(vertices.size(), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i) corners.row(i) = grid.points[vertices[i]];
  for (const Sample& sample : rule) {
    const Eigen::Matrix3d jacobian = corners.transpose() * sample.slope;
    const double determinant = jacobian.determinant() * grid.orientation.sign(cell);
    if (!(determinant > 0)) {
      throw Error(grid.file.path.string() + ": " + grid.file.patch->cell_name(cell) +
                  " is inverted: its Jacobian determinant is not positive at a Gauss point; "
                  "smooth the mesh first");
    }
    body(CellSample{sample.weight * determinant, sample.shape, sample.slope * jacobian.inverse(),
                    corners.transpose() * sample.shape});
  }
}

// ---- the linear system ----

struct System {
  Matrix matrix;
  Vector right;
};

Square stiffness(const Grid& grid, Index cell) {
  const auto n = static_cast<Eigen::Index>(grid.vertices(cell).size());
  Square K = Square::Zero(n, n);
  for_samples(grid, cell, stiffness_rule(grid.kind(cell)),
              [&](const CellSample& s) { K += s.volume * s.gradient * s.gradient.transpose(); });
  return K;
}

PerVertex load(const Grid& grid, Index cell, const Exact& exact) {
  const auto n = static_cast<Eigen::Index>(grid.vertices(cell).size());
  PerVertex f = PerVertex::Zero(n);
  for_samples(grid, cell, fine_rule(grid.kind(cell)),
              [&](const CellSample& s) { f += s.volume * exact.source(s.place) * s.shape; });
  return f;
}

System assemble(const Grid& grid, const Exact& exact) {
  System system{Matrix(grid.unknowns, grid.unknowns), Vector::Zero(grid.unknowns)};
  std::vector<Eigen::Triplet<double>> entries;
  for (const Index cell : grid.cells) {
    const auto vertices = grid.vertices(cell);
    const Square K = stiffness(grid, cell);
    const PerVertex f = load(grid, cell, exact);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const int row = grid.unknown[vertices[i]];
      if (row < 0) continue;
      system.right[row] += f[i];
      for (std::size_t j = 0; j < vertices.size(); ++j) {
        const int column = grid.unknown[vertices[j]];
        if (column >= 0) {
          entries.emplace_back(row, column, K(i, j));
        } else {
          system.right[row] -= K(i, j) * exact.value(grid.points[vertices[j]]);
        }
      }
    }
  }
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

// ---- conjugate gradients ----

struct Solve {
  Vector x;
  int iterations = 0;
  double condition = 0.0;  // of the matrix with its preconditioner, an estimate from below
};

/// The steps of conjugate gradients are also those of Lanczos' method: its tridiagonal matrix has
/// nearly the extreme eigenvalues of A.
double condition_of(const std::vector<double>& alpha, const std::vector<double>& beta) {
  const auto n = static_cast<Eigen::Index>(alpha.size());
  Vector diagonal(n), beside(n - 1);
  for (Eigen::Index k = 0; k < n; ++k) {
    diagonal[k] = 1 / alpha[k] + (k > 0 ? beta[k - 1] / alpha[k - 1] : 0.0);
    if (k + 1 < n) beside[k] = std::sqrt(beta[k]) / alpha[k];
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
  eigen.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues()[n - 1] / eigen.eigenvalues()[0];
}

/// @param scale   the preconditioner: what residuals are multiplied by
/// @throws Error  the residual does not fall to 1e-10 of the right-hand side
Solve conjugate_gradients(const System& system, const Vector& scale) {
  const auto& [A, b] = system;
  const double goal = 1e-10 * b.norm();
  const Eigen::Index most = 1000 + b.size();
  Solve solve{.x = Vector::Zero(b.size())};
  std::vector<double> alpha, beta;
  Vector residual = b, direction = scale.cwiseProduct(residual);
  double slope = residual.dot(direction);
  while (residual.norm() > goal) {
    if (++solve.iterations > most) throw Error("conjugate gradients do not converge");
    const Vector image = A * direction;
    alpha.push_back(slope / direction.dot(image));
    solve.x += alpha.back() * direction;
    residual -= alpha.back() * image;
    const Vector scaled_residual = scale.cwiseProduct(residual);
    const double next = residual.dot(scaled_residual);
    beta.push_back(next / slope);
    direction = scaled_residual + beta.back() * direction;
    slope = next;
  }
  if (!alpha.empty()) solve.condition = condition_of(alpha, beta);
  return solve;
}

// ---- errors ----

struct Errors {
  double l2 = 0.0, h1 = 0.0;  // relative to the norm of u
  double greatest = 0.0;      // at a vertex
};

Vector at_vertices(const Grid& grid, const Exact& exact, const Vector& x) {
  Vector u(static_cast<Eigen::Index>(grid.points.size()));
  for (std::size_t v = 0; v < grid.points.size(); ++v) {
    u[v] = grid.unknown[v] < 0 ? exact.value(grid.points[v]) : x[grid.unknown[v]];
  }
  return u;
}

Errors errors_of(const Grid& grid, const Exact& exact, const Vector& u) {
  double wrong = 0, wrong_slope = 0, all = 0, all_slope = 0;  // squared norms
  for (const Index cell : grid.cells) {
    const auto vertices = grid.vertices(cell);
    PerVertex here(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) here[i] = u[vertices[i]];
    for_samples(grid, cell, fine_rule(grid.kind(cell)), [&](const CellSample& s) {
      const double value = exact.value(s.place);
      const Vec3 slope = exact.gradient(s.place);
      wrong += s.volume * std::pow(here.dot(s.shape) - value, 2);
      wrong_slope += s.volume * (s.gradient.transpose() * here - slope).squaredNorm();
      all += s.volume * value * value;
      all_slope += s.volume * slope.squaredNorm();
    });
  }
  Errors errors{std::sqrt(wrong / all), std::sqrt((wrong + wrong_slope) / (all + all_slope))};
  for (std::size_t v = 0; v < grid.points.size(); ++v) {
    errors.greatest = std::max(errors.greatest, std::abs(u[v] - exact.value(grid.points[v])));
  }
  return errors;
}

// ---- command line ----

struct Arguments {
  std::string_view mesh;
  bool linear = false, json = false;
};

std::optional<Arguments> parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--linear") {
      arguments.linear = true;
    } else if (word == "--json") {
      arguments.json = true;
    } else if (word.starts_with("-") || !arguments.mesh.empty()) {
      return {};
    } else {
      arguments.mesh = word;
    }
  }
  if (arguments.mesh.empty()) return {};
  return arguments;
}

constexpr const char* kText =
    "%zu cells, %td unknowns\n"
    "conjugate gradients      %6d iterations, condition %.4g\n"
    "- Jacobi preconditioner  %6d iterations, condition %.4g\n"
    "error: L2 %.4e, H1 %.4e, at a vertex %.4e\n";
constexpr const char* kJson =
    "{\"cells\": %zu, \"unknowns\": %td,\n"
    " \"plain\": {\"iterations\": %d, \"condition\": %.6g},\n"
    " \"jacobi\": {\"iterations\": %d, \"condition\": %.6g},\n"
    " \"l2_error\": %.6e, \"h1_error\": %.6e, \"greatest_error\": %.6e}\n";

void run(const Arguments& arguments) {
  const Exact& exact = arguments.linear ? kLinear : kWave;
  const Grid grid = read_grid(arguments.mesh);
  const System system = assemble(grid, exact);
  const Solve plain = conjugate_gradients(system, Vector::Ones(grid.unknowns));
  const Solve jacobi = conjugate_gradients(system, system.matrix.diagonal().cwiseInverse());
  const Errors errors = errors_of(grid, exact, at_vertices(grid, exact, jacobi.x));
  std::printf(arguments.json ? kJson : kText, grid.cells.size(), grid.unknowns, plain.iterations,
              plain.condition, jacobi.iterations, jacobi.condition, errors.l2, errors.h1,
              errors.greatest);
}

}  // namespace

int main(int argc, char** argv) {
  const auto arguments = parse(argc, argv);
  if (!arguments) {
    std::fprintf(stderr, "usage: example_poisson MESH [--linear] [--json]\n");
    return 2;
  }
  try {
    run(*arguments);
  } catch (const Error& error) {
    std::fprintf(stderr, "example_poisson: %s\n", error.what());
    return 1;
  }
  return 0;
}
