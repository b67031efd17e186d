#include "commands/settexelweights.h"

#include "model/plain/texelweights.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

SetTexelWeights::SetTexelWeights(Document &document, const IndexRanges &faces,
                                 std::span<const double> weights)
    : ChangeElements(document)
{
    IndexRanges painted;
    std::vector<double> values;
    std::size_t next = 0;
    faces.forEach([&](int face) {
        const double weight = weights[next++];
        if (std::isnan(weight))
            return;
        painted.append(face);
        values.push_back(std::clamp(weight, minTexelWeight, maxTexelWeight));
    });
    mDelta = XorDelta::between<double>(document.texelWeights().data(), painted, values);
}

std::unique_ptr<SetTexelWeights> SetTexelWeights::uniform(Document &document, const IndexRanges &faces,
                                                          double weight)
{
    const std::vector<double> weights(faces.count(), weight);
    return std::make_unique<SetTexelWeights>(document, faces, weights);
}

void SetTexelWeights::apply()
{
    editor().setTexelWeights(mDelta.indices(), mDelta.applied(document().texelWeights().data()));
}

QString SetTexelWeights::label() const
{
    return UndoText::tr("Texel density weight of %n faces", nullptr,
                        static_cast<int>(mDelta.indices().count()));
}

std::unique_ptr<SetTexelWeights> SetTexelWeights::fromCbor(Document &document, CborReader &reader)
{
    XorDelta delta = XorDelta::read(reader, sizeof(double), document.mesh().faceCount());
    const std::vector<double> weights = delta.applied(document.texelWeights().data());
    const auto inRange = [](double w) { return w >= minTexelWeight && w <= maxTexelWeight; };
    if (reader.failed() || !std::all_of(weights.begin(), weights.end(), inRange))
        return nullptr;
    auto command = std::make_unique<SetTexelWeights>(document, IndexRanges(), std::span<const double>());
    command->mDelta = std::move(delta);
    return command;
}

} // namespace autocuts
