// The preferences dialog.
#pragma once

#include "views/ui/preferences.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QSpinBox;
class QStackedWidget;

namespace autocuts {

class ActionRegistry;
class ColorButton;
class ShortcutsPage;

//! Shows the preferences on pages. Changes take effect at once, so that the window behind shows them; Cancel
//! restores the previous values.
class PreferencesDialog final : public QDialog
{
    Q_OBJECT

public:
    enum class Page { General, Appearance, Shortcuts };

    PreferencesDialog(Preferences &preferences, ActionRegistry &actions, QWidget *parent = nullptr);

    void showPage(Page page);
    ShortcutsPage &shortcutsPage() { return *mShortcutsPage; }
    void reject() override;

private:
    QWidget *generalPage();
    QWidget *appearancePage();
    void addPage(const QString &title, const QString &iconName, QWidget *page);
    void connectAll();
    void showValues(const PreferenceValues &values);
    PreferenceValues shown() const;
    void store();
    void restoreDefaults();

    Preferences &mPreferences;
    const PreferenceValues mOriginal;
    const QMap<QString, QKeySequence> mOriginalShortcuts;
    bool mShowing = false; //!< the widgets are being filled
    QListWidget *mPages;
    QStackedWidget *mStack;
    QComboBox *mNavigation, *mTheme, *mLanguage;
    QSpinBox *mInterface, *mTextureSize, *mMargin, *mAutosave, *mUndoMemory;
    QDoubleSpinBox *mMaxDistortion;
    QCheckBox *mSolveOnOpen, *mShowTextures, *mLetProgramsIn, *mColorBlind;
    ColorButton *mSeam, *mSelection, *mForcedCut, *mJoined;
    ShortcutsPage *mShortcutsPage;
};

} // namespace autocuts
