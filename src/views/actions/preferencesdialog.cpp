#include "views/actions/preferencesdialog.h"

#include "model/plain/packingsettings.h"
#include "views/actions/shortcutspage.h"
#include "views/ui/colorbutton.h"
#include "views/ui/dialogsize.h"
#include "views/ui/icons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace autocuts {

namespace {

QSpinBox *spinBox(int lowest, int highest, const QString &suffix, int step = 1)
{
    auto *box = new QSpinBox;
    box->setRange(lowest, highest);
    box->setSuffix(suffix);
    box->setSingleStep(step);
    return box;
}

//! Adds a titled group with a form.
QFormLayout *addGroup(QVBoxLayout *page, const QString &title)
{
    auto *group = new QGroupBox(title);
    auto *form = new QFormLayout(group);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    form->setHorizontalSpacing(12);
    page->addWidget(group);
    return form;
}

QLabel *hint(const QString &text)
{
    auto *label = new QLabel(text);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

//! Copies the values of the Appearance page.
void copyAppearance(const PreferenceValues &from, PreferenceValues &to)
{
    to.theme = from.theme;
    to.language = from.language;
    to.interfacePercent = from.interfacePercent;
    to.colorBlindHeatMap = from.colorBlindHeatMap;
    to.seamColor = from.seamColor;
    to.selectionColor = from.selectionColor;
    to.forcedCutColor = from.forcedCutColor;
    to.joinedColor = from.joinedColor;
}

} // namespace

PreferencesDialog::PreferencesDialog(Preferences &preferences, ActionRegistry &actions, QWidget *parent)
    : QDialog(parent), mPreferences(preferences), mOriginal(preferences.values()),
      mOriginalShortcuts(preferences.shortcuts()), mPages(new QListWidget), mStack(new QStackedWidget)
{
    setWindowTitle(tr("Preferences"));
    mPages->setIconSize({24, 24});
    mPages->setFixedWidth(170);
    mPages->setSpacing(2);
    addPage(tr("General"), QStringLiteral("preferences"), generalPage());
    addPage(tr("Appearance"), QStringLiteral("shading"), appearancePage());
    mShortcutsPage = new ShortcutsPage(preferences, actions);
    addPage(tr("Shortcuts"), QStringLiteral("shortcuts"), mShortcutsPage);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel |
                                         QDialogButtonBox::RestoreDefaults);
    connect(buttons, &QDialogButtonBox::accepted, this, &PreferencesDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &PreferencesDialog::reject);
    QPushButton *const defaults = buttons->button(QDialogButtonBox::RestoreDefaults);
    defaults->setText(tr("Restore &defaults"));
    connect(defaults, &QPushButton::clicked, this, &PreferencesDialog::restoreDefaults);
    auto *row = new QHBoxLayout;
    row->addWidget(mPages);
    row->addWidget(mStack, 1);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(row, 1);
    layout->addWidget(buttons);
    connect(mPages, &QListWidget::currentRowChanged, mStack, &QStackedWidget::setCurrentIndex);
    showValues(mOriginal);
    connectAll();
    showPage(Page::General);
    resizeOnScreen(*this, {800, 600});
}

void PreferencesDialog::addPage(const QString &title, const QString &iconName, QWidget *page)
{
    new QListWidgetItem(icon(iconName), title, mPages);
    mStack->addWidget(page);
}

