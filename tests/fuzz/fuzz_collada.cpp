// Fuzzes the scanner and the rewriter of Collada files: any bytes are refused, or stay as they are while
// their UVs do, and get new ones where the old ones were.
#include "fuzz/fuzzing.h"
#include "model/io/collada/colladamesh.h"
#include "model/io/collada/colladasource.h"
#include "model/plain/uvlayout.h"

#include <cmath>
#include <cstdint>

using namespace autocuts;
using fuzz::require;

namespace {

//! A quad and a triangle with two UV sets, and a triangle that shares the source of the first.
constexpr const char *model = R"(<?xml version="1.0"?>
<COLLADA version="1.4.1"><library_geometries><geometry id="g" name="a &amp; b"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 1 1 0 0 1e0 +0</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"/></technique_common></source>
<source id="u"><float_array id="ua" count="6">0 0 1 0 .5 1</float_array><technique_common>
<accessor source='#ua' count="3" stride="2"/></technique_common></source><!-- kept -->
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="2"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#u"
offset="1" set="0"/><input semantic="TEXCOORD" source="#u" offset="0" set="2"/><vcount>4 3</vcount>
<p>0 0 1 1 2 2 2 2 0 0 1 1 2 2</p></polylist>
<triangles count="1"><input semantic="VERTEX" source="#v"/><input semantic="TEXCOORD" source="#u" offset="1"/>
<p>0 0 1 1 2 2</p></triangles></mesh></geometry></library_geometries></COLLADA>
)";

std::string_view textOf(const QByteArray &bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

//! Sees the file as the reader of foreign formats gives it: a piece for each primitive.
class Soup
{
public:
    explicit Soup(const ColladaFile &file);

    bool isEmpty() const { return mSource->pieces.empty(); }
    ColladaSource &source() { return *mSource; }
    Scene scene() const;

private:
    void add(const ColladaFile &file, std::size_t geometry, std::size_t primitive);

    std::shared_ptr<ColladaSource> mSource = std::make_shared<ColladaSource>();
    std::vector<int> mFaceStart{0};
    //! The UVs of each corner in the sets of its primitive.
    std::vector<std::vector<Vec2>> mUvs;
};

Soup::Soup(const ColladaFile &file)
{
    for (std::size_t g = 0; g < file.geometries.size(); ++g) {
        for (std::size_t p = 0; p < file.geometries[g].primitives.size(); ++p)
            add(file, g, p);
    }
}

void Soup::add(const ColladaFile &file, std::size_t g, std::size_t p)
{
    const ColladaGeometry &geometry = file.geometries[g];
    const ColladaPrimitive &primitive = geometry.primitives[p];
    if (positionsOf(file, geometry, primitive).empty())
        return;
    AssimpPiece piece;
    piece.firstVertex = mFaceStart.back();
    piece.firstFace = static_cast<int>(mFaceStart.size()) - 1;
    const std::vector<int> sets = geometry.setsOf(p);
    int corner = 0;
    for (const int size : primitive.faceSizes) {
        for (int k = 0; k < size && size >= 3; ++k) {
            mUvs.emplace_back();
            for (const int set : sets) {
                const ColladaInput *input = primitive.texcoord(set);
                const double *uv = nullptr;
                if (input) {
                    const ColladaNumbers &numbers = file.sources.at(input->source);
                    const auto place =
                        static_cast<std::size_t>((corner + k) * primitive.stride + input->offset);
                    uv = numbers.values.data() +
                         static_cast<std::ptrdiff_t>(primitive.indices[place]) * numbers.stride;
                }
                mUvs.back().push_back(uv ? Vec2(uv[0], uv[1]) : Vec2(0, 0));
            }
        }
        corner += size;
        if (size >= 3) {
            mFaceStart.push_back(mFaceStart.back() + size);
            ++piece.faceCount;
        }
    }
    if (piece.faceCount == 0)
        return;
    mSource->pieces.push_back(piece);
    mSource->places.push_back({g, p});
}

Scene Soup::scene() const
{
    const int corners = mFaceStart.back();
    // Only the numbers of faces and corners matter.
    PositionMatrix positions = PositionMatrix::Zero(corners, 3);
    std::vector<int> vertices(static_cast<std::size_t>(corners));
    for (int c = 0; c < corners; ++c) {
        vertices[static_cast<std::size_t>(c)] = c;
        positions(c, c % 3) = c;
    }
    Scene scene;
    scene.mesh = MeshData::build(std::move(positions), mFaceStart, std::move(vertices),
                                 std::vector<int>(mFaceStart.size() - 1, 0));
    std::size_t setCount = 0;
    for (const std::vector<Vec2> &uvs : mUvs)
        setCount = std::max(setCount, uvs.size());
    for (std::size_t s = 0; s < setCount; ++s) {
        UvMatrix uv = UvMatrix::Constant(corners, 2, std::nan(""));
        for (std::size_t c = 0; c < mUvs.size(); ++c) {
            if (s < mUvs[c].size())
                uv.row(static_cast<int>(c)) = mUvs[c][s];
        }
        scene.uvSets.push_back({QStringLiteral("set %1").arg(s), std::move(uv)});
    }
    return scene;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    fuzz::writeSeed(QStringLiteral("model.dae"), model);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    const std::optional<ColladaFile> file = readCollada(textOf(bytes));
    if (!file)
        return 0;
    Soup soup(*file);
    if (soup.isEmpty())
        return 0;
    Scene scene = soup.scene();
    soup.source().bytes = bytes;
    soup.source().setsInFile = scene.uvSets;
    require(rewriteCollada(soup.source(), scene) == bytes, "unchanged UVs are written");

    if (scene.uvSets.empty())
        scene.uvSets.push_back({QStringLiteral("new"), UvMatrix(scene.mesh->cornerCount(), 2)});
    for (int c = 0; c < scene.mesh->cornerCount(); ++c)
        scene.uvSets[0].uv.row(c) << 1.0 / (c + 3), -0.1 * c;
    const QByteArray written = rewriteCollada(soup.source(), scene);
    const std::optional<ColladaFile> again = readCollada(textOf(written));
    require(again.has_value(), "the written file cannot be read");
    const Scene found = Soup(*again).scene();
    require(found.mesh->faceStart == scene.mesh->faceStart, "the faces differ");
    require(!found.uvSets.empty(), "the UVs are missing");
    for (int c = 0; c < scene.mesh->cornerCount(); ++c)
        require(sameBits(found.uvSets[0].uv.row(c), scene.uvSets[0].uv.row(c)), "a UV differs");
    return 0;
}
