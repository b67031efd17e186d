// Preferences in an INI file with one group each for values, recent files, shortcuts and the window.
#include "views/ui/preferences.h"

#include "model/plain/packingsettings.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

// Keys in the file; never change them.
const QString navigationKey = QStringLiteral("values/navigation");
const QString themeKey = QStringLiteral("values/theme");
const QString colorBlindKey = QStringLiteral("values/colorBlindHeatMap");
const QString languageKey = QStringLiteral("values/language");
const QString interfaceKey = QStringLiteral("values/interfacePercent");
const QString seamColorKey = QStringLiteral("values/seamColor");
const QString selectionColorKey = QStringLiteral("values/selectionColor");
const QString forcedCutColorKey = QStringLiteral("values/forcedCutColor");
const QString joinedColorKey = QStringLiteral("values/joinedColor");
const QString textureSizeKey = QStringLiteral("values/textureSize");
const QString marginKey = QStringLiteral("values/margin");
const QString maxDistortionKey = QStringLiteral("values/maxDistortion");
const QString autosaveKey = QStringLiteral("values/autosaveSeconds");
const QString undoMemoryKey = QStringLiteral("values/undoMemoryMb");
const QString solveOnOpenKey = QStringLiteral("values/solveOnOpen");
const QString showTexturesKey = QStringLiteral("values/showTextures");
const QString letProgramsInKey = QStringLiteral("values/letProgramsIn");
const QString recentKey = QStringLiteral("files/recent");
const QString folderKey = QStringLiteral("files/folder");
const QString shortcutGroup = QStringLiteral("shortcuts");
const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");

QColor readColor(const QSettings &settings, const QString &key, const QColor &fallback)
{
    const QColor color(settings.value(key).toString());
    return color.isValid() ? color : fallback;
}

int readInt(const QSettings &settings, const QString &key, int fallback, int lowest, int highest)
{
    bool ok = false;
    const int value = settings.value(key).toInt(&ok);
    return ok && value >= lowest && value <= highest ? value : fallback;
}

double readDouble(const QSettings &settings, const QString &key, double fallback, double lowest,
                  double highest)
{
    bool ok = false;
    const double value = settings.value(key).toDouble(&ok);
    return ok && value >= lowest && value <= highest ? value : fallback;
}

int readInterfacePercent(const QSettings &settings)
{
    return readInt(settings, interfaceKey, PreferenceValues().interfacePercent,
                   PreferenceLimits::minInterfacePercent, PreferenceLimits::maxInterfacePercent);
}

//! How the languages are called in the file.
QString nameOf(Language language)
{
    switch (language) {
    case Language::English:
        return QStringLiteral("en");
    case Language::German:
        return QStringLiteral("de");
    case Language::System:
        break;
    }
    return QStringLiteral("system");
}

Language readLanguage(const QSettings &settings)
{
    const QString name = settings.value(languageKey).toString();
    for (const Language language : {Language::English, Language::German}) {
        if (name == nameOf(language))
            return language;
    }
    return Language::System;
}

//! Values are checked, because users or other versions may have written the file.
PreferenceValues readValues(const QSettings &settings)
{
    using Limits = PreferenceLimits;
    PreferenceValues v;
    if (settings.value(navigationKey).toString() == QStringLiteral("maya"))
        v.navigation = NavigationPreset::Maya;
    if (settings.value(themeKey).toString() == QStringLiteral("light"))
        v.theme = Theme::Light;
    v.colorBlindHeatMap = settings.value(colorBlindKey, v.colorBlindHeatMap).toBool();
    v.language = readLanguage(settings);
    v.interfacePercent = readInterfacePercent(settings);
    v.seamColor = readColor(settings, seamColorKey, v.seamColor);
    v.selectionColor = readColor(settings, selectionColorKey, v.selectionColor);
    v.forcedCutColor = readColor(settings, forcedCutColorKey, v.forcedCutColor);
    v.joinedColor = readColor(settings, joinedColorKey, v.joinedColor);
    v.textureSize = readInt(settings, textureSizeKey, v.textureSize, Limits::minTextureSize,
                            PackingSettings::maxTextureSize);
    v.margin = std::min(readInt(settings, marginKey, v.margin, 0, Limits::maxMargin), v.textureSize);
    v.maxDistortion =
        readDouble(settings, maxDistortionKey, v.maxDistortion, Limits::minDistortion, Limits::maxDistortion);
    v.autosaveSeconds = readInt(settings, autosaveKey, v.autosaveSeconds, 0, Limits::maxAutosaveSeconds);
    v.undoMemoryMb =
        readInt(settings, undoMemoryKey, v.undoMemoryMb, Limits::minUndoMemoryMb, Limits::maxUndoMemoryMb);
    v.solveOnOpen = settings.value(solveOnOpenKey, v.solveOnOpen).toBool();
    v.showTextures = settings.value(showTexturesKey, v.showTextures).toBool();
    v.letProgramsIn = settings.value(letProgramsInKey, v.letProgramsIn).toBool();
    return v;
}

