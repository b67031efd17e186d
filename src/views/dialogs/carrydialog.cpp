#include "views/dialogs/carrydialog.h"

#include "jobs/carryplan.h"
#include "model/document/document.h"
#include "model/plain/udimtiles.h"
#include "views/control/session/proposedfolder.h"
#include "views/dialogs/fieldrow.h"
#include "views/ui/questions.h"
#include "views/ui/reasons.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;
using From = jobs::CarryChoice::From;

namespace {

constexpr int mostRowsShown = 8;

QString channelName(TextureChannel channel)
{
    switch (channel) {
    case TextureChannel::BaseColor:
        return CarryDialog::tr("Base colour");
    case TextureChannel::Roughness:
        return CarryDialog::tr("Roughness");
    case TextureChannel::Metalness:
        return CarryDialog::tr("Metalness");
    case TextureChannel::Normal:
        return CarryDialog::tr("Normals");
    case TextureChannel::Occlusion:
        return CarryDialog::tr("Occlusion");
    case TextureChannel::Emission:
        return CarryDialog::tr("Emission");
    case TextureChannel::Height:
        return CarryDialog::tr("Height");
    }
    return {};
}

QString materialNames(const Scene &scene, const jobs::CarriedPicture &picture)
{
    QStringList names;
    for (const int material : picture.materials)
        names << (material < 0 ? CarryDialog::tr("No material")
                               : scene.materialNames[static_cast<std::size_t>(material)]);
    return names.join(u", "_s);
}

QString channelNames(const jobs::CarriedPicture &picture)
{
    QStringList names;
    for (const TextureChannel channel : picture.channels)
        names << channelName(channel);
    return names.join(u", "_s);
}

//! Where the first texture lies that is a file in a folder that is there.
QString folderOf(const Document &document, const QString &otherwise)
{
    for (const jobs::CarriedPicture &picture : jobs::planCarrying(document.state(), {}).pictures) {
        const QString folder = QFileInfo(picture.source.file).path();
        if (picture.source.content.isEmpty() && isFolder(folder))
            return folder;
    }
    return otherwise;
}

} // namespace

CarryDialog::CarryDialog(const Document &document, const jobs::CarryChoice &last, const QString &folder,
                         const QStringList &filters, Questions &questions)
    : QDialog(questions.window()), mDocument(document), mQuestions(questions), mFilters(filters),
      mFrom(new QComboBox), mUvSet(new QComboBox), mSize(new QComboBox), mFormat(new QComboBox),
      mFile(new QLineEdit), mFolder(new QLineEdit), mSuffix(new QLineEdit), mMargin(new QSpinBox),
      mList(new QTreeWidget), mProblem(new QLabel)
{
    setWindowTitle(tr("Carry textures over"));
    const double tileHeight = document.packingSettings().tileHeight();
    mTiled = tilesToBake(document.mesh(), document.uv(), tileHeight).numbers.size() > 1;
    addSources(last);
    addFormats(last);
    mFolder->setText(
        QDir::toNativeSeparators(last.folder.isEmpty() ? folderOf(document, folder) : last.folder));
    mFolder->setMinimumWidth(460);
    mSuffix->setText(jobs::freeSuffix(
        document.state(), {QDir::fromNativeSeparators(mFolder->text()), {}, mTiled, last.format}));
    mSuffix->setToolTip(tr("Goes to the end of the names, so that the old pictures stay"));
    mMargin->setRange(0, 1024);
    mMargin->setValue(last.margin);
    mMargin->setSuffix(tr(" px"));
    mMargin->setToolTip(tr("Texels around islands that are filled with the nearest value"));
    mProblem->setWordWrap(true);
    fillForm();
    connect(mFrom, &QComboBox::currentIndexChanged, this, &CarryDialog::showState);
    connect(mFormat, &QComboBox::currentIndexChanged, this, &CarryDialog::showState);
    for (QLineEdit *edit : {mFile, mFolder, mSuffix})
        connect(edit, &QLineEdit::textChanged, this, &CarryDialog::showState);
    showState();
}