QWidget *PreferencesDialog::generalPage()
{
    mNavigation = new QComboBox;
    mNavigation->addItem(tr("Blender"), int(NavigationPreset::Blender));
    mNavigation->addItem(tr("Maya"), int(NavigationPreset::Maya));
    mTextureSize = spinBox(PreferenceLimits::minTextureSize, PackingSettings::maxTextureSize, tr(" px"), 256);
    mMargin = spinBox(0, PreferenceLimits::maxMargin, tr(" px"));
    mMaxDistortion = new QDoubleSpinBox;
    mMaxDistortion->setDecimals(3);
    mMaxDistortion->setRange(PreferenceLimits::minDistortion, PreferenceLimits::maxDistortion);
    mMaxDistortion->setSingleStep(0.05);
    mSolveOnOpen = new QCheckBox(tr("Start &solving when a model without UVs is opened"));
    mShowTextures = new QCheckBox(tr("Show the te&xtures of a model when it is opened"));
    mLetProgramsIn = new QCheckBox(tr("&Let other programs of mine link to this one"));
    mLetProgramsIn->setToolTip(
        tr("Such as Blender, by Open in Autocuts; nothing is reached from other computers"));
    mAutosave = spinBox(0, PreferenceLimits::maxAutosaveSeconds, tr(" s"));
    mAutosave->setSpecialValueText(tr("Never"));
    mUndoMemory =
        spinBox(PreferenceLimits::minUndoMemoryMb, PreferenceLimits::maxUndoMemoryMb, tr(" MB"), 100);
    auto *page = new QWidget;
    auto *layout = new QVBoxLayout(page);
    QFormLayout *form = addGroup(layout, tr("Mouse"));
    form->addRow(tr("&Navigation:"), mNavigation);
    form->addRow(hint(tr("Blender: middle button turns, with Shift moves, the wheel zooms. "
                         "Maya: Alt with the left button turns, middle moves, right zooms.")));
    form = addGroup(layout, tr("New sessions"));
    form->addRow(tr("&Texture size:"), mTextureSize);
    form->addRow(tr("&Margin between islands:"), mMargin);
    form->addRow(tr("&Distortion budget:"), mMaxDistortion);
    form->addRow(hint(tr("4 is a map without any distortion; 4.1 is hardly seen.")));
    form->addRow(mSolveOnOpen);
    form->addRow(mShowTextures);
    form->addRow(mLetProgramsIn);
    form = addGroup(layout, tr("Safety"));
    form->addRow(tr("&Autosave at the latest after:"), mAutosave);
    form->addRow(tr("Memory for &undo:"), mUndoMemory);
    layout->addStretch(1);
    return page;
}

QWidget *PreferencesDialog::appearancePage()
{
    mTheme = new QComboBox;
    mTheme->addItem(tr("Dark"), int(Theme::Dark));
    mTheme->addItem(tr("Light"), int(Theme::Light));
    mLanguage = new QComboBox;
    mLanguage->addItem(tr("As the system"), int(Language::System));
    // In their own languages, for those who cannot read the present one.
    mLanguage->addItem(QStringLiteral("English"), int(Language::English));
    mLanguage->addItem(QStringLiteral("Deutsch"), int(Language::German));
    mInterface =
        spinBox(PreferenceLimits::minInterfacePercent, PreferenceLimits::maxInterfacePercent, tr(" %"), 25);
    mColorBlind = new QCheckBox(tr("Heat-maps in colours that &all can tell apart"));
    mSeam = new ColorButton(tr("Colour of seams"));
    mSelection = new ColorButton(tr("Colour of the selection"));
    mForcedCut = new ColorButton(tr("Colour of forced cuts"));
    mJoined = new ColorButton(tr("Colour of joined edges"));
    auto *page = new QWidget;
    auto *layout = new QVBoxLayout(page);
    QFormLayout *form = addGroup(layout, tr("Window"));
    form->addRow(tr("&Theme:"), mTheme);
    form->addRow(tr("S&ize:"), mInterface);
    form->addRow(tr("&Language:"), mLanguage);
    form->addRow(hint(tr("Size, of texts and controls, and language take effect at the next start.")));
    form = addGroup(layout, tr("Colours of the views"));
    form->addRow(tr("&Seams:"), mSeam);
    form->addRow(tr("S&election:"), mSelection);
    form->addRow(tr("Forced &cuts:"), mForcedCut);
    form->addRow(tr("&Joined edges:"), mJoined);
    form->addRow(mColorBlind);
    layout->addStretch(1);
    return page;
}

