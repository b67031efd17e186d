#include "model/io/gltf/gltfwriter.h"

#include "model/io/files/savefile.h"
#include "model/io/formats/freenames.h"
#include "model/io/gltf/gltfrewriter.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace autocuts {

namespace {

constexpr int contentDigits = 12; //!< of the hash in the name of a buffer file

QString nameOfUri(const std::string &uri)
{
    return QUrl::fromPercentEncoding(QByteArray::fromStdString(uri));
}

std::string uriOfName(const QString &name)
{
    return QUrl::toPercentEncoding(name, "/!$&'()*+,;=:@").toStdString();
}

//! True for a relative name, so not for URIs of the network.
bool isFileName(const QString &name)
{
    return !name.isEmpty() && QUrl(name).scheme().size() <= 1 && !QDir::isAbsolutePath(name);
}

//! Makes the file that is written, and the files of its buffers.
class GltfOutput
{
public:
    GltfOutput(const GltfSource &source, const QString &from, const QString &to)
        : mSource(source), mFile(source.file), mFrom(from), mTo(to),
          mSameFolder(QFileInfo(from).absolutePath() == QFileInfo(to).absolutePath())
    {}

    Result<Done> save(const Scene &scene);

private:
    void placeBuffersInGlb();
    void placeBuffersBeside();
    void placeOuterBuffer(std::size_t buffer);
    bool isChanged(std::size_t buffer) const
    {
        return buffer >= mBefore.buffers.size() || mBefore.buffers[buffer] != mDocument.buffers[buffer];
    }
    void moveImages();
    QString placeFor(const QByteArray &content) const;
    Result<Done> saveAll(const QByteArray &main);
    std::vector<QString> namedByTheOldFile() const;
    void removeUnused(const std::vector<QString> &names) const;

