#include "model/plain/texelweights.h"

#include <algorithm>

namespace autocuts {

namespace {

bool areAllOne(const std::vector<double> &weights)
{
    return std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 1; });
}

} // namespace

std::vector<double> storedTexelWeights(std::vector<double> weights)
{
    if (areAllOne(weights))
        weights.clear();
    return weights;
}

bool areTexelWeights(const std::vector<double> &weights, int faceCount)
{
    const auto inRange = [](double weight) { return weight >= minTexelWeight && weight <= maxTexelWeight; };
    return weights.empty() || (static_cast<int>(weights.size()) == faceCount && !areAllOne(weights) &&
                               std::all_of(weights.begin(), weights.end(), inRange));
}

std::shared_ptr<const MeshData> withTexelWeights(const std::shared_ptr<const MeshData> &mesh,
                                                 const std::vector<double> &weights)
{
    if (weights.empty())
        return mesh;
    auto weighted = std::make_shared<MeshData>(*mesh);
    weighted->texelWeight = weights;
    return weighted;
}

} // namespace autocuts
