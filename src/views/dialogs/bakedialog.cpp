#include "views/dialogs/bakedialog.h"

#include "jobs/bakepictures.h"
#include "model/document/document.h"
#include "views/control/pictures/bakemaptexts.h"
#include "views/dialogs/fieldrow.h"
#include "views/ui/dialogsize.h"
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
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int nameRole = Qt::UserRole;

//! The formats and their bits.
constexpr std::pair<const char *, int> formats[]{{"png", 8}, {"png", 16}, {"tif", 8}, {"tif", 16},
                                                 {"tga", 8}, {"exr", 16}, {"exr", 32}};

template <class Widget>
Widget *named(const char *name, Widget *widget)
{
    widget->setObjectName(QLatin1StringView(name));
    return widget;
}

//! Shows as many decimals as a number has.
class PercentBox final : public QDoubleSpinBox
{
public:
    QString textFromValue(double value) const override
    {
        return locale().toString(value, 'f', QLocale::FloatingPointShortest);
    }
};

//! \param value a share
QDoubleSpinBox *makePercent(double low, double high, double value, const QString &tip)
{
    auto *box = new PercentBox;
    box->setDecimals(4);
    box->setRange(low, high);
    box->setSuffix(BakeDialog::tr(" %"));
    box->setValue(100 * value);
    box->setToolTip(tip);
    return box;
}

} // namespace