    const GltfSource &mSource;
    GltfFile mFile;
    QString mFrom, mTo;
    bool mSameFolder;
    GltfDocument mBefore, mDocument;
    bool mEdited = false; //!< the JSON is no more that of the source
    std::vector<std::pair<QString, QByteArray>> mBufferFiles;
};

void GltfOutput::placeBuffersInGlb()
{
    for (std::size_t b = 0; b < mDocument.buffers.size(); ++b) {
        Json &buffer = mDocument.json["buffers"][b];
        const std::string uri = textOf(buffer, "uri");
        const bool becomesChunk = b == 0 && !mFile.isBinary();
        if (uri.empty() || (isDataUri(uri) && !becomesChunk && !isChanged(b)))
            continue;
        buffer.erase("uri");
        mEdited = true;
    }
}

//! The name of a buffer file: made from that of the output, never from the input. It is that of a file with
//! this content, or of none yet, so that no file that is there changes: the old .gltf file stays readable
//! until the new one has replaced it.
QString GltfOutput::placeFor(const QByteArray &content) const
{
    std::set<QString> taken; // by buffers that stay where they are
    for (const Json &buffer : member(mDocument.json, "buffers"))
        taken.insert(nameOfUri(textOf(buffer, "uri")));
    for (const auto &[path, bytes] : mBufferFiles) {
        if (bytes == content)
            return QFileInfo(path).fileName();
    }
    const QDir folder = QFileInfo(mTo).dir();
    const auto fits = [&](const QString &name) {
        const QString path = folder.filePath(name);
        if (taken.contains(name))
            return false;
        const QFileInfo info(path);
        if (!info.exists() && !info.isSymLink())
            return true;
        if (info.size() != content.size())
            return false;
        const Result<QByteArray> there = loadFile(path, std::numeric_limits<qint64>::max());
        return there && there.value() == content;
    };
    const QString base = QFileInfo(mTo).completeBaseName();
    const QString hash = QString::fromLatin1(
        QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex().left(contentDigits));
    QString name = base + QStringLiteral(".bin");
    for (int i = 1; !fits(name); ++i)
        name = i == 1 ? QStringLiteral("%1-%2.bin").arg(base, hash)
                      : QStringLiteral("%1-%2-%3.bin").arg(base, hash).arg(i);
    return name;
}

void GltfOutput::placeOuterBuffer(std::size_t number)
{
    Json &buffer = mDocument.json["buffers"][number];
    const QByteArray &content = mDocument.buffers[number];
    const QString old = nameOfUri(textOf(buffer, "uri"));
    const QDir folder = QFileInfo(mTo).dir();
    if (mSameFolder && !isChanged(number) && isFileName(old)) {
        const Result<QByteArray> there = loadFile(folder.filePath(old), std::numeric_limits<qint64>::max());
        if (there && there->startsWith(content))
            return;
    }
    buffer.erase("uri");
    const QString name = placeFor(content);
    mEdited |= name != old;
    buffer["uri"] = uriOfName(name);
    mBufferFiles.emplace_back(folder.filePath(name), content);
}

void GltfOutput::placeBuffersBeside()
{
    for (std::size_t b = 0; b < mDocument.buffers.size(); ++b) {
        Json &buffer = mDocument.json["buffers"][b];
        const QByteArray &content = mDocument.buffers[b];
        const std::string uri = textOf(buffer, "uri");
        if (!uri.empty() && !isDataUri(uri)) {
            placeOuterBuffer(b);
        } else if (!content.isEmpty() && (uri.empty() || isChanged(b))) {
            buffer["uri"] = dataUri(content);
            mEdited = true;
        }
    }
}

//! Lets relative URIs lead to the same files from the folder of the output.
void GltfOutput::moveImages()
{
    if (mSameFolder || !mDocument.json.contains("images"))
        return;
    const QDir from = QFileInfo(mFrom).absoluteDir();
    const QDir to = QFileInfo(mTo).absoluteDir();
    for (Json &image : mDocument.json["images"]) {
        const QString name = nameOfUri(textOf(image, "uri"));
        if (isDataUri(textOf(image, "uri")) || !isFileName(name))
            continue;
        image["uri"] = uriOfName(to.relativeFilePath(from.absoluteFilePath(name)));
        mEdited = true;
    }
}

Result<Done> GltfOutput::save(const Scene &scene)
{
    std::optional<GltfDocument> changed = rewriteGltf(mSource, scene, mTo);
    mEdited = changed.has_value();
    mBefore = openGltf(mFile);
    mDocument = changed ? std::move(*changed) : mBefore;
    const bool binary = QFileInfo(mTo).suffix().toLower() == QLatin1String("glb");
    moveImages();
    if (binary)
        placeBuffersInGlb();
    else
        placeBuffersBeside();
    if (!mEdited && binary == mFile.isBinary())
        return saveAll(mFile.main);
    return saveAll(binary ? glbBytes(std::move(mDocument))
                          : jsonText(mDocument.json, mFile.isBinary() ? QByteArray() : mFile.main));
}

//! Writes the files of the buffers under new names, then the file that names them, and removes at last what
//! only the old one named. So what is under the output's name can be read at every moment.
Result<Done> GltfOutput::saveAll(const QByteArray &main)
{
    const std::vector<QString> old = namedByTheOldFile();
    FileSet files;
    for (const auto &[path, bytes] : mBufferFiles) {
        if (QFileInfo::exists(path))
            continue; // with this content
        if (Result<Done> added = files.add(path, bytes); !added)
            return added;
    }
    if (Result<Done> added = files.add(mTo, main); !added)
        return added;
    if (Result<Done> placed = files.putInPlace(); !placed)
        return placed;
    removeUnused(old);
    return Done{};
}

//! The buffer files of the file that is replaced, as far as their names carry a hash of their content: no
//! others can be told from files of the user, which other models may share.
std::vector<QString> GltfOutput::namedByTheOldFile() const
{
    std::vector<QString> names;
    const Result<QByteArray> old = loadFile(mTo, std::numeric_limits<qint64>::max());
    if (!old || old->startsWith("glTF"))
        return names;
    const QRegularExpression ours(QStringLiteral("^%1-[0-9a-f]{%2}(-[0-9]+)?\\.bin$")
                                      .arg(QRegularExpression::escape(QFileInfo(mTo).completeBaseName()))
                                      .arg(contentDigits));
    const Json json = Json::parse(old->begin(), old->end(), nullptr, false);
    for (const Json &buffer : member(json, "buffers")) {
        const QString name = nameOfUri(textOf(buffer, "uri"));
        if (ours.match(name).hasMatch())
            names.push_back(name);
    }
    return names;
}

//! Removes files of buffers that no .gltf file of the folder names any more.
void GltfOutput::removeUnused(const std::vector<QString> &names) const
{
    if (names.empty())
        return;
    const QDir folder = QFileInfo(mTo).dir();
    std::vector<QByteArray> texts;
    for (const QString &file : folder.entryList({QStringLiteral("*.gltf")}, QDir::Files | QDir::Hidden)) {
        Result<QByteArray> text = loadFile(folder.filePath(file), std::numeric_limits<qint64>::max());
        if (!text)
            return; // it may name them
        texts.push_back(std::move(text).value());
    }
    for (const QString &name : names) {
        const bool used = std::any_of(texts.begin(), texts.end(), [&](const QByteArray &text) {
            return text.contains(name.toUtf8()) || text.contains(QByteArray::fromStdString(uriOfName(name)));
        });
        if (!used)
            QFile::remove(folder.filePath(name));
    }
}

//! Gives nodes names of their own: Assimp finds what is animated by its name. False when they have them.
bool nameNodesApart(Json &root)
{
    if (!root.contains("nodes"))
        return false;
    FreeNames taken;
    std::vector<Json *> others;
    for (Json &node : root["nodes"]) {
        if (const std::string name = textOf(node, "name"); !name.empty() && !taken.take(name))
            others.push_back(&node);
    }
    for (Json *node : others)
        (*node)["name"] = taken.takeFree(textOf(*node, "name"));
    return !others.empty();
}

} // namespace

