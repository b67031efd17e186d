#include "views/dialogs/transferdialog.h"

#include "model/document/document.h"
#include "views/dialogs/fieldrow.h"
#include "views/ui/questions.h"
#include "views/ui/reasons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;
using UvSource = jobs::TransferChoice::From;

TransferDialog::TransferDialog(const Document &document, const jobs::TransferChoice &last,
                               const QString &folder, const QStringList &filters, Questions &questions)
    : QDialog(questions.window()), mQuestions(questions), mFolder(folder), mFilters(filters),
      mFrom(new QComboBox), mUvSet(new QComboBox), mObject(new QComboBox), mMatch(new QComboBox),
      mPath(new QLineEdit), mOnlySelection(new QCheckBox(tr("O&nly the selected faces"))),
      mProblem(new QLabel)
{
    setWindowTitle(tr("Transfer UVs"));
    addSources(document);
    mPath->setMinimumWidth(320);
    mPath->setText(QDir::toNativeSeparators(last.path));
    auto *browse = new QPushButton(tr("&Browse..."));
    mFileRow = fieldRow(mPath, browse);
    mMatch->addItem(tr("The same polygons, otherwise by position"), int(transfer::UvMatch::Auto));
    mMatch->addItem(tr("Only if the polygons are the same"), int(transfer::UvMatch::Topology));
    mMatch->addItem(tr("By position"), int(transfer::UvMatch::Position));
    mMatch->setCurrentIndex(std::max(0, mMatch->findData(int(last.match))));
    mMatch->setToolTip(
        tr("The same polygons: UVs are copied, wherever the models lie. By position: every face "
           "takes the UVs of the nearest points of the surface, for models of another resolution; "
           "both must lie in the same place."));
    enableOrSay(mOnlySelection, !document.selection().faces.isEmpty(), tr("Select faces first"));
    mOnlySelection->setChecked(last.onlySelection && mOnlySelection->isEnabled());
    mProblem->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mTransfer = buttons->addButton(tr("&Transfer"), QDialogButtonBox::AcceptRole);
    mTransfer->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(tr("&From:"), mFrom);
    form->addRow(tr("F&ile:"), mFileRow);
    form->addRow(tr("&UV set:"), mUvSet);
    form->addRow(tr("&Object:"), mObject);
    form->addRow(tr("&Match:"), mMatch);
    form->addRow(QString(), mOnlySelection);
    form->addRow(QString(), mProblem);
    form->addRow(buttons);
    for (const auto &[widget, name] :
         std::initializer_list<std::pair<QWidget *, const char *>>{{mFrom, "from"},
                                                                   {mPath, "path"},
                                                                   {mUvSet, "uvSet"},
                                                                   {mObject, "object"},
                                                                   {mMatch, "match"},
                                                                   {mOnlySelection, "onlySelection"},
                                                                   {mProblem, "problem"},
                                                                   {mTransfer, "transfer"}})
        widget->setObjectName(QLatin1StringView(name));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(browse, &QPushButton::clicked, this, &TransferDialog::browse);
    connect(mFrom, &QComboBox::currentIndexChanged, this, &TransferDialog::showSource);
    connect(mPath, &QLineEdit::textChanged, this, &TransferDialog::showSource);
    mFrom->setCurrentIndex(std::max(0, mFrom->findData(int(last.from))));
    mObject->setCurrentIndex(std::clamp(last.object, 0, std::max(0, mObject->count() - 1)));
    showSource();
}

//! Offers what the document has: other UV sets, and objects where there are several.
void TransferDialog::addSources(const Document &document)
{
    mFrom->addItem(tr("A file"), int(UvSource::File));
    const std::vector<UvSet> &sets = document.uvSets();
    for (int i = 0; i < static_cast<int>(sets.size()); ++i) {
        if (i != document.activeUvSet())
            mUvSet->addItem(sets[i].name, i);
    }
    if (mUvSet->count() > 0)
        mFrom->addItem(tr("Another UV set"), int(UvSource::UvSet));
    const std::vector<QString> &names = document.state().scene.objectNames;
    for (int i = 0; i < static_cast<int>(names.size()); ++i)
        mObject->addItem(names[i].isEmpty() ? tr("Object %1").arg(i + 1) : names[i], i);
    if (mObject->count() > 1)
        mFrom->addItem(tr("An object of this model"), int(UvSource::Object));
    mObject->setToolTip(tr("Its UVs go to every other object, or to those with selected faces"));
}

void TransferDialog::browse()
{
    const QString old = choice().path;
    const QString path =
        mQuestions.fileToOpen(windowTitle(), old.isEmpty() ? mFolder : QFileInfo(old).path(), mFilters);
    if (!path.isEmpty())
        mPath->setText(QDir::toNativeSeparators(path));
}

void TransferDialog::showSource()
{
    auto *form = static_cast<QFormLayout *>(layout());
    const UvSource from = choice().from;
    form->setRowVisible(mFileRow, from == UvSource::File);
    form->setRowVisible(mUvSet, from == UvSource::UvSet);
    form->setRowVisible(mObject, from == UvSource::Object);
    mProblem->setText(problem());
    disableFor(mProblem->text(), mTransfer);
    adjustSize();
}

QString TransferDialog::problem() const
{
    const jobs::TransferChoice chosen = choice();
    if (chosen.from != UvSource::File)
        return {};
    if (chosen.path.isEmpty())
        return tr("Choose a model or a session that has UVs.");
    return QFileInfo(chosen.path).isFile() ? QString() : tr("There is no such file.");
}

jobs::TransferChoice TransferDialog::choice() const
{
    jobs::TransferChoice choice;
    choice.from = UvSource(mFrom->currentData().toInt());
    choice.path = QDir::fromNativeSeparators(mPath->text().trimmed());
    choice.uvSet = mUvSet->currentData().toInt();
    if (choice.from == UvSource::Object)
        choice.object = mObject->currentData().toInt();
    choice.match = transfer::UvMatch(mMatch->currentData().toInt());
    choice.onlySelection = mOnlySelection->isChecked();
    return choice;
}

} // namespace autocuts
