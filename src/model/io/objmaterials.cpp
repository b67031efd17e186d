#include "model/io/objmaterials.h"

#include "model/document/materialcolor.h"
#include "model/io/savefile.h"

#include <QDir>
#include <QFileInfo>

#include <map>
#include <optional>

namespace autocuts {

namespace {

//! Chosen by hand, far above what is usual.
constexpr qint64 maxMaterialFile = 16 << 20;
constexpr qsizetype maxMaterialFiles = 16;

//! The rest of a line after its keyword; nothing when the line has another keyword.
std::optional<QByteArrayView> restAfter(QByteArrayView line, QByteArrayView keyword)
{
    line = line.trimmed();
    if (!line.startsWith(keyword) || line.size() <= keyword.size())
        return std::nullopt;
    const char next = line[keyword.size()];
    if (next != ' ' && next != '\t')
        return std::nullopt;
    return line.sliced(keyword.size()).trimmed();
}

template <typename Visit>
void visitLines(QByteArrayView bytes, Visit visit)
{
    while (!bytes.isEmpty()) {
        const qsizetype end = bytes.indexOf('\n');
        visit(end < 0 ? bytes : bytes.first(end));
        bytes = end < 0 ? QByteArrayView() : bytes.sliced(end + 1);
    }
}

QRgb diffuseColor(QByteArrayView numbers)
{
    const QList<QByteArray> parts = numbers.toByteArray().simplified().split(' ');
    bool valid[3] = {};
    if (parts.size() != 3)
        return 0;
    const QRgb color = materialColor(parts[0].toDouble(&valid[0]), parts[1].toDouble(&valid[1]),
                                     parts[2].toDouble(&valid[2]));
    return valid[0] && valid[1] && valid[2] ? color : 0;
}

void readColors(QByteArrayView bytes, std::map<QString, QRgb> &colors)
{
    QString name;
    visitLines(bytes, [&](QByteArrayView line) {
        if (const auto called = restAfter(line, "newmtl"))
            name = QString::fromUtf8(*called);
        else if (const auto numbers = restAfter(line, "Kd"))
            colors.try_emplace(name, diffuseColor(*numbers));
    });
}

} // namespace

void readMaterialColors(QByteArrayView bytes, const QString &path, Scene &scene)
{
    if (scene.materialNames.empty())
        return;
    QStringList files;
    visitLines(bytes, [&](QByteArrayView line) {
        if (const auto file = restAfter(line, "mtllib"); file && files.size() < maxMaterialFiles)
            files << QString::fromUtf8(*file);
    });
    std::map<QString, QRgb> colors;
    for (const QString &file : files) {
        // Only the name counts: a model must not make us read files elsewhere.
        const QString name = QFileInfo(QString(file).replace(u'\\', u'/')).fileName();
        if (const auto content = loadFile(QFileInfo(path).dir().filePath(name), maxMaterialFile))
            readColors(content.value(), colors);
    }
    for (const QString &name : scene.materialNames) {
        const auto found = colors.find(name);
        scene.materialColors.push_back(found == colors.end() ? 0 : found->second);
    }
}

} // namespace autocuts
