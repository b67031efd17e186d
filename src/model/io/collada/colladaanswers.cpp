// What a ColladaSource says of its file.
#include "model/io/collada/colladasource.h"
#include "model/io/files/savefile.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>

namespace autocuts {

namespace {

Result<Done> writeRewrittenCollada(const Scene &scene, const QString &path)
{
    return saveAtomically(path, rewriteCollada(*sourceOf<ColladaSource>(scene), scene));
}

} // namespace

SceneWriter ColladaSource::rewriter(const QString &suffix) const
{
    return suffix == QLatin1String("dae") ? writeRewrittenCollada : nullptr;
}

QStringList ColladaSource::rewritingLosses(const Scene &scene) const
{
    QStringList losses;
    std::set<std::pair<std::size_t, std::size_t>> seen;
    const auto isNew = [&](const ColladaPlace &place) {
        const bool unique = scene.uniqueMeshes && place.url > 0;
        return seen.insert({place.geometry, place.primitive}).second || unique;
    };
    if (!std::all_of(places.begin(), places.end(), isNew))
        losses << QCoreApplication::translate(
            "ExportLosses", "meshes that several nodes share get the UVs of the first node, unless they "
                            "are made unique");
    if (scene.uvSets.size() < setsInFile.size())
        losses << QCoreApplication::translate(
            "ExportLosses",
            "UV sets that were removed stay in the file: its materials name UV sets by their numbers");
    if (scene.uvSets.size() > maxAssimpUvSets)
        losses << QCoreApplication::translate("ExportLosses", "UV sets after the eighth are lost");
    return losses;
}

std::vector<SharedMesh> ColladaSource::sharedMeshes(bool unique) const
{
    MeshesByPlace meshes;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const ColladaPlace &place = places[p];
        if (unique && place.url > 0)
            continue;
        SharedMesh &mesh = meshes[{place.geometry, place.primitive}];
        mesh.faceCount = pieces[p].faceCount;
        mesh.instances.push_back({pieces[p].firstFace, pieces[p].mirrored});
    }
    return severalTimesShown(std::move(meshes));
}

Result<std::shared_ptr<const FileSource>> ColladaSource::withUniqueMeshes(const QString & /*path*/) const
{
    return std::shared_ptr<const FileSource>(withUniqueGeometries(*this));
}

} // namespace autocuts
