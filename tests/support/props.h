// Props of flat faces, cylinders and spheres, for tests of hard-surface maps.
#pragma once

#include "support/meshbuilders.h"

#include <vector>

namespace autocuts::test::props {

struct Model
{
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;

    //! Adds a model as parts of their own.
    void add(const Model &other);
    MeshPtr mesh() const { return polygonMesh(points, faces); }
};

Model box(const Vec3 &low, const Vec3 &size);
//! A column with a regular polygon for its ends: a prism, and with many sides a cylinder. \param top radius
//! there; 0: a pyramid, or a cone
Model column(int sides, double bottom, double top, double height, int rows = 1);
Model house();
//! Steps between two walls.
Model stairs(int steps);
//! Boards on two uprights, as separate parts.
Model shelf();
//! A sphere of quads with triangles at its poles.
Model sphere(int rows, double radius);
//! A surface of revolution about z, closed by discs. \param profile radius and height, from below
Model turnedShape(const std::vector<Vec2> &profile, int sides);
//! A tube along a line in the xz plane, closed by discs. \param path x and z of its middle
Model tube(const std::vector<Vec2> &path, double radius, int sides);
//! A hexagonal head on a round shaft.
Model bolt();
Model table();
//! A pipe that bends twice.
Model pipe();
//! Two rings and a frame of tubes, as separate parts.
Model bicycle();
//! A bottle with a flat bottom.
Model bottle();

//! A box with sides from -1 to 1 that bulge. \param bulge height in the middle of a side \param cells quads
//! per edge
Model cushion(double bulge, int cells = 12);
//! A door, 2 by 1.2: a front that bulges in both directions, walls and a back. \param bevel width of the
//! strip between the front and the walls; 0: a sharp edge \param back height by which the back bulges
Model door(double bulge, double bevel, double back = 0);

Model moved(Model model, const Vec3 &by);
//! Mirrored in x, with its faces still outside.
Model mirrored(Model model);
//! Turned around z. \param angle in radians
Model turned(Model model, double angle);

} // namespace autocuts::test::props
