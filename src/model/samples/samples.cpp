#include "model/samples/samples.h"

#include "model/samples/polygonmodel.h"
#include "model/samples/samplemodels.h"

namespace autocuts {

namespace {

struct Sample
{
    const char *name;
    samples::PolygonModel (*make)();
};

constexpr Sample allSamples[] = {
    {"bumpycube", samples::makeBumpyCube},
    {"character", samples::makeCharacter},
    {"torus", samples::makeHandleTorus},
    {"machine", samples::makeMachine},
};

} // namespace

QStringList sampleNames()
{
    QStringList names;
    for (const Sample &sample : allSamples)
        names << QLatin1String(sample.name);
    return names;
}

Result<Scene> makeSample(const QString &name)
{
    for (const Sample &sample : allSamples) {
        if (name == QLatin1String(sample.name))
            return sample.make().toScene();
    }
    return Error{QStringLiteral("There is no sample named \"%1\"").arg(name),
                 {},
                 0,
                 QStringLiteral("Choose one of: %1").arg(sampleNames().join(QLatin1String(", ")))};
}

} // namespace autocuts
