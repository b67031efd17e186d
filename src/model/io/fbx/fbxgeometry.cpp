#include "model/io/fbx/fbxgeometry.h"

#include "model/io/files/meshlimits.h"

#include <cmath>
#include <limits>

namespace autocuts {

namespace {

//! To what the values of a layer element belong. Unknown: only their number says it.
enum class Mapping { Unknown, Corner, Point, Polygon, Same };

Mapping mappingOf(const FbxTree &tree, int element)
{
    const std::string_view text = tree.text(tree.child(element, "MappingInformationType"));
    if (text == "ByPolygonVertex")
        return Mapping::Corner;
    if (text == "ByVertice" || text == "ByVertex" || text == "ByControlPoint")
        return Mapping::Point;
    if (text == "ByPolygon")
        return Mapping::Polygon;
    return text == "AllSame" ? Mapping::Same : Mapping::Unknown;
}

//! True when three of the polygon's control points differ and all are known.
bool isFace(const std::vector<int> &points, int begin, int end, const std::vector<bool> &usable)
{
    int other = -1;
    bool third = false;
    for (int c = begin; c < end; ++c) {
        if (points[c] < 0 || points[c] >= std::ssize(usable) || !usable[points[c]])
            return false;
        if (points[c] == points[begin])
            continue;
        third = third || (other >= 0 && points[c] != other);
        other = points[c];
    }
    return third;
}

//! Splits the list of corners into polygons: the last corner of each is negative. What follows the last
//! polygon stays a polygon that cannot be used.
void splitPolygons(FbxGeometry &geometry, std::vector<int> indices)
{
    for (std::size_t c = 0; c < indices.size(); ++c) {
        if (indices[c] >= 0)
            continue;
        indices[c] = -1 - indices[c];
        geometry.polygonStart.push_back(static_cast<int>(c + 1));
    }
    if (geometry.polygonStart.back() < std::ssize(indices)) {
        indices.back() = -1;
        geometry.polygonStart.push_back(static_cast<int>(indices.size()));
    }
    geometry.cornerPoint = std::move(indices);
}

} // namespace

std::optional<FbxGeometry> readFbxGeometry(const FbxTree &tree, int node)
{
    const std::optional<std::vector<double>> points = tree.doubles(tree.child(node, "Vertices"));
    std::optional<std::vector<int>> indices = tree.integers(tree.child(node, "PolygonVertexIndex"));
    if (!points || !indices || points->size() / 3 > maxElements || indices->size() > maxElements)
        return {};
    FbxGeometry geometry;
    geometry.node = node;
    const auto count = static_cast<Eigen::Index>(points->size() / 3);
    geometry.points = Eigen::Map<const PositionMatrix>(points->data(), count, 3);
    std::vector<bool> usable(static_cast<std::size_t>(count));
    for (Eigen::Index p = 0; p < count; ++p) {
        usable[static_cast<std::size_t>(p)] = geometry.points.row(p).allFinite() &&
                                              geometry.points.row(p).cwiseAbs().maxCoeff() <= maxCoordinate;
        if (!usable[static_cast<std::size_t>(p)])
            geometry.points.row(p).setZero();
    }
    splitPolygons(geometry, std::move(*indices));
    for (int f = 0; f < geometry.polygonCount(); ++f) {
        const int begin = geometry.polygonStart[f];
        const int end = geometry.polygonStart[f + 1];
        if (isFace(geometry.cornerPoint, begin, end, usable))
            geometry.faces.push_back(f);
        else
            ++(end - begin < 3 ? geometry.skippedElements : geometry.skippedFaces);
    }
    return geometry;
}

std::optional<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
readFbxLayer(const FbxTree &tree, int element, const FbxGeometry &geometry, std::string_view values,
             std::string_view indices, int width)
{
    Mapping mapping = mappingOf(tree, element);
    const std::optional<std::vector<double>> numbers = tree.doubles(tree.child(element, values));
    if (!numbers)
        return {};
    const std::string_view reference = tree.text(tree.child(element, "ReferenceInformationType"));
    const int list = reference == "Direct" ? -1 : tree.child(element, indices);
    std::vector<int> index;
    if (list >= 0) {
        std::optional<std::vector<int>> read = tree.integers(list);
        if (!read)
            return {};
        index = std::move(*read);
    }
    const auto rows = static_cast<std::int64_t>(numbers->size()) / width;
    const std::int64_t entries = list >= 0 ? std::ssize(index) : rows;
    if (mapping == Mapping::Unknown && entries == geometry.cornerCount())
        mapping = Mapping::Corner;
    else if (mapping == Mapping::Unknown && entries == geometry.points.rows())
        mapping = Mapping::Point;
    const std::int64_t needed = mapping == Mapping::Corner    ? geometry.cornerCount()
                                : mapping == Mapping::Point   ? geometry.points.rows()
                                : mapping == Mapping::Polygon ? geometry.polygonCount()
                                : mapping == Mapping::Same    ? 1
                                                              : entries + 1;
    if (entries < needed || !tree.take(geometry.cornerCount() * qint64(width) * 8))
        return {};
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(geometry.cornerCount(),
                                                                                  width);
    result.fill(std::numeric_limits<double>::quiet_NaN());
    const auto entryOf = [&](int polygon, int corner) {
        return mapping == Mapping::Corner    ? corner
               : mapping == Mapping::Point   ? geometry.cornerPoint[corner]
               : mapping == Mapping::Polygon ? polygon
                                             : 0;
    };
    for (int f = 0; f < geometry.polygonCount(); ++f) {
        for (int c = geometry.polygonStart[f]; c < geometry.polygonStart[f + 1]; ++c) {
            std::int64_t entry = entryOf(f, c);
            if (entry < 0 || entry >= entries)
                continue;
            if (list >= 0)
                entry = index[static_cast<std::size_t>(entry)];
            if (entry < 0 || entry >= rows)
                continue;
            for (int k = 0; k < width; ++k)
                result(c, k) = (*numbers)[static_cast<std::size_t>(entry * width + k)];
        }
    }
    return result;
}

UvMatrix readFbxUv(const FbxTree &tree, int element, const FbxGeometry &geometry, bool &fits)
{
    const auto read = readFbxLayer(tree, element, geometry, "UV", "UVIndex", 2);
    fits = read.has_value();
    if (fits)
        return *read;
    return UvMatrix::Constant(geometry.cornerCount(), 2, std::numeric_limits<double>::quiet_NaN());
}

QString fbxLayerName(const FbxTree &tree, int element)
{
    const std::string_view name = tree.text(tree.child(element, "Name"));
    return tree.binary ? QString::fromUtf8(name.data(), std::ssize(name))
                       : QString::fromUtf8(unescapedFbx(name));
}

} // namespace autocuts
