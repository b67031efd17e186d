#include "views/ui/questions.h"

#include <QAbstractSpinBox>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeView>
#include <QUrl>

namespace autocuts {

namespace {

constexpr qsizetype mostNamed = 8; // files that are named in a question; more are only counted

//! The suffix that is added to a name without one: "*.obj" of the filter "Wavefront OBJ (*.obj)".
QString firstSuffix(const QString &filter)
{
    const qsizetype begin = filter.indexOf(QLatin1String("*."));
    if (begin < 0)
        return {};
    qsizetype end = begin + 2;
    while (end < filter.size() && filter[end].isLetterOrNumber())
        ++end;
    return filter.mid(begin + 2, end - begin - 2);
}

//! What is typed goes to the first field, in place of what it says.
void focusFirstField(QDialog &dialog)
{
    for (QWidget *at = dialog.nextInFocusChain(); at != &dialog; at = at->nextInFocusChain()) {
        if (at->isHidden() || !at->isEnabledTo(&dialog) || !(at->focusPolicy() & Qt::TabFocus))
            continue;
        auto *number = qobject_cast<QAbstractSpinBox *>(at);
        auto *text = qobject_cast<QLineEdit *>(at);
        if (!number && !text)
            continue;
        at->setFocus();
        if (number)
            number->selectAll();
        else
            text->selectAll();
        return;
    }
}

//! Where the desktop has no file dialog, Qt's own one cuts names and dates off.
void fitColumns(QDialog &dialog)
{
    const auto *files = dialog.findChild<QTreeView *>(QStringLiteral("treeView"));
    if (!qobject_cast<QFileDialog *>(&dialog) || !files)
        return;
    files->header()->setStretchLastSection(false);
    files->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    files->header()->setSectionResizeMode(0, QHeaderView::Stretch);
}

} // namespace

Questions::Unsaved Questions::askUnsaved(const QString &name, bool fileIsGone)
{
    const QString question =
        fileIsGone ? tr("The file of %1 is gone. Save it anew?") : tr("Save the changes to %1?");
    QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"), question.arg(name), QMessageBox::NoButton,
                    mWindow);
    box.setInformativeText(tr("What is not saved is lost."));
    const auto *save = box.addButton(tr("&Save"), QMessageBox::AcceptRole);
    const auto *discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    box.setEscapeButton(box.addButton(QMessageBox::Cancel));
    run(box);
    if (box.clickedButton() == save)
        return Unsaved::Save;
    return box.clickedButton() == discard ? Unsaved::Discard : Unsaved::Cancel;
}

Questions::Changed Questions::askChanged(const QString &name)
{
    QMessageBox box(QMessageBox::Warning, tr("Changed on disk"),
                    tr("Another program has changed %1 since it was opened here.").arg(name),
                    QMessageBox::NoButton, mWindow);
    box.setInformativeText(
        tr("Overwrite replaces those changes; a backup of them stays beside the session. Reload loses "
           "the changes made here."));
    const auto *saveAs = box.addButton(tr("Save &as..."), QMessageBox::AcceptRole);
    const auto *overwrite = box.addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
    const auto *reload = box.addButton(tr("&Reload"), QMessageBox::DestructiveRole);
    QPushButton *const cancel = box.addButton(QMessageBox::Cancel);
    box.setEscapeButton(cancel);
    box.setDefaultButton(cancel);
    run(box);
    if (box.clickedButton() == saveAs)
        return Changed::SaveAs;
    if (box.clickedButton() == overwrite)
        return Changed::Overwrite;
    return box.clickedButton() == reload ? Changed::Reload : Changed::Cancel;
}

Questions::Hidden Questions::askHidden(qsizetype hidden)
{
    QMessageBox box(QMessageBox::Question, tr("Hidden faces"),
                    tr("Hidden faces: %1. Is their map to change too?").arg(hidden), QMessageBox::NoButton,
                    mWindow);
    box.setInformativeText(tr("The answer holds until all faces are shown again."));
    QPushButton *const shown = box.addButton(tr("&Only what is shown"), QMessageBox::AcceptRole);
    const auto *all = box.addButton(tr("&All faces"), QMessageBox::DestructiveRole);
    box.setEscapeButton(box.addButton(QMessageBox::Cancel));
    box.setDefaultButton(shown);
    run(box);
    if (box.clickedButton() == shown)
        return Hidden::OnlyShown;
    return box.clickedButton() == all ? Hidden::All : Hidden::Cancel;
}

bool Questions::confirm(const QString &question, const QString &detail, const QString &action)
{
    QMessageBox box(QMessageBox::Question, QGuiApplication::applicationDisplayName(), question,
                    QMessageBox::NoButton, mWindow);
    box.setInformativeText(detail);
    const auto *yes = box.addButton(action, QMessageBox::AcceptRole);
    QPushButton *const cancel = box.addButton(QMessageBox::Cancel);
    box.setEscapeButton(cancel);
    box.setDefaultButton(cancel);
    run(box);
    return box.clickedButton() == yes;
}

bool Questions::confirmReplacing(const QStringList &files)
{
    if (files.isEmpty())
        return true;
    QStringList names;
    for (const QString &file : files.mid(0, mostNamed))
        names << QFileInfo(file).fileName();
    if (const qsizetype more = files.size() - mostNamed; more > 0)
        names << tr("and %1 more").arg(more);
    return confirm(
        tr("Replace %n pictures? Undo does not bring them back.", nullptr, static_cast<int>(files.size())),
        names.join(u'\n'), tr("Replace"));
}

QString Questions::fileToOpen(const QString &title, const QString &folder, const QStringList &filters)
{
    QFileDialog dialog(mWindow, title, folder);
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilters(filters);
    return run(dialog) == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString Questions::folderToOpen(const QString &title, const QString &folder)
{
    QFileDialog dialog(mWindow, title, folder);
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly, false); // the pictures in it are seen
    return run(dialog) == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString Questions::fileToSave(const QString &title, const QString &path, const QStringList &filters)
{
    const QFileInfo proposed(path);
    QFileDialog dialog(mWindow, title, proposed.path());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    dialog.selectFile(proposed.fileName());
    dialog.setDefaultSuffix(firstSuffix(filters.value(0)));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                     [&dialog](const QString &filter) { dialog.setDefaultSuffix(firstSuffix(filter)); });
    return run(dialog) == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

int Questions::run(QDialog &dialog)
{
    if (!dialog.focusWidget())
        focusFirstField(dialog);
    fitColumns(dialog);
    return dialog.exec();
}

void Questions::showError(const Error &error)
{
    const QString text = error.message.left(1).toUpper() + error.message.mid(1) + QLatin1Char('.');
    auto *box = new QMessageBox(QMessageBox::Critical, QGuiApplication::applicationDisplayName(), text,
                                QMessageBox::Close, mWindow);
    box->setAttribute(Qt::WA_DeleteOnClose);
    QStringList details;
    if (!error.remedy.isEmpty())
        details << error.remedy + QLatin1Char('.');
    if (!error.file.isEmpty())
        details << (error.line > 0
                        ? tr("%1, line %2").arg(QDir::toNativeSeparators(error.file)).arg(error.line)
                        : QDir::toNativeSeparators(error.file));
    box->setInformativeText(details.join(QStringLiteral("\n\n")));
    box->open();
}

void Questions::showFolder(const QString &folder)
{
    QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
}

} // namespace autocuts