void PreferencesDialog::connectAll()
{
    const auto changed = [this] { store(); };
    for (QComboBox *box : {mNavigation, mTheme, mLanguage})
        connect(box, &QComboBox::currentIndexChanged, this, changed);
    for (QSpinBox *box : {mInterface, mTextureSize, mMargin, mAutosave, mUndoMemory})
        connect(box, &QSpinBox::valueChanged, this, changed);
    connect(mMaxDistortion, &QDoubleSpinBox::valueChanged, this, changed);
    for (QCheckBox *box : {mSolveOnOpen, mShowTextures, mLetProgramsIn, mColorBlind})
        connect(box, &QCheckBox::toggled, this, changed);
    for (ColorButton *button : {mSeam, mSelection, mForcedCut, mJoined})
        connect(button, &ColorButton::colorChanged, this, changed);
}

void PreferencesDialog::showPage(Page page)
{
    mPages->setCurrentRow(int(page));
}

void PreferencesDialog::showValues(const PreferenceValues &values)
{
    mShowing = true;
    mNavigation->setCurrentIndex(mNavigation->findData(int(values.navigation)));
    mTheme->setCurrentIndex(mTheme->findData(int(values.theme)));
    mLanguage->setCurrentIndex(mLanguage->findData(int(values.language)));
    mTextureSize->setValue(values.textureSize);
    mMargin->setValue(values.margin);
    mMaxDistortion->setValue(values.maxDistortion);
    mSolveOnOpen->setChecked(values.solveOnOpen);
    mShowTextures->setChecked(values.showTextures);
    mLetProgramsIn->setChecked(values.letProgramsIn);
    mAutosave->setValue(values.autosaveSeconds);
    mUndoMemory->setValue(values.undoMemoryMb);
    mInterface->setValue(values.interfacePercent);
    mColorBlind->setChecked(values.colorBlindHeatMap);
    mSeam->setColor(values.seamColor);
    mSelection->setColor(values.selectionColor);
    mForcedCut->setColor(values.forcedCutColor);
    mJoined->setColor(values.joinedColor);
    mShowing = false;
}

PreferenceValues PreferencesDialog::shown() const
{
    PreferenceValues values;
    values.navigation = NavigationPreset(mNavigation->currentData().toInt());
    values.theme = Theme(mTheme->currentData().toInt());
    values.language = Language(mLanguage->currentData().toInt());
    values.textureSize = mTextureSize->value();
    values.margin = std::min(mMargin->value(), values.textureSize);
    values.maxDistortion = mMaxDistortion->value();
    values.solveOnOpen = mSolveOnOpen->isChecked();
    values.showTextures = mShowTextures->isChecked();
    values.letProgramsIn = mLetProgramsIn->isChecked();
    values.autosaveSeconds = mAutosave->value();
    values.undoMemoryMb = mUndoMemory->value();
    values.colorBlindHeatMap = mColorBlind->isChecked();
    values.interfacePercent = mInterface->value();
    values.seamColor = mSeam->color();
    values.selectionColor = mSelection->color();
    values.forcedCutColor = mForcedCut->color();
    values.joinedColor = mJoined->color();
    return values;
}

void PreferencesDialog::store()
{
    if (!mShowing)
        mPreferences.setValues(shown());
}

//! Restores the defaults of the visible page; the shortcuts page has its own button.
void PreferencesDialog::restoreDefaults()
{
    if (mStack->currentWidget() == mShortcutsPage) {
        mShortcutsPage->resetAll();
        return;
    }
    PreferenceValues values = shown(), defaults;
    const bool appearance = mStack->currentIndex() == int(Page::Appearance);
    PreferenceValues &kept = appearance ? values : defaults;
    copyAppearance(appearance ? defaults : values, kept);
    showValues(kept);
    store();
}

void PreferencesDialog::reject()
{
    mPreferences.setValues(mOriginal);
    mPreferences.setShortcuts(mOriginalShortcuts);
    QDialog::reject();
}

} // namespace autocuts
