#include "link/handedmodel.h"

#include "link/linktextures.h"
#include "model/document/constraints.h"
#include "model/io/files/meshlimits.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace autocuts::link {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qsizetype mostUvSets = 32; // chosen by hand

std::vector<QString> namesIn(const QJsonValue &list)
{
    std::vector<QString> names;
    const QJsonArray array = list.toArray();
    for (const QJsonValue &name : array)
        names.push_back(name.toString().left(maxNameLength));
    return names;
}

//! An array that has as many numbers as there are faces; `missing` for all when it is not there.
Result<std::vector<int>> perFace(const Message &message, const QString &name, std::size_t faces, int missing,
                                 std::size_t names)
{
    Result<std::vector<int>> values = message.integers(name);
    if (!values)
        return values;
    if (!message.has(name))
        return std::vector<int>(faces, missing);
    const auto fits = [=](int value) { return value >= missing && value < int(names); };
    if (values->size() != faces || !std::ranges::all_of(values.value(), fits))
        return linkError(u"the array \"%1\" does not fit the faces"_s.arg(name));
    return values;
}

//! Where the corners of each face begin, from their number in each face.
Result<std::vector<int>> readStarts(const Message &message, std::size_t corners)
{
    const Result<std::vector<int>> sizes = message.integers(u"sizes"_s);
    if (!sizes)
        return sizes.error();
    std::vector<int> starts{0};
    starts.reserve(sizes->size() + 1);
    for (const int size : sizes.value()) {
        if (size < 3 || std::size_t(size) > corners - std::size_t(starts.back()))
            return linkError(u"a face has %1 corners"_s.arg(size));
        starts.push_back(starts.back() + size);
    }
    if (sizes->empty() || std::size_t(starts.back()) != corners)
        return linkError(u"the faces do not have all corners"_s);
    return starts;
}

Result<PositionMatrix> readPositions(const Message &message)
{
    const Result<std::vector<double>> read = message.numbers(u"positions"_s, 3);
    if (!read)
        return read.error();
    if (!std::ranges::all_of(read.value(), [](double x) { return std::abs(x) <= maxCoordinate; }))
        return linkError(u"a position is not a number that can be used"_s);
    PositionMatrix positions =
        Eigen::Map<const PositionMatrix>(read->data(), Eigen::Index(read->size() / 3), 3);
    if (message.fields().value("up"_L1).toString() == "z"_L1) {
        positions.col(1).swap(positions.col(2));
        positions.col(2) *= -1;
    }
    return positions;
}

//! The UV sets, the active one first. NaN for corners without a UV.
Result<std::vector<UvSet>> readUvSets(const Message &message, int corners)
{
    const std::vector<QString> names = namesIn(message.fields().value("uvSets"_L1));
    if (std::ssize(names) > mostUvSets)
        return linkError(u"there are %1 UV sets"_s.arg(names.size()));
    std::vector<UvSet> sets;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Result<std::vector<double>> uvs = message.numbers(u"uvs%1"_s.arg(i), 2);
        if (!uvs)
            return uvs.error();
        if (uvs->size() != 2 * std::size_t(corners))
            return linkError(u"the UV set \"%1\" does not fit the corners"_s.arg(names[i]));
        UvMatrix uv = Eigen::Map<const UvMatrix>(uvs->data(), corners, 2);
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            if (!(uv.row(c).cwiseAbs().maxCoeff() <= maxCoordinate))
                uv.row(c).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        sets.push_back({names[i], std::move(uv)});
    }
    return sets;
}

void takeMaterials(const QJsonValue &list, Scene &scene)
{
    NamedTextures materials = NamedTextures::read(list);
    for (TextureSet &set : materials.sets) {
        scene.materialTextures.push_back(set[TextureChannel::BaseColor].picture);
        set.erase(TextureChannel::BaseColor);
    }
    scene.materialNames = std::move(materials.names);
    scene.materialSets = std::move(materials.sets);
}

//! The polygons, their objects and materials.
Result<Done> takePolygons(const Message &message, Scene &scene)
{
    Result<PositionMatrix> positions = readPositions(message);
    if (!positions)
        return positions.error();
    Result<std::vector<int>> corners = message.integers(u"corners"_s);
    if (!corners)
        return corners.error();
    const auto outside = [&](int v) { return v < 0 || v >= positions->rows(); };
    if (std::ranges::any_of(corners.value(), outside) || corners->size() > maxElements)
        return linkError(u"a corner has a vertex that is not there"_s);
    Result<std::vector<int>> starts = readStarts(message, corners->size());
    if (!starts)
        return starts.error();
    const std::size_t faces = starts->size() - 1;
    Result<std::vector<int>> objects = perFace(message, u"faceObjects"_s, faces, 0, scene.objectNames.size());
    if (!objects)
        return objects.error();
    Result<std::vector<int>> materials =
        perFace(message, u"faceMaterials"_s, faces, -1, scene.materialNames.size());
    if (!materials)
        return materials.error();
    scene.faceMaterial = std::move(materials).value();
    scene.mesh = MeshData::build(std::move(positions).value(), std::move(starts).value(),
                                 std::move(corners).value(), std::move(objects).value());
    return Done();
}

} // namespace

int serialOf(const Message &message)
{
    return message.fields().value("serial"_L1).toInt();
}

Result<HandedModel> readHandedModel(const Message &message)
{
    HandedModel model;
    model.serial = serialOf(message);
    model.opens = message.fields().value("open"_L1).toBool();
    model.scene.path = message.fields().value("model"_L1).toString().left(maxNameLength);
    model.scene.objectNames = namesIn(message.fields().value("objects"_L1));
    if (model.serial <= 0 || model.scene.path.isEmpty() || model.scene.objectNames.empty())
        return linkError(u"a model has no number, no name or no objects"_s);
    takeMaterials(message.fields().value("materials"_L1), model.scene);
    if (const Result<Done> taken = takePolygons(message, model.scene); !taken)
        return taken.error();
    const MeshData &mesh = *model.scene.mesh;
    Result<std::vector<UvSet>> sets = readUvSets(message, mesh.cornerCount());
    if (!sets)
        return sets.error();
    model.scene.uvSets = std::move(sets).value();
    Result<MarkChanges> marks =
        MarkChanges::read(message, int(mesh.positions.rows()), mesh.cornerCount(), mesh.faceCount());
    if (!marks)
        return marks.error();
    model.marks = std::move(marks).value();
    model.edges = std::make_shared<const VertexPairs>(mesh);
    return model;
}

} // namespace autocuts::link
