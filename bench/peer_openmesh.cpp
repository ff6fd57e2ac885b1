// SPDX-License-Identifier: MIT
//
// usage: peer_openmesh IN.obj OUT.obj ITERATIONS
// OpenMesh's Jacobi smoother of Laplacian type, tangential and normal, on a surface of triangles;
// prints the CPU seconds of smoothing alone as one JSON object. Vertices keep their order.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using Smoother = OpenMesh::Smoother::JacobiLaplaceSmootherT<Surface>;

double smooth(Surface& surface, unsigned iterations) {
  surface.request_face_normals();
  surface.request_vertex_normals();
  surface.update_normals();
  const std::clock_t start = std::clock();
  Smoother smoother(surface);
  smoother.initialize(Smoother::Tangential_and_Normal, Smoother::C0);
  smoother.smooth(iterations);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: peer_openmesh IN.obj OUT.obj ITERATIONS\n", stderr);
    return 2;
  }
  Surface surface;
  if (!OpenMesh::IO::read_mesh(surface, argv[1])) {
    std::fprintf(stderr, "peer_openmesh: %s cannot be read\n", argv[1]);
    return 1;
  }
  const double seconds = smooth(surface, static_cast<unsigned>(std::atoi(argv[3])));
  if (!OpenMesh::IO::write_mesh(surface, argv[2], OpenMesh::IO::Options::Default, 17)) {
    std::fprintf(stderr, "peer_openmesh: %s cannot be written\n", argv[2]);
    return 1;
  }
  std::printf("{\"cpu_seconds\": %.6g}\n", seconds);
  return 0;
}
