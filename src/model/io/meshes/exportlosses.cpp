#include "model/io/meshes/exportlosses.h"

#include "model/io/formats/filesource.h"
#include "model/io/formats/materiallooks.h"
#include "model/io/meshes/formatcalls.h"

#include <QCoreApplication>

namespace autocuts {

namespace {

struct LossTexts
{
    Q_DECLARE_TR_FUNCTIONS(ExportLosses)
};

//! True when the active set has UVs at some corners but not at all of them.
bool hasPartialUv(const Scene &scene)
{
    if (!scene.hasUv())
        return false;
    const UvMatrix &uv = scene.uvSets.front().uv;
    return !uv.allFinite();
}

//! Pictures that the format has no place for, and those that are not there.
QStringList pictureLosses(const Scene &scene, RoughnessPictures roughness)
{
    bool lost = false;
    QStringList missing;
    for (int m = 0; m < std::ssize(scene.materialNames); ++m) {
        const TextureSet set = scene.fileSet(m);
        const auto of = [&set](TextureChannel channel) {
            const auto found = set.find(channel);
            return found == set.end() ? ChannelPicture() : found->second;
        };
        const ChannelPicture rough = of(TextureChannel::Roughness), metal = of(TextureChannel::Metalness);
        const bool packed = rough.component > 0 || metal.component > 0;
        const bool together = rough.picture == metal.picture && rough.component == 1 && metal.component == 2;
        if (!rough.picture.isEmpty() || !metal.picture.isEmpty())
            lost = lost || (roughness == RoughnessPictures::AsGltf  ? !together
                            : roughness == RoughnessPictures::Apart ? packed
                                                                    : true);
    }
    if (const QStringList names = MaterialLooks(scene, scene.path).missing(); !names.isEmpty())
        missing << LossTexts::tr("pictures that are not found stay names: %1")
                       .arg(names.join(QLatin1String(", ")));
    if (lost)
        missing << LossTexts::tr(
            "pictures of roughness and metalness are lost: the format holds them in another "
            "way than this file");
    return missing;
}

QStringList shapeLosses(const SourceContents &contents)
{
    QStringList losses;
    if (contents.shapesWithoutFaces)
        losses << LossTexts::tr("curves and NURBS surfaces are lost: only their places are written");
    if (contents.stereoCameras)
        losses << LossTexts::tr("stereo cameras are lost: only their places are written");
    return losses;
}

//! What the format loses of the data besides the geometry.
QStringList contentLosses(const SourceContents &contents, const FormatLimits &limits)
{
    QStringList losses;
    if (contents.shapeKeys)
        losses << LossTexts::tr("shape keys (morph targets) are lost");
    if (!limits.nodes) {
        if (contents.animations || contents.bones)
            losses << LossTexts::tr("bones and animations are lost");
        if (contents.hierarchy)
            losses << LossTexts::tr("the node hierarchy is lost; positions are written in world space");
        if (contents.lightsOrCameras)
            losses << LossTexts::tr("lights and cameras are lost");
        return losses;
    }
    if (contents.instances)
        losses << LossTexts::tr("meshes that several nodes share become one copy per node, with its own UVs");
    if (contents.severalAnimations && !limits.animations)
        losses << LossTexts::tr("Only the first animation is written to Collada");
    if (contents.otherAnimations)
        losses << LossTexts::tr(
            "animations are kept of objects and bones only, not of shape keys, materials, "
            "lights and cameras");
    if (contents.dualQuaternions)
        losses << LossTexts::tr(
            "the dual quaternions by which bones bend meshes are lost: bent shapes differ");
    if (contents.otherScaling)
        losses << LossTexts::tr(
            "scales are passed on to all that is below: the file has another rule for some "
            "objects, whose shapes can differ");
    losses << shapeLosses(contents);
    if (contents.bones && !contents.animations && !limits.animations)
        losses << LossTexts::tr("some programs show a Collada model without animations in its rest pose");
    return losses;
}

//! What is lost of an FBX file that Assimp does not read, or reads with other polygons.
QStringList plainFbxLosses(const SourceContents &contents)
{
    QStringList losses;
    if (contents.bones || contents.animations)
        losses << LossTexts::tr("bones and animations are lost: only FBX can hold those of this file");
    if (contents.shapeKeys)
        losses << LossTexts::tr("shape keys (morph targets) are lost");
    if (contents.hierarchy || contents.lightsOrCameras)
        losses << LossTexts::tr("the node hierarchy, lights and cameras are lost; positions are written in "
                                "world space");
    losses << LossTexts::tr("normals and vertex colours are lost");
    return losses;
}

//! \param readByAssimp the new file gets what Assimp reads of the scene's file
QStringList lossesOf(const Scene &scene, const QString &format, bool readByAssimp)
{
    const FileSource *source = sourceOf(scene);
    if (source && source->rewriter(format))
        return source->rewritingLosses(scene);
    const SourceContents contents = source ? source->contents : SourceContents();
    const FormatLimits &limits = callsOf(format).limits;
    QStringList losses = readByAssimp || !callsOf(format).takesNodes ? contentLosses(contents, limits)
                                                                     : plainFbxLosses(contents);
    if (limits.materials)
        losses << pictureLosses(scene, limits.roughness);
    if (contents.comments && !limits.comments)
        losses << (limits.smoothing
                       ? LossTexts::tr("comments and groups of the OBJ file are lost")
                       : LossTexts::tr("comments, groups and smoothing groups of the OBJ file are lost"));
    if (scene.objectNames.size() > 1 && !limits.objects)
        losses << LossTexts::tr("%1 holds one object: all are joined").arg(limits.name);
    if (!scene.materialNames.empty() && !limits.materials)
        losses << LossTexts::tr("materials are lost");
    if (scene.uvSets.size() > 1 && limits.uvSets == 1)
        losses << LossTexts::tr("%1 holds one UV set: only \"%2\" is written")
                      .arg(limits.name, scene.uvSets.front().name);
    else if (scene.uvSets.size() > limits.uvSets)
        losses << LossTexts::tr("UV sets after the eighth are lost");
    if (!limits.normals)
        losses << LossTexts::tr("normals and vertex colours are lost");
    if (!limits.polygons && scene.mesh->report.polygons > 0)
        losses << LossTexts::tr("%1 holds triangles only: polygons are split").arg(limits.name);
    if (!limits.partialUvs && hasPartialUv(scene))
        losses << LossTexts::tr("corners without UV get the UV 0 0");
    if (!limits.doubles)
        losses << LossTexts::tr("positions and UVs are rounded to single precision");
    return losses;
}

} // namespace

QStringList exportLosses(const Scene &scene, const QString &format)
{
    const FileSource *source = sourceOf(scene);
    return lossesOf(scene, format, !source || source->readByAssimp() != FileSource::ByAssimp::Never);
}

QStringList certainExportLosses(const Scene &scene, const QString &format)
{
    const FileSource *source = sourceOf(scene);
    const bool mustAsk = source && source->readByAssimp() == FileSource::ByAssimp::Perhaps &&
                         callsOf(format).takesNodes && !source->rewriter(format);
    return mustAsk ? lossesOf(scene, format, source->asAssimpReads(scene).has_value())
                   : exportLosses(scene, format);
}

} // namespace autocuts
