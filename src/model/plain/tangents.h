#pragma once
#include "model/plain/meshdata.h"
namespace autocuts {
struct Tangent
{
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
    float sign = 1;
};
std::vector<Tangent> mikkTangents(const MeshData &mesh, const UvMatrix &uv,
                                  const std::vector<Eigen::Vector3f> &normals);
} // namespace autocuts
