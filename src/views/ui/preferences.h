// The user's preferences, kept between runs of the program.
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
enum class Language { System, English, German };

//! The values of the preferences dialog.
struct PreferenceValues
{
    NavigationPreset navigation = NavigationPreset::Blender;
    Theme theme = Theme::Dark;
    Language language = Language::System; //!< of all texts; takes effect at the next start
    int interfacePercent = 100;           //!< size of the interface; takes effect at the next start
    bool colorBlindHeatMap = false; //!< use colours in heat-maps that colour-blind people can distinguish
    QColor seamColor = QColor(0xDB2512);
    QColor selectionColor = QColor(0xFF9A1F);
    QColor forcedCutColor = QColor(0x2F7BFF); //!< edges that the user cut
    QColor joinedColor = QColor(0x37B24D);    //!< edges that the user joined
    int textureSize = 2048;                   //!< texels; for new sessions
    int margin = 8;                           //!< texels of gutter; for new sessions
    double maxDistortion = 4.1;               //!< initial distortion budget
    int autosaveSeconds = 20;                 //!< 0: no autosave
    int undoMemoryMb = 400;
    bool solveOnOpen = false;  //!< start solving when a model without UVs is opened
    bool showTextures = true;  //!< show the textures that a model names when it is opened
    bool letProgramsIn = true; //!< other programs of the user may link to the studio

    bool operator==(const PreferenceValues &) const = default;
};

//! Limits of the numbers above.
struct PreferenceLimits
{
    static constexpr int minInterfacePercent = 75, maxInterfacePercent = 300;
    static constexpr int minTextureSize = 16;
    static constexpr int maxMargin = 1024;
    static constexpr double minDistortion = 4.001, maxDistortion = 100;
    static constexpr int maxAutosaveSeconds = 3600;
    static constexpr int minUndoMemoryMb = 10, maxUndoMemoryMb = 100000;
};

//! Preferences, recent files, shortcuts and the window's layout, in one INI file. Every change is written at
//! once.
class Preferences final : public QObject
{
    Q_OBJECT

public:
    static constexpr int maxRecentFiles = 12;

    //! \param file INI file, created when it does not exist
    explicit Preferences(const QString &file, QObject *parent = nullptr);

    //! PreferenceValues::interfacePercent as in a file; may be called before there is an application.
    static int interfacePercent(const QString &file);
    //! PreferenceValues::language as in a file, to be known before anything is shown.
    static Language language(const QString &file);

    const PreferenceValues &values() const { return mValues; }
    void setValues(const PreferenceValues &values);

    //! The recent files, the newest first, including files that no longer exist.
    QStringList recentFiles() const;
    void addRecentFile(const QString &path);
    void clearRecentFiles();

    //! Shortcuts that differ from the default, by action id; an empty sequence means no shortcut.
    QMap<QString, QKeySequence> shortcuts() const;
    void setShortcuts(const QMap<QString, QKeySequence> &shortcuts);

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindowLayout(const QByteArray &geometry, const QByteArray &state);

    //! The folder for file dialogs: the one used last.
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
