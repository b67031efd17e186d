#include "commands/setseamweights.h"

#include "commands/seamdelta.h"
#include "commands/setseamstate.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

SetSeamWeights::SetSeamWeights(Document &document, const IndexRanges &cornerPairs,
                               std::span<const double> weights)
    : ChangeElements(document)
{
    IndexRanges painted;
    std::vector<double> values;
    std::size_t next = 0;
    cornerPairs.forEach([&](int pair) {
        const double weight = weights[next++];
        if (document.mesh().edgePairs[pair / 2].diagonal || std::isnan(weight))
            return;
        painted.append(pair);
        // Adding zero turns -0 into +0, so that equal weights have equal bits.
        values.push_back(std::clamp(weight, 0.0, maxPaintedWeight) + 0.0);
    });
    mDelta = XorDelta::between<double>(document.seams().weights.data(), painted, values);
}

void SetSeamWeights::apply()
{
    editor().setSeamWeights(mDelta.indices(), mDelta.applied(document().seams().weights.data()));
}

QString SetSeamWeights::label() const
{
    return UndoText::tr("Paint %n edges", nullptr, edgeCountOf(mDelta.indices()));
}

void SetSeamWeights::writePayload(QCborMap &map) const
{
    writeSeamDelta(map, mDelta, document().mesh());
}

std::unique_ptr<SetSeamWeights> SetSeamWeights::fromCbor(Document &document, CborReader &reader)
{
    XorDelta delta = readSeamDelta(reader, sizeof(double), document);
    const std::vector<double> weights = delta.applied(document.seams().weights.data());
    const auto inRange = [](double w) { return w >= 0 && w <= maxPaintedWeight; };
    const bool valid = withoutDiagonals(document.mesh(), delta.indices()) == delta.indices() &&
                       std::all_of(weights.begin(), weights.end(), inRange);
    if (reader.failed() || !valid)
        return nullptr;
    auto command = std::make_unique<SetSeamWeights>(document, IndexRanges(), std::span<const double>());
    command->mDelta = std::move(delta);
    return command;
}

} // namespace autocuts