void CarryDialog::addSources(const jobs::CarryChoice &last)
{
    mFrom->addItem(tr("The map they were made for"), int(From::Textures));
    mFrom->setItemData(0,
                       tr("The map as it was when the model was opened, the first textures were chosen, or "
                          "they were last carried over"),
                       Qt::ToolTipRole);
    const std::vector<UvSet> &sets = mDocument.uvSets();
    for (int i = 0; i < static_cast<int>(sets.size()); ++i) {
        if (i != mDocument.activeUvSet())
            mUvSet->addItem(sets[static_cast<std::size_t>(i)].name, i);
    }
    if (mUvSet->count() > 0)
        mFrom->addItem(tr("Another UV set"), int(From::UvSet));
    mFrom->addItem(tr("The map of a file"), int(From::File));
    mFrom->setToolTip(tr("For which map the textures are as they are now"));
    mFrom->setCurrentIndex(std::max(0, mFrom->findData(int(last.from))));
    mUvSet->setCurrentIndex(std::max(0, mUvSet->findData(last.uvSet)));
    mFile->setText(QDir::toNativeSeparators(last.file.isEmpty() ? mDocument.state().scene.path : last.file));
}

void CarryDialog::addFormats(const jobs::CarryChoice &last)
{
    mSize->addItem(tr("As the old pictures"), 0);
    for (const int size : {256, 512, 1024, 2048, 4096, 8192})
        mSize->addItem(tr("%1 px").arg(size), size);
    mSize->setCurrentIndex(std::max(0, mSize->findData(last.size)));
    mFormat->addItem(tr("As the old pictures"), QString());
    mFormat->setItemData(0, tr("JPEG pictures become PNG: they would lose by being compressed again"),
                         Qt::ToolTipRole);
    for (const char *format : {"png", "tif", "tga", "exr"})
        mFormat->addItem(QString::fromLatin1(format).toUpper(), QString::fromLatin1(format));
    mFormat->setCurrentIndex(std::max(0, mFormat->findData(last.format)));
}

