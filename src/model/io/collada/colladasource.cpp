#include "model/io/collada/colladasource.h"

#include "model/io/assimp/assimpreader.h"
#include "model/io/collada/colladamesh.h"
#include "model/io/files/savefile.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace autocuts {

namespace {

constexpr qint64 maxColladaSize = qint64(1) << 30;
//! Assimp reads numbers in single precision, and not to the last digit.
constexpr double tolerance = 1e-5;

std::string_view textOf(const QByteArray &bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

//! The corners of the faces of three corners and more.
std::vector<int> cornersOfFaces(const ColladaPrimitive &primitive)
{
    std::vector<int> corners;
    int corner = 0;
    for (const int size : primitive.faceSizes) {
        for (int k = 0; k < size && size >= 3; ++k)
            corners.push_back(corner + k);
        corner += size;
    }
    return corners;
}

//! Finds the primitives of the pieces.
class PlaceFinder
{
public:
    PlaceFinder(const ColladaFile &file, const Scene &scene, const AssimpSource &source)
        : mFile(file), mScene(scene), mSource(source)
    {}

    //! Empty when one is not found.
    std::vector<ColladaPlace> run();

private:
    bool fits(const AssimpPiece &piece, const ColladaGeometry &geometry, std::size_t primitive) const;
    bool hasUvs(const AssimpPiece &piece, const ColladaGeometry &geometry, std::size_t primitive,
                const std::vector<int> &corners) const;

    const ColladaFile &mFile;
    const Scene &mScene;
    const AssimpSource &mSource;
};

//! Compares the UVs of the scene with those of the text.
bool PlaceFinder::hasUvs(const AssimpPiece &piece, const ColladaGeometry &geometry, std::size_t number,
                         const std::vector<int> &corners) const
{
    const ColladaPrimitive &primitive = geometry.primitives[number];
    const std::vector<int> sets = geometry.setsOf(number);
    for (std::size_t s = 0; s < mScene.uvSets.size(); ++s) {
        const ColladaInput *input = s < sets.size() ? primitive.texcoord(sets[s]) : nullptr;
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const auto row = mScene.uvSets[s].uv.row(pieceCorner(*mScene.mesh, piece, static_cast<int>(c)));
            if (!input) {
                if (row.allFinite() && !row.isZero(0))
                    return false;
                continue;
            }
            const ColladaNumbers &numbers = mFile.sources.at(input->source);
            const int index =
                primitive.indices[static_cast<std::size_t>(corners[c] * primitive.stride + input->offset)];
            const double *uv = numbers.values.data() + static_cast<std::ptrdiff_t>(index) * numbers.stride;
            // Numbers that are not finite are not compared.
            for (int k = 0; k < 2; ++k) {
                if (std::abs(row[k] - uv[k]) > tolerance * std::max(1.0, std::abs(uv[k])))
                    return false;
            }
        }
    }
    return true;
}

bool PlaceFinder::fits(const AssimpPiece &piece, const ColladaGeometry &geometry, std::size_t number) const
{
    const ColladaPrimitive &primitive = geometry.primitives[number];
    const std::vector<int> corners = cornersOfFaces(primitive);
    const std::vector<Vec3> wanted = positionsOf(mFile, geometry, primitive);
    const std::vector<Vec3> found = pieceCorners(mSource, piece);
    if (wanted.empty() || found.size() != corners.size())
        return false;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const Vec3 &position = wanted[static_cast<std::size_t>(corners[c])];
        if (!((position - found[c]).norm() <= tolerance * std::max(1.0, position.norm())))
            return false;
    }
    return hasUvs(piece, geometry, number, corners);
}

std::vector<ColladaPlace> PlaceFinder::run()
{
    std::vector<ColladaPlace> places;
    std::unordered_map<std::string_view, std::size_t> named; // the first geometry of each id or name
    for (std::size_t g = 0; g < mFile.geometries.size(); ++g) {
        named.try_emplace(mFile.geometries[g].id, g);
        named.try_emplace(mFile.geometries[g].name, g);
    }
    for (std::size_t p = 0; p < mSource.pieces.size(); ++p) {
        const AssimpPiece &piece = mSource.pieces[p];
        const std::string name = pieceName(mSource, piece);
        const auto found = named.find(name);
        if (found == named.end())
            return {};
        const std::size_t number = found->second;
        const ColladaGeometry &geometry = mFile.geometries[number];
        // Pieces of one node follow the order of the primitives.
        const bool goesOn =
            p > 0 && mSource.pieces[p - 1].node == piece.node && places.back().geometry == number;
        std::size_t primitive = goesOn ? places.back().primitive + 1 : 0;
        while (primitive < geometry.primitives.size() && !fits(piece, geometry, primitive))
            ++primitive;
        if (primitive == geometry.primitives.size())
            return {};
        places.push_back({number, primitive});
    }
    return places;
}

//! Gives the scene a ColladaSource if the text of its file is understood.
void keepCollada(Scene &scene)
{
    const auto *assimp = sourceOf<AssimpSource>(scene);
    Result<QByteArray> bytes = loadFile(scene.path, maxColladaSize);
    // Text in UTF-16 contains zeros.
    if (!assimp || !bytes || bytes->contains('\0'))
        return;
    const std::optional<ColladaFile> file = readCollada(textOf(bytes.value()));
    if (!file)
        return;
    std::vector<ColladaPlace> places = PlaceFinder(*file, scene, *assimp).run();
    if (places.empty())
        return;
    findUrls(*file, textOf(bytes.value()), assimp->pieces, places);
    auto source = std::make_shared<ColladaSource>();
    static_cast<AssimpSource &>(*source) = *assimp;
    source->bytes = std::move(bytes).value();
    source->places = std::move(places);
    source->setsInFile = scene.uvSets;
    scene.source = std::move(source);
}

} // namespace

Result<Scene> readColladaFile(const QString &path, const std::atomic<bool> *stop)
{
    Result<Scene> scene = readWithAssimp(path, stop);
    if (scene)
        keepCollada(scene.value());
    return scene;
}

} // namespace autocuts
