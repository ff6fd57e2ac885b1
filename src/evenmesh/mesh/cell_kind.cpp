// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/cell_kind.h"

namespace evenmesh {
namespace {

using Edge = CellTraits::Edge;
using Face = CellTraits::Face;
using Corner = CellTraits::Corner;
using Position = std::array<double, 3>;

constexpr double kHalfRoot3 = 0.86602540378443864676;    // height of an equilateral triangle
constexpr double kThirdHeight = 0.28867513459481288225;  // its centre above the base, sqrt(3)/6
constexpr double kTetHeight = 0.81649658092772603273;    // sqrt(2/3)
constexpr double kPyramidHeight = 0.70710678118654752440;

constexpr Edge kTriangleEdges[] = {{0, 1}, {1, 2}, {2, 0}};
constexpr Corner kTriangleCorners[] = {{0, {1, 2, 0}}, {1, {2, 0, 1}}, {2, {0, 1, 2}}};
constexpr Position kTriangleIdeal[] = {{0, 0, 0}, {1, 0, 0}, {0.5, kHalfRoot3, 0}};

constexpr Edge kQuadEdges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
constexpr Corner kQuadCorners[] = {{0, {1, 3, 0}}, {1, {2, 0, 1}}, {2, {3, 1, 2}}, {3, {0, 2, 3}}};
constexpr Position kQuadIdeal[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

constexpr Edge kTetEdges[] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
constexpr Face kTetFaces[] = {
    {3, {0, 2, 1, 0}}, {3, {0, 1, 3, 0}}, {3, {1, 2, 3, 0}}, {3, {0, 3, 2, 0}}};
constexpr Corner kTetCorners[] = {{0, {1, 2, 3}}, {1, {2, 0, 3}}, {2, {0, 1, 3}}, {3, {0, 2, 1}}};
constexpr Position kTetIdeal[] = {
    {0, 0, 0}, {1, 0, 0}, {0.5, kHalfRoot3, 0}, {0.5, kThirdHeight, kTetHeight}};

constexpr Edge kHexEdges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                              {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr Face kHexFaces[] = {{4, {0, 3, 2, 1}}, {4, {4, 5, 6, 7}}, {4, {0, 1, 5, 4}},
                              {4, {1, 2, 6, 5}}, {4, {2, 3, 7, 6}}, {4, {3, 0, 4, 7}}};
constexpr Corner kHexCorners[] = {{0, {1, 3, 4}}, {1, {2, 0, 5}}, {2, {3, 1, 6}}, {3, {0, 2, 7}},
                                  {4, {7, 5, 0}}, {5, {4, 6, 1}}, {6, {5, 7, 2}}, {7, {6, 4, 3}}};
constexpr Position kHexIdeal[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

constexpr Edge kWedgeEdges[] = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5},
                                {5, 3}, {0, 3}, {1, 4}, {2, 5}};
constexpr Face kWedgeFaces[] = {
    {3, {0, 2, 1, 0}}, {3, {3, 4, 5, 0}}, {4, {0, 1, 4, 3}}, {4, {1, 2, 5, 4}}, {4, {2, 0, 3, 5}}};
constexpr Corner kWedgeCorners[] = {{0, {1, 2, 3}}, {1, {2, 0, 4}}, {2, {0, 1, 5}},
                                    {3, {5, 4, 0}}, {4, {3, 5, 1}}, {5, {4, 3, 2}}};
constexpr Position kWedgeIdeal[] = {{0, 0, 0}, {1, 0, 0}, {0.5, kHalfRoot3, 0},
                                    {0, 0, 1}, {1, 0, 1}, {0.5, kHalfRoot3, 1}};

constexpr Edge kPyramidEdges[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
constexpr Face kPyramidFaces[] = {
    {4, {0, 3, 2, 1}}, {3, {0, 1, 4, 0}}, {3, {1, 2, 4, 0}}, {3, {2, 3, 4, 0}}, {3, {3, 0, 4, 0}}};
constexpr Corner kPyramidCorners[] = {
    {0, {1, 3, 4}}, {1, {2, 0, 4}}, {2, {3, 1, 4}}, {3, {0, 2, 4}}};
constexpr Position kPyramidIdeal[] = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, kPyramidHeight}};

constexpr CellTraits kTable[kCellKinds] = {
    {"triangle", 2, 3, kTriangleEdges, {}, kTriangleCorners, kTriangleIdeal},
    {"quad", 2, 4, kQuadEdges, {}, kQuadCorners, kQuadIdeal},
    {"polygon", 2, 0, {}, {}, {}, {}},
    {"tet", 3, 4, kTetEdges, kTetFaces, kTetCorners, kTetIdeal},
    {"hex", 3, 8, kHexEdges, kHexFaces, kHexCorners, kHexIdeal},
    {"wedge", 3, 6, kWedgeEdges, kWedgeFaces, kWedgeCorners, kWedgeIdeal},
    {"pyramid", 3, 5, kPyramidEdges, kPyramidFaces, kPyramidCorners, kPyramidIdeal},
};

}  // namespace

const CellTraits& traits(CellKind kind) { return kTable[static_cast<int>(kind)]; }

}  // namespace evenmesh
