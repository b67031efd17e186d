#include "model/io/obj/objreader.h"

#include "model/io/files/meshlimits.h"
#include "model/io/files/savefile.h"
#include "model/io/obj/objmaterials.h"
#include "model/io/obj/objscanner.h"
#include "model/io/obj/objsource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace autocuts {

namespace {

//! Numbers names in the order of first use.
class NameTable
{
public:
    int operator()(std::string_view name)
    {
        const auto [it, isNew] = mIndex.try_emplace(std::string(name), static_cast<int>(mNames.size()));
        if (isNew)
            mNames.push_back(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
        return it->second;
    }
    std::vector<QString> take() { return std::move(mNames); }

private:
    std::map<std::string, int> mIndex;
    std::vector<QString> mNames;
};

//! The highest index that was used before it was defined, and the line that used it.
struct ForwardReference
{
    std::int64_t index = -1;
    int line = 0;
};

class ObjParser
{
public:
    ObjParser(QByteArray bytes, const QString &path) : mSource(std::make_shared<ObjSource>()), mPath(path)
    {
        mSource->bytes = std::move(bytes);
    }

    Result<Scene> parse(const std::atomic<bool> *stop);

private:
    bool readLine(const ObjScanner &scanner);
    bool readVertex(std::string_view arguments);
    void readVertexColor(std::string_view rest);
    bool readTextureVertex(std::string_view arguments);
    bool readFace(const ObjScanner &scanner);
    bool readCorner(std::string_view word);
    bool resolve(std::string_view word, std::size_t count, const char *what, ForwardReference &forward,
                 int &index);
    bool dropSmallFace(const ObjScanner &scanner, std::size_t begin);
    bool checkCompleteness();
    void addNotes(Scene &scene) const;
    CornerColors cornerColors() const;
    Scene makeScene();

    bool fail(const QString &message, const QString &remedy)
    {
        mError = Error{message, mPath, mLine, remedy};
        return false;
    }

