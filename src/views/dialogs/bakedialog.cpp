#include "views/dialogs/bakedialog.h"

#include "model/document/document.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"
#include "views/ui/reasons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int nameRole = Qt::UserRole;

//! The formats and their bits.
constexpr std::pair<const char *, int> formats[]{{"png", 8}, {"png", 16}, {"tif", 16},
                                                 {"tga", 8}, {"exr", 16}, {"exr", 32}};

} // namespace

BakeDialog::BakeDialog(const Document &document, const BakeChoice &last, const QStringList &filters,
                       Questions &questions)
    : QDialog(questions.window()), mHasUv(document.uv().array().isFinite().any()),
      mTextureSize(document.packingSettings().textureSize), mQuestions(questions), mFilters(filters),
      mHigh(new QLineEdit), mFolder(new QLineEdit), mMaps(new QListWidget), mSamples(new QComboBox),
      mDirection(new QComboBox), mFormat(new QComboBox), mWidth(new QSpinBox), mRays(new QSpinBox),
      mDilation(new QSpinBox), mCage(new QDoubleSpinBox),
      mByName(new QCheckBox(tr("&Objects see those of the same name only"))),
      mGreenDown(new QCheckBox(tr("Green points &down (DirectX)"))), mProblem(new QLabel)
{
    setWindowTitle(tr("Bake"));
    auto *browseHigh = new QPushButton(tr("&Browse...")), *browseFolder = new QPushButton(tr("B&rowse..."));
    mHigh->setText(QDir::toNativeSeparators(last.high));
    mHigh->setPlaceholderText(tr("None: this model itself"));
    mHigh->setClearButtonEnabled(true);
    mHigh->setMinimumWidth(320);
    mFolder->setText(QDir::toNativeSeparators(last.folder));
    addMaps(last.maps);
    mWidth->setRange(PreferenceLimits::minTextureSize, PackingSettings::maxTextureSize);
    mWidth->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mWidth->setValue(last.width > 0 ? last.width : mTextureSize);
    mWidth->setSuffix(tr(" px"));
    mWidth->setToolTip(tr("Width of the pictures; at first that of the texture in the Packing panel, whose "
                          "proportions they have"));
    for (const int perSide : {1, 2, 4, 8})
        mSamples->addItem(QString::number(perSide * perSide), perSide);
    mSamples->setCurrentIndex(std::max(0, mSamples->findData(last.samplesPerSide)));
    mSamples->setToolTip(tr("Places in each texel that are baked and averaged"));
    mRays->setRange(1, 65536);
    mRays->setValue(last.rays);
    mRays->setToolTip(tr("For occlusion, bent normals, curvature and thickness, in each texel"));
    mCage->setRange(0.01, 100);
    mCage->setDecimals(2);
    mCage->setSuffix(tr(" %"));
    mCage->setValue(100 * last.cage);
    mCage->setToolTip(
        tr("How far the detailed model is looked for, outside and inside of the surface; 100 % is the "
           "diagonal of the model"));
    mDirection->addItem(tr("Smooth: no gaps at edges"), int(BakeChoice::Direction::Smoothed));
    mDirection->addItem(tr("Along the shading normals"), int(BakeChoice::Direction::Shading));
    mDirection->addItem(tr("Smooth at edges, straight elsewhere"), int(BakeChoice::Direction::Corrected));
    mDirection->setCurrentIndex(std::max(0, mDirection->findData(int(last.direction))));
    mDirection->setToolTip(tr("In which direction the detailed model is looked for"));
    mByName->setChecked(last.byName);
    mByName->setToolTip(tr("Endings such as _low and _high do not count"));
    mGreenDown->setChecked(last.greenDown);
    mDilation->setRange(0, 1024);
    mDilation->setValue(last.dilation);
    mDilation->setSuffix(tr(" px"));
    mDilation->setToolTip(tr("Texels around islands that are filled with the nearest value"));
    for (const auto &[suffix, bits] : formats) {
        mFormat->addItem(tr("%1, %2 bits").arg(QString::fromLatin1(suffix).toUpper()).arg(bits));
        if (last.suffix == QLatin1StringView(suffix) && last.bits == bits)
            mFormat->setCurrentIndex(mFormat->count() - 1);
    }
    mProblem->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mBake = buttons->addButton(tr("Ba&ke"), QDialogButtonBox::AcceptRole);
    mBake->setDefault(true);
    mLive = buttons->addButton(tr("Show li&ve"), QDialogButtonBox::ActionRole);
    mLive->setAutoDefault(false);
    mLive->setToolTip(
        tr("Show the first chosen map in both views, also while the UVs change; no files are written"));
    connect(mLive, &QPushButton::clicked, this, [this] { done(Live); });
    auto *form = new QFormLayout(this);
    form->addRow(tr("De&tailed model:"), pathRow(mHigh, browseHigh));
    form->addRow(tr("&Maps:"), mMaps);
    form->addRow(tr("Si&ze:"), mWidth);
    form->addRow(tr("Sam&ples per texel:"), mSamples);
    form->addRow(tr("Ra&ys per texel:"), mRays);
    form->addRow(tr("C&age:"), mCage);
    form->addRow(tr("D&irection:"), mDirection);
    form->addRow(QString(), mByName);
    form->addRow(QString(), mGreenDown);
    form->addRow(tr("Di&lation:"), mDilation);
    form->addRow(tr("&Format:"), mFormat);
    form->addRow(tr("Fold&er:"), pathRow(mFolder, browseFolder));
    form->addRow(QString(), mProblem);
    form->addRow(buttons);
    for (const auto &[widget, name] :
         std::initializer_list<std::pair<QWidget *, const char *>>{{mHigh, "high"},
                                                                   {browseHigh, "browseHigh"},
                                                                   {mMaps, "maps"},
                                                                   {mWidth, "width"},
                                                                   {mSamples, "samples"},
                                                                   {mRays, "rays"},
                                                                   {mCage, "cage"},
                                                                   {mDirection, "direction"},
                                                                   {mByName, "byName"},
                                                                   {mGreenDown, "greenDown"},
                                                                   {mDilation, "dilation"},
                                                                   {mFormat, "format"},
                                                                   {mFolder, "folder"},
                                                                   {browseFolder, "browseFolder"},
                                                                   {mProblem, "problem"},
                                                                   {mBake, "bake"},
                                                                   {mLive, "live"}})
        widget->setObjectName(QLatin1StringView(name));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(browseHigh, &QPushButton::clicked, this, &BakeDialog::browseDetailed);
    connect(browseFolder, &QPushButton::clicked, this, &BakeDialog::browseFolder);
    connect(mMaps, &QListWidget::itemChanged, this, &BakeDialog::showState);
    for (QLineEdit *edit : {mHigh, mFolder})
        connect(edit, &QLineEdit::textChanged, this, &BakeDialog::showState);
    showState();
}

