#include "cli/presets.h"

#include "cli/nearestname.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

//! Resources of a static library have to be asked for; outside of any namespace.
static void takeResources()
{
    Q_INIT_RESOURCE(presets);
}

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 largestPreset = 1 << 20; // bytes; far more than any has

//! The file of a preset; empty when there is none of the name.
QString pathOf(const QString &preset)
{
    if (preset.contains(u'/') || preset.endsWith(u".preset"))
        return preset;
    for (const QString &folder : {presetFolder(), u":/presets"_s}) {
        const QString path = QDir(folder).filePath(preset + u".preset"_s);
        if (QFile::exists(path))
            return path;
    }
    return {};
}

} // namespace

QString presetFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation))
        .filePath(u"autocuts/presets"_s);
}

QStringList presetNames()
{
    takeResources();
    QStringList names;
    for (const QString &folder : {u":/presets"_s, presetFolder()}) {
        for (const QString &file : QDir(folder).entryList({u"*.preset"_s}, QDir::Files, QDir::Name))
            names << file.chopped(7);
    }
    names.removeDuplicates();
    return names;
}

Result<Preset> readPreset(const QString &preset)
{
    takeResources();
    const QString path = pathOf(preset);
    if (path.isEmpty())
        return Error{
            u"there is no preset \"%1\""_s.arg(preset) + didYouMean(preset, presetNames()),
            {},
            0,
            u"There are %1, and files: NAME.preset in %2"_s.arg(presetNames().join(u", "_s), presetFolder())};
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{file.errorString(), path, 0, u"Check the path and its permissions"_s};
    if (file.size() > largestPreset)
        return Error{u"the file is too large for a preset"_s, path, 0,
                     u"Name a file with one option per line"_s};
    Preset read{path, {}};
    const QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n');
    for (int i = 0; i < lines.size(); ++i) {
        const QString line = lines[i].trimmed();
        if (line.isEmpty() || line.startsWith(u'#'))
            continue;
        const QString name = line.section(u'=', 0, 0).trimmed();
        read.options.push_back({u"--"_s + name, line.section(u'=', 1).trimmed(), i + 1});
    }
    return read;
}

} // namespace autocuts