void CarryDialog::fillForm()
{
    auto *browseFile = new QPushButton(tr("&Browse...")), *browseFolder = new QPushButton(tr("B&rowse..."));
    mFileRow = fieldRow(mFile, browseFile);
    mFolderRow = fieldRow(mFolder, browseFolder);
    mList->setHeaderLabels({tr("Material"), tr("Shown as"), tr("Old picture"), tr("New file")});
    mList->setRootIsDecorated(false);
    mList->setSelectionMode(QAbstractItemView::NoSelection);
    mList->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mCarry = buttons->addButton(tr("&Carry over"), QDialogButtonBox::AcceptRole);
    mCarry->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(tr("Textures &fit:"), mFrom);
    form->addRow(tr("UV &set:"), mUvSet);
    form->addRow(tr("F&ile:"), mFileRow);
    form->addRow(tr("Fold&er:"), mFolderRow);
    form->addRow(tr("E&nding of names:"), mSuffix);
    form->addRow(tr("Si&ze:"), mSize);
    form->addRow(tr("For&mat:"), mFormat);
    form->addRow(tr("Di&lation:"), mMargin);
    form->addRow(mList);
    form->addRow(mProblem);
    form->addRow(buttons);
    for (const auto &[widget, name] :
         std::initializer_list<std::pair<QWidget *, const char *>>{{mFrom, "from"},
                                                                   {mUvSet, "uvSet"},
                                                                   {mFile, "file"},
                                                                   {browseFile, "browseFile"},
                                                                   {mFolder, "folder"},
                                                                   {browseFolder, "browseFolder"},
                                                                   {mSuffix, "suffix"},
                                                                   {mSize, "size"},
                                                                   {mFormat, "format"},
                                                                   {mMargin, "margin"},
                                                                   {mList, "pictures"},
                                                                   {mProblem, "problem"},
                                                                   {mCarry, "carry"}})
        widget->setObjectName(QLatin1StringView(name));
    connect(buttons, &QDialogButtonBox::accepted, this, &CarryDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(browseFile, &QPushButton::clicked, this, &CarryDialog::browseFile);
    connect(browseFolder, &QPushButton::clicked, this, &CarryDialog::browseFolder);
}

void CarryDialog::browseFile()
{
    const QString old = choice().file;
    const QString path = mQuestions.fileToOpen(tr("Model with the map of the textures"),
                                               old.isEmpty() ? choice().folder : old, mFilters);
    if (!path.isEmpty())
        mFile->setText(QDir::toNativeSeparators(path));
}

void CarryDialog::browseFolder()
{
    const QString path = mQuestions.folderToOpen(tr("Folder for the pictures"), choice().folder);
    if (!path.isEmpty())
        mFolder->setText(QDir::toNativeSeparators(path));
}

jobs::CarryPlan CarryDialog::plan() const
{
    const jobs::CarryChoice chosen = choice();
    return jobs::planCarrying(mDocument.state(), {chosen.folder, chosen.suffix, mTiled, chosen.format});
}

void CarryDialog::showState()
{
    auto *form = static_cast<QFormLayout *>(layout());
    const From from = choice().from;
    form->setRowVisible(mUvSet, from == From::UvSet);
    form->setRowVisible(mFileRow, from == From::File);
    const jobs::CarryPlan planned = plan();
    showPlan(planned);
    const QString source = sourceProblem();
    mProblem->setText(source.isEmpty() ? targetProblem(planned) : source);
    disableFor(mProblem->text(), mCarry);
    if (const qsizetype existing = planned.existingFiles().size(); mCarry->isEnabled() && existing > 0)
        mProblem->setText(tr("%n of the new files exist already and would be replaced.", nullptr,
                             static_cast<int>(existing)));
    else if (mCarry->isEnabled() && !planned.missing.isEmpty())
        mProblem->setText(
            tr("Pictures that are not there stay as they are: %1.").arg(planned.missing.join(u", "_s)));
}

void CarryDialog::showPlan(const jobs::CarryPlan &plan)
{
    mList->clear();
    for (const jobs::CarriedPicture &picture : plan.pictures) {
        const QString old = picture.source.content.isEmpty() ? QFileInfo(picture.source.file).fileName()
                                                             : tr("in the model's file");
        new QTreeWidgetItem(mList, {materialNames(mDocument.state().scene, picture), channelNames(picture),
                                    old, QFileInfo(picture.newFile).fileName()});
    }
    for (const QString &name : plan.missing) {
        auto *item = new QTreeWidgetItem(mList, {QString(), tr("not there"), name, QString()});
        item->setDisabled(true);
    }
    const int rows = std::clamp(mList->topLevelItemCount(), 2, mostRowsShown);
    const int row = std::max(mList->sizeHintForRow(0), fontMetrics().height());
    mList->setMinimumHeight(mList->header()->sizeHint().height() + rows * row + 2 * mList->frameWidth());
}

QString CarryDialog::sourceProblem() const
{
    if (!mDocument.uv().array().isFinite().any())
        return tr("The model has no UVs: unwrap it first.");
    const jobs::CarryChoice chosen = choice();
    if (chosen.from == From::File && !QFileInfo(chosen.file).isFile())
        return tr("There is no such file.");
    return {};
}

QString CarryDialog::targetProblem(const jobs::CarryPlan &plan) const
{
    if (plan.pictures.empty())
        return plan.missing.isEmpty() ? tr("The model has no textures: choose some in the Textures panel.")
                                      : tr("The textures are not there: %1.").arg(plan.missing.join(u", "_s));
    const QFileInfo folder(choice().folder);
    if (choice().folder.isEmpty() || !folder.isDir())
        return tr("Choose a folder for the pictures.");
    if (!folder.isWritable())
        return tr("The folder cannot be written.");
    if (choice().suffix.contains(u'/') || choice().suffix.contains(u'\\'))
        return tr("The ending has a sign that names of files cannot have.");
    if (const QString source = plan.overwrittenSource(); !source.isEmpty())
        return tr("%1 would overwrite the picture it is made from: choose another ending or folder.")
            .arg(QFileInfo(source).fileName());
    return {};
}

void CarryDialog::accept()
{
    if (mQuestions.confirmReplacing(plan().existingFiles()))
        QDialog::accept();
}

jobs::CarryChoice CarryDialog::choice() const
{
    jobs::CarryChoice choice;
    choice.from = From(mFrom->currentData().toInt());
    choice.uvSet = mUvSet->currentData().toInt();
    choice.file = QDir::fromNativeSeparators(mFile->text().trimmed());
    choice.folder = QDir::fromNativeSeparators(mFolder->text().trimmed());
    choice.suffix = mSuffix->text().trimmed();
    choice.format = mFormat->currentData().toString();
    choice.size = mSize->currentData().toInt();
    choice.margin = mMargin->value();
    return choice;
}

} // namespace autocuts
