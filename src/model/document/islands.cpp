#include "model/document/islands.h"

#include "model/document/constraints.h"

#include <algorithm>
#include <map>

namespace autocuts {

IslandMarks IslandMarks::none(const MeshData &mesh)
{
    IslandMarks marks;
    marks.faceFlags.resize(mesh.faceCount());
    return marks;
}

IslandFlags IslandMarks::flagsOf(const std::vector<int> &faces) const
{
    return autocuts::flagsOf(faceFlags, faces);
}

std::vector<QString> IslandMarks::tagsOf(const std::vector<int> &faces) const
{
    std::vector<QString> names;
    for (const IslandTag &tag : tags) {
        const auto carried = std::count_if(faces.begin(), faces.end(), [&](int face) {
            return std::binary_search(tag.faces.begin(), tag.faces.end(), face);
        });
        if (carried > 0 && 2 * carried >= static_cast<std::ptrdiff_t>(faces.size()))
            names.push_back(tag.name);
    }
    return names;
}

const IslandTag *IslandMarks::tag(const QString &name) const
{
    const auto it = std::lower_bound(tags.begin(), tags.end(), name,
                                     [](const IslandTag &t, const QString &n) { return t.name < n; });
    return it != tags.end() && it->name == name ? &*it : nullptr;
}

QString IslandMarks::validate(const MeshData &mesh) const
{
    if (static_cast<int>(faceFlags.size()) != mesh.faceCount())
        return QStringLiteral("The island flags do not fit the mesh");
    for (const IslandFlags &flags : faceFlags) {
        if (!isValid(flags))
            return QStringLiteral("An island flag is out of range");
    }
    for (std::size_t i = 0; i < tags.size(); ++i) {
        if (tags[i].name.isEmpty() || tags[i].name.size() > maxNameLength || tags[i].faces.isEmpty() ||
            !isIndexSet(tags[i].faces, mesh.faceCount()))
            return QStringLiteral("Tag %1 is not valid").arg(i);
        if (i > 0 && !(tags[i - 1].name < tags[i].name))
            return QStringLiteral("The tags are not in order");
    }
    return {};
}

Islands::Islands(const MeshData &mesh, const UvMatrix &uv)
    : mCharts(findCharts(mesh, uv)), mFaces(mCharts.faces()), mBoxes(mCharts.count)
{
    for (int island = 0; island < mCharts.count; ++island) {
        for (int face : mFaces[island]) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                mBoxes[island].extend(Vec2(uv.row(c)));
        }
    }
}

std::vector<int> Islands::corners(const MeshData &mesh, const std::vector<int> &islands) const
{
    std::vector<int> result;
    for (int island : islands) {
        for (int face : mFaces[island]) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                result.push_back(c);
        }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::vector<int> Islands::islandsOf(const QList<int> &faces) const
{
    std::vector<int> result;
    for (int face : faces) {
        if (mCharts.faceChart[face] >= 0)
            result.push_back(mCharts.faceChart[face]);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

} // namespace autocuts