QWidget *BakeDialog::pathRow(QLineEdit *edit, QPushButton *browse)
{
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(edit, 1);
    layout->addWidget(browse);
    browse->setAutoDefault(false);
    row->setFocusProxy(edit);
    return row;
}

void BakeDialog::addMaps(const QStringList &chosen)
{
    for (const QString &name : bakeMapNames()) {
        auto *item = new QListWidgetItem(bakeMapTitle(name), mMaps);
        item->setToolTip(bakeMapTip(name));
        item->setData(nameRole, name);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(chosen.contains(name) ? Qt::Checked : Qt::Unchecked);
    }
    const int height = mMaps->sizeHintForRow(0) * mMaps->count() + 2 * mMaps->frameWidth();
    mMaps->setFixedHeight(height);
}

void BakeDialog::browseDetailed()
{
    const QString path = mQuestions.fileToOpen(tr("Detailed model"), choice().high, mFilters);
    if (!path.isEmpty())
        mHigh->setText(QDir::toNativeSeparators(path));
}

void BakeDialog::browseFolder()
{
    const QString path = mQuestions.folderToOpen(tr("Folder for the pictures"), choice().folder);
    if (!path.isEmpty())
        mFolder->setText(QDir::toNativeSeparators(path));
}

void BakeDialog::showState()
{
    const bool detailed = !choice().high.isEmpty();
    for (QWidget *widget : std::initializer_list<QWidget *>{mCage, mDirection, mByName})
        enableOrSay(widget, detailed, tr("Choose a detailed model first"));
    const QString source = sourceProblem(), target = targetProblem();
    mProblem->setText(source.isEmpty() ? target : source);
    disableFor(mProblem->text(), mBake);
    disableFor(source, mLive);
}

QString BakeDialog::sourceProblem() const
{
    const BakeChoice chosen = choice();
    if (!chosen.high.isEmpty() && !QFileInfo(chosen.high).isFile())
        return tr("There is no such detailed model.");
    return chosen.maps.isEmpty() ? tr("Choose at least one map.") : QString();
}

QString BakeDialog::targetProblem() const
{
    if (!mHasUv)
        return tr("The model has no UVs: unwrap it first.");
    const QFileInfo folder(choice().folder);
    if (choice().folder.isEmpty() || !folder.isDir())
        return tr("Choose a folder for the pictures.");
    return folder.isWritable() ? QString() : tr("The folder cannot be written.");
}

BakeChoice BakeDialog::choice() const
{
    BakeChoice choice;
    choice.high = QDir::fromNativeSeparators(mHigh->text().trimmed());
    choice.maps.clear();
    for (int i = 0; i < mMaps->count(); ++i) {
        if (mMaps->item(i)->checkState() == Qt::Checked)
            choice.maps << mMaps->item(i)->data(nameRole).toString();
    }
    choice.width = mWidth->value() == mTextureSize ? 0 : mWidth->value();
    choice.samplesPerSide = mSamples->currentData().toInt();
    choice.rays = mRays->value();
    choice.cage = mCage->value() / 100;
    choice.direction = BakeChoice::Direction(mDirection->currentData().toInt());
    choice.byName = mByName->isChecked();
    choice.greenDown = mGreenDown->isChecked();
    choice.dilation = mDilation->value();
    const auto &[suffix, bits] = formats[std::max(0, mFormat->currentIndex())];
    choice.suffix = QString::fromLatin1(suffix);
    choice.bits = bits;
    choice.folder = QDir::fromNativeSeparators(mFolder->text().trimmed());
    return choice;
}

} // namespace autocuts