Result<Done> writeGltf(const Scene &scene, const QString &path)
{
    try {
        return GltfOutput(*sourceOf<GltfSource>(scene), scene.path, path).save(scene);
    } catch (const std::bad_alloc &) {
        throw;
    } catch (const std::exception &e) {
        return Error{
            QStringLiteral("the model cannot be written as glTF: %1").arg(QString::fromUtf8(e.what())), path,
            0, QStringLiteral("Save it in another format, for example as OBJ")};
    }
}

QByteArray sourceAsGlb(const GltfSource &source)
{
    GltfFile file = source.file;
    const bool isBinary = file.isBinary();
    GltfDocument document = openGltf(file);
    if (!nameNodesApart(document.json) && isBinary)
        return source.file.main;
    for (std::size_t b = 0; b < document.buffers.size(); ++b)
        document.json["buffers"][b].erase("uri");
    return glbBytes(std::move(document));
}

QStringList gltfLosses(const GltfSource &source, const Scene &scene)
{
    QStringList losses;
    if (source.contents.instances && !scene.uniqueMeshes)
        losses << QCoreApplication::translate(
            "ExportLosses", "meshes that several nodes share get the UVs of the first node, unless they "
                            "are made unique");
    if (source.tangents)
        losses << QCoreApplication::translate(
            "ExportLosses", "tangents of changed UVs are left out: programs compute them from the UVs");
    if (source.compressed)
        losses << QCoreApplication::translate("ExportLosses",
                                              "changed meshes are written without compression");
    const std::map<int, const UvSet *> written = texcoordsToWrite(source, scene);
    if (written.size() < scene.uvSets.size())
        losses << QCoreApplication::translate("ExportLosses", "UV sets after the eighth are lost");
    if (std::any_of(source.texcoords.begin(), source.texcoords.end(),
                    [&](int set) { return !written.contains(set); }))
        losses << QCoreApplication::translate(
            "ExportLosses",
            "UV sets that were removed stay in the file: its materials name UV sets by their numbers");
    losses << QCoreApplication::translate("ExportLosses", "changed UVs are rounded to single precision");
    return losses;
}

} // namespace autocuts
