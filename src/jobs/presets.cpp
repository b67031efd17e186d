#include "jobs/presets.h"

#include "jobs/jobtexts.h"
#include "jobs/nearestname.h"
#include "model/io/files/savefile.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QStandardPaths>

//! Resources of a static library have to be asked for; outside of any namespace.
static void takeResources()
{
    Q_INIT_RESOURCE(presets);
}

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

const QString suffix = u".preset"_s;
constexpr qint64 largestPreset = 1 << 20; // bytes; far more than any has

//! The file of a preset; empty when there is none of the name.
QString pathOf(const QString &preset)
{
    if (preset.contains(u'/') || preset.endsWith(suffix))
        return preset;
    for (const QString &folder : {presetFolder(), u":/presets"_s}) {
        const QString path = QDir(folder).filePath(preset + suffix);
        if (QFile::exists(path))
            return path;
    }
    return {};
}

QStringList namesIn(const QString &folder)
{
    takeResources();
    QStringList names;
    for (const QString &file : QDir(folder).entryList({u"*.preset"_s}, QDir::Files, QDir::Name))
        names << file.chopped(suffix.size());
    return names;
}

QString ownPath(const QString &name)
{
    return QDir(presetFolder()).filePath(name + suffix);
}

} // namespace

QString presetFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation))
        .filePath(u"autocuts/presets"_s);
}

QStringList presetNames()
{
    QStringList names = namesIn(u":/presets"_s) + ownPresetNames();
    names.removeDuplicates();
    return names;
}

QStringList ownPresetNames()
{
    return namesIn(presetFolder());
}

Result<Preset> readPreset(const QString &preset)
{
    takeResources();
    const QString path = pathOf(preset);
    if (path.isEmpty())
        return Error{JobTexts::tr("there is no preset \"%1\"").arg(preset) +
                         didYouMean(preset, presetNames()),
                     {},
                     0,
                     JobTexts::tr("There are %1, and files: NAME.preset in %2")
                         .arg(presetNames().join(u", "_s), presetFolder())};
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{file.errorString(), path, 0, JobTexts::tr("Check the path and its permissions")};
    if (file.size() > largestPreset)
        return Error{JobTexts::tr("the file is too large for a preset"), path, 0,
                     JobTexts::tr("Name a file with one option per line")};
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

Result<Done> savePreset(const QString &name, const QString &text)
{
    static const QRegularExpression notInNames(u"[/\\\\:\n]"_s);
    if (name.isEmpty() || name.startsWith(u'.') || name.endsWith(suffix) || name.contains(notInNames))
        return Error{JobTexts::tr("\"%1\" cannot be the name of a file").arg(name),
                     {},
                     0,
                     JobTexts::tr("Choose another name")};
    if (namesIn(u":/presets"_s).contains(name))
        return Error{JobTexts::tr("the preset %1 comes with the program").arg(name),
                     {},
                     0,
                     JobTexts::tr("Choose another name")};
    if (!QDir().mkpath(presetFolder()))
        return Error{JobTexts::tr("the folder cannot be made"), presetFolder(), 0,
                     JobTexts::tr("Check the permissions")};
    return saveAtomically(ownPath(name), text.toUtf8());
}

Result<Done> removePreset(const QString &name)
{
    QFile file(ownPath(name));
    if (file.remove())
        return Done{};
    return Error{file.errorString(), file.fileName(), 0, JobTexts::tr("Check the permissions of its folder")};
}

} // namespace autocuts