void writeValues(QSettings &settings, const PreferenceValues &v)
{
    settings.setValue(navigationKey, v.navigation == NavigationPreset::Maya ? QStringLiteral("maya")
                                                                            : QStringLiteral("blender"));
    settings.setValue(themeKey, v.theme == Theme::Light ? QStringLiteral("light") : QStringLiteral("dark"));
    settings.setValue(colorBlindKey, v.colorBlindHeatMap);
    settings.setValue(languageKey, nameOf(v.language));
    settings.setValue(interfaceKey, v.interfacePercent);
    settings.setValue(seamColorKey, v.seamColor.name());
    settings.setValue(selectionColorKey, v.selectionColor.name());
    settings.setValue(forcedCutColorKey, v.forcedCutColor.name());
    settings.setValue(joinedColorKey, v.joinedColor.name());
    settings.setValue(textureSizeKey, v.textureSize);
    settings.setValue(marginKey, v.margin);
    settings.setValue(maxDistortionKey, v.maxDistortion);
    settings.setValue(autosaveKey, v.autosaveSeconds);
    settings.setValue(undoMemoryKey, v.undoMemoryMb);
    settings.setValue(solveOnOpenKey, v.solveOnOpen);
    settings.setValue(showTexturesKey, v.showTextures);
    settings.setValue(letProgramsInKey, v.letProgramsIn);
}

} // namespace

int Preferences::interfacePercent(const QString &file)
{
    return readInterfacePercent(QSettings(file, QSettings::IniFormat));
}

Language Preferences::language(const QString &file)
{
    return readLanguage(QSettings(file, QSettings::IniFormat));
}

Preferences::Preferences(const QString &file, QObject *parent)
    : QObject(parent), mSettings(file, QSettings::IniFormat)
{
    load();
}

void Preferences::load()
{
    mValues = readValues(mSettings);
}

void Preferences::setValues(const PreferenceValues &values)
{
    if (values == mValues)
        return;
    mValues = values;
    writeValues(mSettings, mValues);
    mSettings.sync();
    Q_EMIT changed();
}

QStringList Preferences::recentFiles() const
{
    return mSettings.value(recentKey).toStringList().mid(0, maxRecentFiles);
}

void Preferences::addRecentFile(const QString &path)
{
    const QString absolute = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    QStringList files = recentFiles();
    if (!files.isEmpty() && files.first() == absolute)
        return;
    files.removeAll(absolute);
    files.prepend(absolute);
    mSettings.setValue(recentKey, files.mid(0, maxRecentFiles));
    mSettings.sync();
    Q_EMIT recentFilesChanged();
}

void Preferences::clearRecentFiles()
{
    if (recentFiles().isEmpty())
        return;
    mSettings.remove(recentKey);
    mSettings.sync();
    Q_EMIT recentFilesChanged();
}

QMap<QString, QKeySequence> Preferences::shortcuts() const
{
    QMap<QString, QKeySequence> result;
    const QString prefix = shortcutGroup + QLatin1Char('/');
    for (const QString &key : mSettings.allKeys()) {
        if (key.startsWith(prefix))
            result.insert(key.mid(prefix.size()),
                          QKeySequence(mSettings.value(key).toString(), QKeySequence::PortableText));
    }
    return result;
}

void Preferences::setShortcuts(const QMap<QString, QKeySequence> &newShortcuts)
{
    if (newShortcuts == shortcuts())
        return;
    mSettings.remove(shortcutGroup);
    for (auto it = newShortcuts.begin(); it != newShortcuts.end(); ++it)
        mSettings.setValue(shortcutGroup + QLatin1Char('/') + it.key(),
                           it.value().toString(QKeySequence::PortableText));
    mSettings.sync();
    Q_EMIT shortcutsChanged();
}

QByteArray Preferences::windowGeometry() const
{
    return mSettings.value(geometryKey).toByteArray();
}

QByteArray Preferences::windowState() const
{
    return mSettings.value(stateKey).toByteArray();
}

void Preferences::setWindowLayout(const QByteArray &geometry, const QByteArray &state)
{
    mSettings.setValue(geometryKey, geometry);
    mSettings.setValue(stateKey, state);
    mSettings.sync();
}

QString Preferences::lastFolder() const
{
    const QString folder = mSettings.value(folderKey).toString();
    return !folder.isEmpty() && QFileInfo(folder).isDir() ? folder : QDir::homePath();
}

void Preferences::setLastFolder(const QString &folder)
{
    if (folder == mSettings.value(folderKey).toString())
        return;
    mSettings.setValue(folderKey, folder);
    mSettings.sync();
}

} // namespace autocuts
