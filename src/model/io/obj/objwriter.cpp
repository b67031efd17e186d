#include "model/io/obj/objwriter.h"

#include "model/io/files/savefile.h"
#include "model/io/formats/materiallooks.h"
#include "model/io/formats/modelunits.h"
#include "model/io/formats/uvcorners.h"
#include "model/io/obj/objrewriter.h"

#include <QDir>
#include <QFileInfo>

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace autocuts {

namespace {

//! Keywords of pictures, see objmaterials.
constexpr std::pair<const char *, TextureChannel> mtlMaps[] = {
    {"map_Kd", TextureChannel::BaseColor}, {"map_Bump", TextureChannel::Normal},
    {"map_Pr", TextureChannel::Roughness}, {"map_Pm", TextureChannel::Metalness},
    {"map_Ke", TextureChannel::Emission},  {"disp", TextureChannel::Height}};

//! The active UV set; rows without UVs when the scene has no UV set.
UvMatrix activeUv(const Scene &scene)
{
    if (!scene.uvSets.empty())
        return scene.uvSets.front().uv;
    UvMatrix none(scene.mesh->cornerCount(), 2);
    none.fill(std::numeric_limits<double>::quiet_NaN());
    return none;
}

//! True when the UVs of all corners have the same bits; two missing UVs are equal.
bool sameUv(const ObjSource &source, const UvMatrix &uv)
{
    for (Eigen::Index c = 0; c < uv.rows(); ++c) {
        const int vt = source.cornerTextureVertex[static_cast<std::size_t>(c)];
        const double *now = uv.data() + 2 * c;
        const double *then = vt < 0 ? nullptr : &source.textureVertices[2 * static_cast<std::size_t>(vt)];
        const bool hasNow = std::isfinite(now[0]) && std::isfinite(now[1]);
        const bool hadThen = then && std::isfinite(then[0]) && std::isfinite(then[1]);
        if (hasNow != hadThen || (hasNow && std::memcmp(now, then, 2 * sizeof *now) != 0))
            return false;
    }
    return true;
}

//! Replaces the characters that would end a name or the line.
QByteArray cleanName(const QString &name, const char *fallback)
{
    const QByteArray clean = name.simplified().toUtf8();
    return clean.isEmpty() ? QByteArray(fallback) : clean;
}

//! The names of the objects. Objects of equal names would be read as one, so they get numbers.
std::vector<QByteArray> objectNames(const Scene &scene)
{
    std::set<QByteArray> used;
    std::vector<QByteArray> names;
    for (const QString &name : scene.objectNames) {
        const QByteArray wanted = cleanName(name, "object");
        QByteArray unique = wanted;
        for (int i = 2; !used.insert(unique).second; ++i)
            unique = wanted + '.' + QByteArray::number(i);
        names.push_back(unique);
    }
    return names;
}

void appendPositions(QByteArray &out, const PositionMatrix &positions)
{
    char text[40];
    for (Eigen::Index v = 0; v < positions.rows(); ++v) {
        out.append('v');
        for (int k = 0; k < 3; ++k) {
            out.append(' ');
            out.append(text, std::to_chars(text, text + sizeof text, positions(v, k)).ptr - text);
        }
        out.append('\n');
    }
}

//! The first line of our libraries: they may be replaced.
constexpr QByteArrayView libraryHead("# Materials of Autocuts\n");

//! What the materials look like, by their names in plainObj().
QByteArray materialLibrary(const Scene &scene, MaterialLooks &looks)
{
    QByteArray out(libraryHead.data(), libraryHead.size());
    std::set<QByteArray> written;
    for (int m = 0; m < std::ssize(scene.materialNames); ++m) {
        const QByteArray name = cleanName(scene.materialNames[static_cast<std::size_t>(m)], "material");
        if (!written.insert(name).second)
            continue;
        out.append("newmtl ").append(name).append("\nKd");
        for (const double share : looks.color(m))
            out.append(' ').append(QByteArray::number(share, 'g', 6));
        out.append('\n');
        for (const auto &[keyword, channel] : mtlMaps) {
            const ChannelPicture entry = looks.picture(m, channel);
            if (!entry.picture.isEmpty() && entry.component <= 0)
                out.append(keyword).append(' ').append(looks.fileOf(entry.picture).toUtf8()).append('\n');
        }
    }
    return out;
}

//! Beside the output, under its name unless a library of that name is there that this program has not
//! written.
QString placeOfLibrary(const QString &output)
{
    const QString stem = QFileInfo(output).absoluteDir().filePath(QFileInfo(output).completeBaseName());
    const auto isOurs = [](const QString &path) {
        if (!QFileInfo::exists(path))
            return true;
        const Result<QByteArray> there = loadFile(path, std::numeric_limits<qint64>::max());
        return there && there->startsWith(libraryHead);
    };
    QString path = stem + QStringLiteral(".mtl");
    for (int number = 2; !isOurs(path); ++number)
        path = QStringLiteral("%1-%2.mtl").arg(stem).arg(number);
    return path;
}

QByteArray plainObj(const Scene &scene)
{
    const MeshData &mesh = *scene.mesh;
    const UvMatrix uv = activeUv(scene);
    const std::vector<int> shared = sharedUvCorners(mesh, uv);
    QByteArray out;
    appendPositions(out, inUnits(mesh.positions, unitsOf(scene), unitsOfFormat(QStringLiteral("obj"))));
    std::vector<int> index(shared.size(), 0);
    int next = 1;
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        if (shared[c] != c)
            continue;
        index[c] = next++;
        appendTextureVertex(out, uv(c, 0), uv(c, 1));
        out.append('\n');
    }
    const std::vector<QByteArray> names = objectNames(scene);
    int object = -1;
    int material = -1;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.faceObject[f] != object) {
            object = mesh.faceObject[f];
            if (object >= 0 && object < std::ssize(names))
                out.append("o ").append(names[object]).append('\n');
        }
        if (f < std::ssize(scene.faceMaterial) && scene.faceMaterial[f] != material) {
            material = scene.faceMaterial[f];
            out.append("usemtl ");
            out.append(material >= 0 ? cleanName(scene.materialNames[material], "material") : QByteArray());
            out.append('\n');
        }
        out.append('f');
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c) {
            out.append(' ').append(QByteArray::number(mesh.cornerVertex[c] + 1));
            if (shared[c] >= 0)
                out.append('/').append(QByteArray::number(index[shared[c]]));
        }
        out.append('\n');
    }
    return out;
}

} // namespace