BakeDialog::BakeDialog(const Document &document, const jobs::BakeChoice &last, const QStringList &filters,
                       Questions &questions)
    : QDialog(questions.window()), mModel(document.state()), mUv(document.uv()),
      mTileHeight(document.packingSettings().tileHeight()), mHasUv(mUv.array().isFinite().any()),
      mTextureSize(document.packingSettings().textureSize), mQuestions(questions), mFilters(filters),
      mMaps(named("maps", new QListWidget)), mCageNote(named("cageNote", new QLabel)),
      mProblem(named("problem", new QLabel)), mOwnCage(last.ownCage)
{
    setWindowTitle(tr("Bake"));
    auto *columns = new QHBoxLayout;
    columns->addWidget(makeModels(last), 1);
    columns->addWidget(makePictures(last), 1);
    mFolder = named("folder", new QLineEdit(QDir::toNativeSeparators(last.folder)));
    auto *browse = named("browseFolder", new QPushButton(tr("Bro&wse...")));
    mPutOn = named("putOn", new QCheckBox(tr("Show &normals, occlusion and colours on the model")));
    mPutOn->setChecked(last.putOn);
    mPutOn->setToolTip(
        tr("The pictures become textures of the materials, shown in light; this can be undone"));
    auto *files = new QFormLayout;
    files->addRow(tr("Fold&er:"), fieldRow(mFolder, browse));
    files->addRow(QString(), mPutOn);
    mProblem->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mBake = buttons->addButton(tr("Ba&ke"), QDialogButtonBox::AcceptRole);
    mBake->setObjectName("bake"_L1);
    mBake->setDefault(true);
    mLive = buttons->addButton(tr("Show li&ve"), QDialogButtonBox::ActionRole);
    mLive->setObjectName("live"_L1);
    mLive->setAutoDefault(false);
    mLive->setToolTip(
        tr("Show the first chosen map in both views, also while the UVs change; no files are written"));
    auto *all = new QVBoxLayout;
    all->addLayout(columns);
    all->addLayout(files);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(scrolled(all), 1);
    layout->addWidget(mProblem);
    layout->addWidget(buttons);
    connect(mLive, &QPushButton::clicked, this, [this] { done(Live); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(browse, &QPushButton::clicked, this, &BakeDialog::browseFolder);
    connect(mMaps, &QListWidget::itemChanged, this, &BakeDialog::showState);
    connect(mFolder, &QLineEdit::textChanged, this, &BakeDialog::showState);
    for (QLineEdit *edit : {mHigh, mCageFile})
        connect(edit, &QLineEdit::textChanged, this, &BakeDialog::sourceChanged);
    connect(mCage, &QDoubleSpinBox::valueChanged, this, &BakeDialog::cageTyped);
    // Typing the number that was there emits no valueChanged(), but makes it the user's own.
    connect(mCage->findChild<QLineEdit *>(), &QLineEdit::textEdited, this, &BakeDialog::cageTyped);
    sourceChanged();
    resizeToContent(*this);
}

BakeDialog::~BakeDialog()
{
    endMeasuring();
}

QWidget *BakeDialog::makeModels(const jobs::BakeChoice &last)
{
    auto *group = new QGroupBox(tr("Models and maps"));
    auto *browseHigh = named("browseHigh", new QPushButton(tr("&Browse...")));
    auto *browseCage = named("browseCage", new QPushButton(tr("Brow&se...")));
    mHigh = named("high", new QLineEdit(QDir::toNativeSeparators(last.high)));
    mHigh->setPlaceholderText(tr("None: this model itself"));
    mHigh->setClearButtonEnabled(true);
    mHigh->setMinimumWidth(220);
    mCage = named(
        "cage", makePercent(1e-4, 100, last.cage,
                            tr("How far the detailed model is looked for, outside and inside of the surface; "
                               "100 % is the diagonal of the model")));
    mPropose = named("propose", new QPushButton(tr("Propose")));
    mPropose->setToolTip(
        tr("Measure how far the models are apart, and take that and half as much again; done "
           "for each bake where no distance is typed"));
    mCageNote->setWordWrap(true);
    mCageFile = named("cageFile", new QLineEdit(QDir::toNativeSeparators(last.cageFile)));
    mCageFile->setPlaceholderText(tr("None: by distance"));
    mCageFile->setClearButtonEnabled(true);
    mCageFile->setToolTip(
        tr("This model with its vertices moved outwards; rays run from there through the surface"));
    mDirection = named("direction", new QComboBox);
    mDirection->addItem(tr("Smooth: no gaps at edges"), int(bake::CageDirection::Smoothed));
    mDirection->addItem(tr("Along the shading normals"), int(bake::CageDirection::Shading));
    mDirection->addItem(tr("Smooth at edges, straight elsewhere"), int(bake::CageDirection::Corrected));
    mDirection->setCurrentIndex(std::max(0, mDirection->findData(int(last.direction))));
    mDirection->setToolTip(tr("In which direction the detailed model is looked for"));
    mByName = named("byName", new QCheckBox(tr("&Objects see those of the same name only")));
    mByName->setChecked(last.byName);
    mByName->setToolTip(tr("Endings such as _low and _high do not count"));
    addMaps(last.maps);
    auto *form = new QFormLayout(group);
    form->addRow(tr("De&tailed model:"), fieldRow(mHigh, browseHigh));
    form->addRow(tr("C&age:"), fieldRow(mCage, mPropose));
    form->addRow(QString(), mCageNote);
    form->addRow(tr("Ca&ge file:"), fieldRow(mCageFile, browseCage));
    form->addRow(tr("D&irection:"), mDirection);
    form->addRow(QString(), mByName);
    form->addRow(tr("&Maps:"), mMaps);
    connect(browseHigh, &QPushButton::clicked, this, &BakeDialog::browseDetailed);
    connect(browseCage, &QPushButton::clicked, this, &BakeDialog::browseCage);
    connect(mPropose, &QPushButton::clicked, this, [this] {
        mOwnCage = false;
        proposeCage();
    });
    return group;
}

QWidget *BakeDialog::makePictures(const jobs::BakeChoice &last)
{
    auto *group = new QGroupBox(tr("Pictures"));
    mWidth = named("width", new QSpinBox);
    mWidth->setRange(PreferenceLimits::minTextureSize, PackingSettings::maxTextureSize);
    mWidth->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mWidth->setValue(last.width > 0 ? last.width : mTextureSize);
    mWidth->setSuffix(tr(" px"));
    mWidth->setToolTip(tr("Width of the pictures; at first that of the texture in the Packing panel, whose "
                          "proportions they have"));
    mSamples = named("samples", new QComboBox);
    for (const int perSide : {1, 2, 3, 4, 6, 8})
        mSamples->addItem(QString::number(perSide * perSide), perSide);
    mSamples->setCurrentIndex(std::max(0, mSamples->findData(last.samplesPerSide)));
    mSamples->setToolTip(tr("Places in each texel that are baked and averaged"));
    mRays = named("rays", new QSpinBox);
    mRays->setRange(1, 65536);
    mRays->setValue(last.rays);
    mRays->setToolTip(tr("For occlusion, bent normals, curvature and thickness, in each texel"));
    mReach =
        named("reach",
              makePercent(0, 1e8, last.reach,
                          tr("What is farther away casts no occlusion; 100 % is the diagonal of the model")));
    mReach->setSpecialValueText(tr("All"));
    mCurvature = named(
        "curvature", makePercent(1e-4, 100, last.curvatureRadius,
                                 tr("Size of what shows as curvature; 100 % is the diagonal of the model")));
    mThickness =
        named("thickness", makePercent(1e-4, 1000, last.thicknessLimit,
                                       tr("Thickness that is white; 100 % is the diagonal of the model")));
    mColors = named("colors", new QComboBox);
    mColors->addItem(tr("What the model has"), int(ColorSource::Auto));
    mColors->addItem(tr("Textures"), int(ColorSource::Textures));
    mColors->addItem(tr("Vertex colours"), int(ColorSource::Vertices));
    mColors->addItem(tr("Colours of materials"), int(ColorSource::Materials));
    mColors->setCurrentIndex(std::max(0, mColors->findData(int(last.colors))));
    mColors->setToolTip(tr("Where the colours of the map of colours come from"));
    mGreenDown = named("greenDown", new QCheckBox(tr("Green points &down (DirectX)")));
    mGreenDown->setChecked(last.greenDown);
    mDilation = named("dilation", new QSpinBox);
    mDilation->setRange(0, 1024);
    mDilation->setValue(last.dilation);
    mDilation->setSuffix(tr(" px"));
    mDilation->setToolTip(tr("Texels around islands that are filled with the nearest value"));
    mFormat = named("format", new QComboBox);
    for (const auto &[suffix, bits] : formats) {
        mFormat->addItem(tr("%1, %2 bits").arg(QString::fromLatin1(suffix).toUpper()).arg(bits));
        if (last.suffix == QLatin1StringView(suffix) && last.bits == bits)
            mFormat->setCurrentIndex(mFormat->count() - 1);
    }
    auto *form = new QFormLayout(group);
    form->addRow(tr("Si&ze:"), mWidth);
    form->addRow(tr("Sam&ples per texel:"), mSamples);
    form->addRow(tr("Ra&ys per texel:"), mRays);
    form->addRow(tr("Occl&usion reaches:"), mReach);
    form->addRow(tr("&Curvature radius:"), mCurvature);
    form->addRow(tr("T&hickness limit:"), mThickness);
    form->addRow(tr("Colou&rs from:"), mColors);
    form->addRow(QString(), mGreenDown);
    form->addRow(tr("Di&lation:"), mDilation);
    form->addRow(tr("&Format:"), mFormat);
    return group;
}

void BakeDialog::addMaps(const QStringList &chosen)
{
    for (const QString &name : jobs::bakeMapNames()) {
        auto *item = new QListWidgetItem(bakeMapTitle(name), mMaps);
        item->setToolTip(bakeMapTip(name));
        item->setData(nameRole, name);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(chosen.contains(name) ? Qt::Checked : Qt::Unchecked);
    }
    const int height = mMaps->sizeHintForRow(0) * mMaps->count() + 2 * mMaps->frameWidth();
    mMaps->setFixedHeight(height);
}

//! Where to look for a file: where it is, or in the folder of the pictures.
QString BakeDialog::orFolder(const QString &file) const
{
    return file.isEmpty() ? choice().folder : file;
}

void BakeDialog::browseDetailed()
{
    const QString path = mQuestions.fileToOpen(tr("Detailed model"), orFolder(choice().high), mFilters);
    if (!path.isEmpty())
        mHigh->setText(QDir::toNativeSeparators(path));
}

void BakeDialog::browseCage()
{
    const QString path = mQuestions.fileToOpen(tr("Cage"), orFolder(choice().cageFile), mFilters);
    if (!path.isEmpty())
        mCageFile->setText(QDir::toNativeSeparators(path));
}

//! Proposes a cage for a new detailed model, unless the user has typed one.
void BakeDialog::sourceChanged()
{
    const jobs::BakeChoice chosen = choice();
    const bool wanted = !mOwnCage && chosen.cageFile.isEmpty() && QFileInfo(chosen.high).isFile();
    if (!wanted)
        endMeasuring();
    else if (chosen.high != mMeasured)
        proposeCage();
    showState();
}

void BakeDialog::proposeCage()
{
    endMeasuring();
    // Not a job of the dialog: that would keep it from closing until the model is read.
    mMeasuring.start(
        [model = mModel, high = choice().high](const std::atomic<bool> &stop) {
            return jobs::proposedCage(model, high, JobContext(&stop));
        },
        [this](const Result<double> &cage) { takeCage(cage); },
        [this](const QString &message) {
            takeCage(Error{message, choice().high, 0, {}});
        });
    showState();
}

void BakeDialog::takeCage(const Result<double> &cage)
{
    if (cage) {
        const QSignalBlocker blocker(mCage); // not typed
        mCage->setValue(100 * cage.value());
        mMeasured = choice().high;
    } else {
        mNotMeasured = cage.error().toString();
    }
    showState();
}

void BakeDialog::cageTyped()
{
    mOwnCage = true;
    endMeasuring();
    showState();
}

void BakeDialog::endMeasuring()
{
    mMeasuring.drop();
    mMeasured.clear();
    mNotMeasured.clear();
}

QString BakeDialog::cageNote() const
{
    const jobs::BakeChoice chosen = choice();
    if (chosen.high.isEmpty() && (chosen.maps.contains(u"ao"_s) || chosen.maps.contains(u"bent-normal"_s)))
        return tr("Occlusion has no cage: it is that of this model by itself");
    if (!mCage->isEnabled())
        return {};
    if (mMeasuring.isRunning())
        return tr("Measuring how far the models are apart...");
    if (!mNotMeasured.isEmpty())
        return mNotMeasured;
    return mMeasured.isEmpty() ? QString() : tr("Proposed, from the distance of both models");
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
    const QString needsModel = tr("Choose a detailed model first");
    for (QWidget *widget : std::initializer_list<QWidget *>{mDirection, mByName, mCageFile->parentWidget()})
        enableOrSay(widget, detailed, needsModel);
    enableOrSay(mCage, detailed && choice().cageFile.isEmpty(),
                detailed ? tr("The cage file says how far rays go") : needsModel);
    enableOrSay(mPropose, mCage->isEnabled() && !mMeasuring.isRunning() && QFileInfo(choice().high).isFile(),
                !detailed                ? needsModel
                : mMeasuring.isRunning() ? tr("Measuring how far the models are apart...")
                : !mCage->isEnabled()    ? tr("The cage file says how far rays go")
                                         : tr("Only measured for a model in a file"));
    mCageNote->setText(cageNote());
    mCageNote->setVisible(!mCageNote->text().isEmpty());
    const QString source = sourceProblem(), target = targetProblem();
    const QString problem = source.isEmpty() ? target : source;
    mProblem->setText(problem);
    disableFor(problem, mBake);
    disableFor(source, mLive);
}

QString BakeDialog::sourceProblem() const
{
    const jobs::BakeChoice chosen = choice();
    if (!chosen.high.isEmpty() && !QFileInfo(chosen.high).isFile())
        return tr("There is no such detailed model.");
    if (!chosen.high.isEmpty() && !chosen.cageFile.isEmpty() && !QFileInfo(chosen.cageFile).isFile())
        return tr("There is no such cage.");
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

QStringList BakeDialog::files() const
{
    return jobs::bakedFiles(mModel.scene, mUv, mTileHeight, choice());
}

void BakeDialog::accept()
{
    QStringList existing = files();
    existing.removeIf(
        [this](const QString &file) { return mReplaceable.contains(file) || !QFileInfo::exists(file); });
    if (mQuestions.confirmReplacing(existing))
        QDialog::accept();
}

jobs::BakeChoice BakeDialog::choice() const
{
    jobs::BakeChoice choice;
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
    choice.ownCage = mOwnCage;
    choice.cageFile = QDir::fromNativeSeparators(mCageFile->text().trimmed());
    choice.reach = mReach->value() / 100;
    choice.curvatureRadius = mCurvature->value() / 100;
    choice.thicknessLimit = mThickness->value() / 100;
    choice.colors = ColorSource(mColors->currentData().toInt());
    choice.direction = bake::CageDirection(mDirection->currentData().toInt());
    choice.byName = mByName->isChecked();
    choice.greenDown = mGreenDown->isChecked();
    choice.dilation = mDilation->value();
    const auto &[suffix, bits] = formats[std::max(0, mFormat->currentIndex())];
    choice.suffix = QString::fromLatin1(suffix);
    choice.bits = bits;
    choice.folder = QDir::fromNativeSeparators(mFolder->text().trimmed());
    choice.putOn = mPutOn->isChecked();
    return choice;
}

} // namespace autocuts