    std::shared_ptr<ObjSource> mSource;
    QString mPath;
    std::optional<Error> mError;
    int mLine = 0;
    std::vector<double> mPositions;
    std::vector<int> mFaceStart{0}, mCornerVertex, mFaceObject, mFaceMaterial;
    NameTable mObjects, mMaterials;
    std::string_view mObjectName;
    int mObject = -1; //!< of the next face; -1 until a face needs it
    int mMaterial = -1;
    bool mSaysShading = false; //!< the file has normals or smoothing groups
    int mFaceLines = 0;
    int mFirstSkippedLine = 0;
    int mNonFiniteUvs = 0, mUvsWithDepth = 0;
    //! Three numbers per vertex, not finite where it has no colour; they end at the last one with a colour.
    std::vector<float> mVertexColors;
    bool mHasByteColors = false; //!< a number is above 1
    bool mHasShares = false;     //!< a number is between whole numbers
    int mBrokenColors = 0;
    ForwardReference mForwardVertex, mForwardTextureVertex;
};

QString exportAgain()
{
    return QStringLiteral("Export the model again from the program that made it");
}

bool ObjParser::readVertex(std::string_view arguments)
{
    std::string_view word;
    for (int k = 0; k < 3; ++k) {
        double value = 0;
        if (!nextWord(arguments, word))
            return fail(QStringLiteral("a vertex has fewer than three coordinates"), exportAgain());
        if (!parseNumber(word, value))
            return fail(QStringLiteral("a vertex coordinate is not a number"), exportAgain());
        if (!std::isfinite(value))
            return fail(QStringLiteral("a vertex coordinate is not finite"), exportAgain());
        if (std::abs(value) > maxCoordinate)
            return fail(QStringLiteral("a vertex coordinate is too large"),
                        QStringLiteral("Scale the model down and export it again"));
        mPositions.push_back(value);
    }
    if (mPositions.size() / 3 > maxElements)
        return fail(QStringLiteral("the file has too many vertices"),
                    QStringLiteral("Split the model into several files"));
    readVertexColor(arguments);
    return true;
}

//! Reads what follows the coordinates of the newest vertex: nothing, a weight, or a colour. Saving preserves
//! it.
void ObjParser::readVertexColor(std::string_view rest)
{
    std::string_view word;
    std::array<double, 3> color{};
    std::size_t count = 0;
    bool good = true;
    while (count < 3 && nextWord(rest, word)) {
        double &value = color[count++];
        good = good && parseNumber(word, value) && std::isfinite(value) && value >= 0;
    }
    if (count < 2)
        return;
    if (count < 3 || !good) {
        ++mBrokenColors;
        return;
    }
    mVertexColors.resize(mPositions.size() - 3, std::numeric_limits<float>::quiet_NaN());
    for (const double value : color) {
        mVertexColors.push_back(static_cast<float>(value));
        mHasByteColors = mHasByteColors || value > 1;
        mHasShares = mHasShares || value != std::floor(value);
    }
}

bool ObjParser::readTextureVertex(std::string_view arguments)
{
    std::string_view word;
    double uvw[3] = {0, 0, 0};
    int count = 0;
    while (count < 3 && nextWord(arguments, word)) {
        if (!parseNumber(word, uvw[count++]))
            return fail(QStringLiteral("a texture coordinate is not a number"), exportAgain());
    }
    if (count == 0)
        return fail(QStringLiteral("a texture vertex has no coordinates"), exportAgain());
    mNonFiniteUvs += !std::isfinite(uvw[0]) || !std::isfinite(uvw[1]);
    mUvsWithDepth += uvw[2] != 0;
    mSource->textureVertices.push_back(uvw[0]);
    mSource->textureVertices.push_back(uvw[1]);
    if (mSource->textureVertices.size() / 2 > maxElements)
        return fail(QStringLiteral("the file has too many texture vertices"),
                    QStringLiteral("Split the model into several files"));
    return true;
}

bool ObjParser::resolve(std::string_view word, std::size_t count, const char *what, ForwardReference &forward,
                        int &index)
{
    std::int64_t value = 0;
    const auto known = static_cast<std::int64_t>(count);
    if (!parseIndex(word, known, value) || value > std::numeric_limits<int>::max())
        return fail(QStringLiteral("a face has a wrong %1 index \"%2\"")
                        .arg(QString::fromLatin1(what),
                             QString::fromUtf8(word.data(), std::min<qsizetype>(std::ssize(word), 40))),
                    QStringLiteral("Indices start at 1 and refer to elements of this file; export it again"));
    if (value >= known && value > forward.index)
        forward = {value, mLine};
    index = static_cast<int>(value);
    return true;
}

bool ObjParser::readCorner(std::string_view word)
{
    const ObjCornerWord corner(word);
    if (corner.tooManyParts)
        return fail(QStringLiteral("a face corner has more than three indices"), exportAgain());
    int vertex = 0;
    int textureVertex = -1;
    if (!resolve(corner.vertex, mPositions.size() / 3, "vertex", mForwardVertex, vertex))
        return false;
    if (!corner.textureVertex.empty() && !resolve(corner.textureVertex, mSource->textureVertices.size() / 2,
                                                  "texture vertex", mForwardTextureVertex, textureVertex))
        return false;
    mCornerVertex.push_back(vertex);
    mSource->cornerTextureVertex.push_back(textureVertex);
    if (mCornerVertex.size() > maxElements)
        return fail(QStringLiteral("the file has too many face corners"),
                    QStringLiteral("Split the model into several files"));
    return true;
}

//! Removes the corners of a face that has fewer than three different vertices. False on an error.
bool ObjParser::dropSmallFace(const ObjScanner &scanner, std::size_t begin)
{
    if (mCornerVertex.size() - begin < 3 && !scanner.terminated())
        return fail(QStringLiteral("the file ends in the middle of a face"),
                    QStringLiteral("The file is truncated: copy or export it again"));
    mCornerVertex.resize(begin);
    mSource->cornerTextureVertex.resize(begin);
    mSource->skippedFaces.push_back(mFaceLines - 1);
    if (mFirstSkippedLine == 0)
        mFirstSkippedLine = mLine;
    return true;
}

bool ObjParser::readFace(const ObjScanner &scanner)
{
    const std::size_t begin = mCornerVertex.size();
    ++mFaceLines;
    std::string_view rest = scanner.arguments();
    std::string_view word;
    while (nextWord(rest, word)) {
        if (!readCorner(word))
            return false;
    }
    const auto first = mCornerVertex.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto isOther = [](int a) { return [a](int b) { return a != b; }; };
    const auto second =
        first == mCornerVertex.end() ? first : std::find_if(first, mCornerVertex.end(), isOther(*first));
    const bool hasThree =
        second != mCornerVertex.end() &&
        std::any_of(second, mCornerVertex.end(), [&](int v) { return v != *first && v != *second; });
    if (!hasThree)
        return dropSmallFace(scanner, begin);
    if (mObject < 0)
        mObject = mObjects(mObjectName);
    mFaceStart.push_back(static_cast<int>(mCornerVertex.size()));
    mFaceObject.push_back(mObject);
    mFaceMaterial.push_back(mMaterial);
    return true;
}

bool ObjParser::readLine(const ObjScanner &scanner)
{
    mLine = scanner.lineNumber();
    switch (scanner.statement()) {
    case ObjStatement::Vertex:
        return readVertex(scanner.arguments());
    case ObjStatement::TextureVertex:
        return readTextureVertex(scanner.arguments());
    case ObjStatement::Face:
        return readFace(scanner);
    case ObjStatement::Object:
        mObjectName = nameArgument(scanner.arguments());
        mObject = -1;
        return true;
    case ObjStatement::Material: {
        const std::string_view name = nameArgument(scanner.arguments());
        mMaterial = name.empty() ? -1 : mMaterials(name);
        return true;
    }
    case ObjStatement::Normal:
    case ObjStatement::Smoothing:
        mSaysShading = true;
        return true;
    default:
        return true;
    }
}

bool ObjParser::checkCompleteness()
{
    const auto check = [this](const ForwardReference &forward, std::size_t count, const char *what) {
        if (forward.index < static_cast<std::int64_t>(count))
            return true;
        mLine = forward.line;
        return fail(QStringLiteral("a face uses %1 %2, but the file has only %3")
                        .arg(QString::fromLatin1(what))
                        .arg(forward.index + 1)
                        .arg(count),
                    QStringLiteral("The file is damaged or truncated: copy or export it again"));
    };
    if (!check(mForwardVertex, mPositions.size() / 3, "vertex") ||
        !check(mForwardTextureVertex, mSource->textureVertices.size() / 2, "texture vertex"))
        return false;
    mLine = 0;
    if (mFaceStart.size() > 1)
        return true;
    return fail(QStringLiteral("the file has no faces"),
                QStringLiteral("Check that it is an OBJ file and that it holds polygons"));
}

void ObjParser::addNotes(Scene &scene) const
{
    if (!mSource->skippedFaces.empty())
        scene.notes.push_back(
            QStringLiteral("%1 face(s) of fewer than three different vertices left out, the "
                           "first in line %2")
                .arg(mSource->skippedFaces.size())
                .arg(mFirstSkippedLine));
    if (mNonFiniteUvs > 0)
        scene.notes.push_back(QStringLiteral("%1 texture vertices are not finite: their corners have no UV")
                                  .arg(mNonFiniteUvs));
    if (mBrokenColors > 0)
        scene.notes.push_back(
            QStringLiteral("%1 vertex colours left out: they are not three numbers from 0 on")
                .arg(mBrokenColors));
    if (mUvsWithDepth > 0)
        scene.notes.push_back(
            QStringLiteral("%1 texture vertices have a third coordinate, which is lost when the "
                           "UVs are changed")
                .arg(mUvsWithDepth));
}

//! Numbers go from 0 to 1; in files that have whole numbers only, and one above 1, to 255.
CornerColors ObjParser::cornerColors() const
{
    CornerColors colors;
    if (mVertexColors.empty())
        return colors;
    const double share = mHasByteColors && !mHasShares ? 1 / 255.0 : 1;
    colors.resize(mCornerVertex.size());
    for (std::size_t c = 0; c < colors.size(); ++c) {
        const std::size_t first = 3 * static_cast<std::size_t>(mCornerVertex[c]);
        if (first < mVertexColors.size())
            colors[c] = CornerColor::fromSrgb(share * mVertexColors[first], share * mVertexColors[first + 1],
                                              share * mVertexColors[first + 2]);
    }
    return colors;
}

Scene ObjParser::makeScene()
{
    Scene scene;
    scene.path = mPath;
    scene.format = QStringLiteral("obj");
    addNotes(scene);
    const auto &vts = mSource->cornerTextureVertex;
    if (std::any_of(vts.begin(), vts.end(), [](int vt) { return vt >= 0; }))
        scene.uvSets.push_back({QStringLiteral("UVMap"), mSource->originalUv()});
    scene.objectNames = mObjects.take();
    scene.materialNames = mMaterials.take();
    scene.faceMaterial = std::move(mFaceMaterial);
    scene.cornerColors = sharedColors(cornerColors(), mCornerVertex.size());
    mVertexColors = {};
    PositionMatrix positions = Eigen::Map<const PositionMatrix>(
        mPositions.data(), static_cast<Eigen::Index>(mPositions.size() / 3), 3);
    mPositions = {};
    scene.mesh = MeshData::build(std::move(positions), std::move(mFaceStart), std::move(mCornerVertex),
                                 std::move(mFaceObject));
    if (mSaysShading)
        scene.hardEdges = hardEdges(*scene.mesh, mSource->shading());
    mSource->contents.comments = true;
    scene.source = mSource;
    return scene;
}

Result<Scene> ObjParser::parse(const std::atomic<bool> *stop)
{
    const std::string_view bytes(mSource->bytes.constData(), static_cast<std::size_t>(mSource->bytes.size()));
    if (bytes.empty())
        return Error{QStringLiteral("the file is empty"), mPath, 0, exportAgain()};
    if (const std::size_t zero = bytes.find('\0'); zero != std::string_view::npos) {
        const auto line =
            std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(zero), '\n') + 1;
        return Error{QStringLiteral("the file holds binary data and is not a text OBJ file"), mPath,
                     static_cast<int>(line), exportAgain()};
    }
    ObjScanner scanner(bytes);
    while (scanner.next()) {
        if (stop && *stop)
            return readingCancelled(mPath);
        if (!readLine(scanner))
            return *mError;
    }
    if (!checkCompleteness())
        return *mError;
    return makeScene();
}

} // namespace

Result<Scene> parseObj(QByteArray bytes, const QString &path, const std::atomic<bool> *stop)
{
    return ObjParser(std::move(bytes), path).parse(stop);
}

Result<Scene> readObj(const QString &path, const std::atomic<bool> *stop)
{
    Result<QByteArray> bytes = loadFile(path, maxMeshFileSize);
    if (!bytes)
        return bytes.error();
    const QByteArray content = bytes.value();
    Result<Scene> scene = parseObj(std::move(bytes).value(), path, stop);
    if (scene)
        readMaterials(content, path, scene.value());
    return scene;
}

} // namespace autocuts