QByteArray objBytes(const Scene &scene)
{
    const auto *source = sourceOf<ObjSource>(scene);
    if (!source)
        return plainObj(scene);
    const UvMatrix uv = activeUv(scene);
    return sameUv(*source, uv) ? source->bytes : rewriteObj(*source, *scene.mesh, uv);
}

QStringList filesBesideObj(const Scene &scene, const QString &path)
{
    if (sourceOf<ObjSource>(scene) || scene.materialNames.empty())
        return {};
    return MaterialLooks(scene, path).placeAll() << placeOfLibrary(path);
}

Result<Done> writeObj(const Scene &scene, const QString &path)
{
    const QByteArray bytes = objBytes(scene);
    if (sourceOf<ObjSource>(scene) || scene.materialNames.empty())
        return saveAtomically(path, bytes);
    MaterialLooks looks(scene, path);
    const QByteArray library = materialLibrary(scene, looks);
    const QString libraryPath = placeOfLibrary(path);
    FileSet files;
    if (Result<Done> added = looks.addFiles(files); !added)
        return added;
    if (Result<Done> added = files.add(libraryPath, library); !added)
        return added;
    const QByteArray line = "mtllib " + QFileInfo(libraryPath).fileName().toUtf8() + '\n';
    if (Result<Done> added = files.add(path, line + bytes); !added)
        return added;
    return files.putInPlace();
}

} // namespace autocuts
