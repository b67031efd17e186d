#include "jobs/shadedscene.h"

#include "model/plain/shadingnormals.h"
#include "model/transfer/placement.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <map>
#include <set>

namespace autocuts {

namespace {

struct PlaceTexts
{
    Q_DECLARE_TR_FUNCTIONS(DetailedModel)
};

Vec3f linearColor(QRgb color)
{
    const auto part = [](int value) { return linearFromSrgb(static_cast<float>(value) / 255); };
    return {part(qRed(color)), part(qGreen(color)), part(qBlue(color))};
}

QString pairedName(const QString &name)
{
    static const QRegularExpression ending(QStringLiteral("[ ._-](low|lo|lp|high|hi|hp)(poly)?([ ._-].*)?$"),
                                           QRegularExpression::CaseInsensitiveOption);
    return QString(name).remove(ending).toLower();
}

} // namespace

ShadedSurface shadedSurface(const Scene &scene, double tileHeight)
{
    ShadedSurface surface;
    surface.mesh = scene.mesh;
    surface.normals = shadingNormals(*scene.mesh, scene.hardEdges);
    surface.tileHeight = tileHeight;
    if (scene.hasUv()) {
        surface.uv = scene.uvSets.front().uv;
        surface.tangents = mikkTangents(*scene.mesh, surface.uv, surface.normals);
    }
    surface.cornerColors = scene.cornerColors;
    surface.faceMaterial = scene.faceMaterial;
    for (const QRgb color : scene.materialColors)
        surface.materialColors.push_back(color == 0 ? Vec3f(Vec3f::Constant(0.8F)) : linearColor(color));
    return surface;
}

QStringList pairObjects(ShadedSurface &low, const std::vector<QString> &lowNames, ShadedSurface &high,
                        const std::vector<QString> &highNames)
{
    std::map<QString, int> groups;
    const auto groupOf = [&](const QString &name) {
        return groups.try_emplace(pairedName(name), static_cast<int>(groups.size())).first->second;
    };
    const auto groupsOf = [&](const std::vector<QString> &names) {
        std::vector<int> result;
        result.reserve(names.size());
        for (const QString &name : names)
            result.push_back(groupOf(name));
        return result;
    };
    const std::vector<int> ofHigh = groupsOf(highNames), ofLow = groupsOf(lowNames);
    const auto assign = [](ShadedSurface &surface, const std::vector<int> &ofObject) {
        surface.faceGroup.clear();
        for (const int object : surface.mesh->faceObject)
            surface.faceGroup.push_back(ofObject[object]);
    };
    assign(low, ofLow);
    assign(high, ofHigh);
    const std::set<int> known(ofHigh.begin(), ofHigh.end());
    QStringList alone;
    for (std::size_t i = 0; i < ofLow.size(); ++i) {
        if (!known.contains(ofLow[i]))
            alone << lowNames[i];
    }
    return alone;
}

QString placeLike(ShadedSurface &high, const ShadedSurface &low)
{
    if (!transfer::liesElsewhere(*high.mesh, *low.mesh))
        return {};
    const std::vector<transfer::Placement> likely = transfer::likelyPlacements(*high.mesh, *low.mesh);
    if (likely.empty())
        return {};
    const transfer::Placement placement = likely.front();
    high.mesh = transfer::placed(*high.mesh, placement);
    const auto turn = [&placement](Vec3f &direction) {
        direction = transfer::turnedOnly(direction.cast<double>(), placement).cast<float>();
    };
    for (Vec3f &normal : high.normals)
        turn(normal);
    for (Tangent &tangent : high.tangents)
        turn(tangent.direction);
    QStringList changes;
    if (placement.scale != 1)
        changes << PlaceTexts::tr("it was taken %1 times as large").arg(placement.scale, 0, 'g', 4);
    if (placement.turn != 0)
        changes << PlaceTexts::tr("its upward axis was turned");
    return PlaceTexts::tr("The detailed model has other units or axes than the model: %1")
        .arg(changes.join(QLatin1String(", ")));
}

} // namespace autocuts
