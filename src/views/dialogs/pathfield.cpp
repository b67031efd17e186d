#include "views/dialogs/pathfield.h"

#include "views/dialogs/fieldrow.h"
#include "views/ui/questions.h"

#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>

namespace autocuts {

PathField::PathField(const QString &title, Questions &questions, QWidget *parent)
    : QWidget(parent), mTitle(title), mQuestions(questions), mEdit(new QLineEdit)
{
    auto *button = new QPushButton(tr("&Browse..."));
    fieldRow(mEdit, button, this);
    mEdit->setMinimumWidth(320);
    connect(mEdit, &QLineEdit::textChanged, this, &PathField::pathChanged);
    connect(button, &QPushButton::clicked, this, &PathField::browse);
}

QString PathField::path() const
{
    return QDir::fromNativeSeparators(mEdit->text().trimmed());
}

void PathField::setPath(const QString &path)
{
    mEdit->setText(QDir::toNativeSeparators(path));
}

void PathField::setSuffix(const QString &suffix)
{
    const QFileInfo info(path());
    if (info.suffix().compare(suffix, Qt::CaseInsensitive) == 0 || info.fileName().isEmpty())
        return;
    setPath(QDir(info.path()).filePath(info.completeBaseName() + QLatin1Char('.') + suffix));
}

QString PathField::problem() const
{
    const QFileInfo info(path());
    if (info.fileName().isEmpty())
        return tr("Enter a file name.");
    if (info.isDir())
        return tr("This is a folder.");
    if (!info.dir().exists())
        return tr("There is no such folder.");
    return {};
}

bool PathField::confirmReplacing()
{
    const QFileInfo info(path());
    if (!info.exists() || path() == mAgreed)
        return true;
    return mQuestions.confirm(tr("Replace %1?").arg(info.fileName()), tr("Its content is lost."),
                              tr("&Replace"));
}

void PathField::browse()
{
    const QString chosen = mQuestions.fileToSave(mTitle, path(), mFilters);
    if (chosen.isEmpty())
        return;
    // The file dialog has already asked.
    mAgreed = chosen;
    setPath(chosen);
}

} // namespace autocuts
