// What a user chooses once for all sessions, kept between runs of the program.
#pragma once

#include <QByteArray>
#include <QColor>
#include <QKeySequence>
#include <QMap>
#include <QObject>
#include <QSettings>
#include <QStringList>

namespace autocuts {

enum class NavigationPreset { Blender, Maya };
enum class Theme { Dark, Light };

//! The values that the preferences dialog edits.
struct PreferenceValues
{
    NavigationPreset navigation = NavigationPreset::Blender;
    Theme theme = Theme::Dark;
    bool colorBlindHeatMap = false; //!< heat-maps in colours that all can tell apart
    QColor seamColor = QColor(0xDB2512);
    QColor selectionColor = QColor(0xFF9A1F);
    QColor forcedCutColor = QColor(0x2F7BFF); //!< cuts that the user asked for
    QColor joinedColor = QColor(0x37B24D);    //!< edges that the user joined
    int textureSize = 2048;                   //!< of new sessions, texels
    int margin = 8;                           //!< of new sessions, texels
    double maxDistortion = 4.1;               //!< distortion budget offered first
    int autosaveMinutes = 2;                  //!< 0: no autosave
    int undoMemoryMb = 400;
    bool solveOnOpen = false; //!< start solving as soon as a model without UVs was opened

    bool operator==(const PreferenceValues &) const = default;
};

//! Ranges of the numbers above.
struct PreferenceLimits
{
    static constexpr int minTextureSize = 16;
    static constexpr int maxMargin = 1024;
    static constexpr double minDistortion = 4.001, maxDistortion = 100;
    static constexpr int maxAutosaveMinutes = 120;
    static constexpr int minUndoMemoryMb = 10, maxUndoMemoryMb = 100000;
};

//! Preferences, recent files, shortcuts and the window's layout, in one INI file. Everything that is changed
//! is written at once.
class Preferences final : public QObject
{
    Q_OBJECT

public:
    static constexpr int maxRecentFiles = 12;

    //! \param file INI file, made when it is not there
    explicit Preferences(const QString &file, QObject *parent = nullptr);

    const PreferenceValues &values() const { return mValues; }
    void setValues(const PreferenceValues &values);

    //! The newest first; files that are gone stay listed.
    QStringList recentFiles() const;
    void addRecentFile(const QString &path);
    void clearRecentFiles();

    //! Keys that differ from the default, by action id; an empty sequence means none.
    QMap<QString, QKeySequence> shortcuts() const;
    void setShortcuts(const QMap<QString, QKeySequence> &shortcuts);

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindowLayout(const QByteArray &geometry, const QByteArray &state);

    //! Folder for the file dialogs: the one last used.
    QString lastFolder() const;
    void setLastFolder(const QString &folder);

Q_SIGNALS:
    void changed();
    void recentFilesChanged();
    void shortcutsChanged();

private:
    void load();

    QSettings mSettings;
    PreferenceValues mValues;
};

} // namespace autocuts
