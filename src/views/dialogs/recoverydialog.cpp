#include "views/dialogs/recoverydialog.h"

#include "model/io/projects/projectfile.h"
#include "views/ui/dialogsize.h"
#include "views/ui/icons.h"
#include "views/ui/questions.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace autocuts {

namespace {

constexpr QSize thumbnailSize(96, 64);

//! The picture of a session, centred in a box that has the same size for all sessions.
QIcon thumbnail(const RecoverableSession &session, qreal ratio)
{
    QPixmap box(thumbnailSize * ratio);
    box.setDevicePixelRatio(ratio);
    box.fill(Qt::transparent);
    QPainter painter(&box);
    const Result<ProjectSummary> summary = loadProjectSummary(session.file);
    QImage image;
    if (summary && image.loadFromData(summary->thumbnail)) {
        image = image.scaled(thumbnailSize * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        image.setDevicePixelRatio(ratio);
        const QSizeF size = image.deviceIndependentSize();
        painter.drawImage(
            QPointF((thumbnailSize.width() - size.width()) / 2, (thumbnailSize.height() - size.height()) / 2),
            image);
    } else {
        icon(QStringLiteral("mode-islands")).paint(&painter, QRect(QPoint(32, 16), QSize(32, 32)));
    }
    return box;
}

} // namespace

RecoveryDialog::RecoveryDialog(std::vector<RecoverableSession> sessions, Questions &questions)
    : QDialog(questions.window()), mSessions(std::move(sessions)), mQuestions(questions),
      mList(new QTreeWidget)
{
    setWindowTitle(tr("Recover sessions"));
    auto *text = new QLabel(tr("Autocuts ended unexpectedly. These sessions were saved automatically and can "
                               "be recovered; what was saved by hand is as it was."));
    text->setWordWrap(true);
    mList->setHeaderLabels({tr("Session"), tr("Last autosave"), tr("Folder")});
    mList->setRootIsDecorated(false);
    mList->setAlternatingRowColors(true);
    mList->setIconSize(thumbnailSize);
    mList->setUniformRowHeights(true);
    auto *buttons = new QDialogButtonBox;
    mRecover = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
    mDiscard = buttons->addButton(tr("&Discard"), QDialogButtonBox::DestructiveRole);
    QPushButton *const later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    later->setToolTip(tr("Ask again at the next start"));
    mRecover->setDefault(true);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(mList, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &RecoveryDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &RecoveryDialog::reject);
    connect(mDiscard, &QPushButton::clicked, this, &RecoveryDialog::discard);
    connect(mList, &QTreeWidget::itemActivated, this, &RecoveryDialog::accept);
    fill();
    resizeOnScreen(*this, {720, 360});
}

void RecoveryDialog::fill()
{
    mList->clear();
    for (const RecoverableSession &session : mSessions) {
        const QFileInfo path(session.sessionPath);
        const QString model = QFileInfo(session.modelPath).fileName();
        const bool named = !session.sessionPath.isEmpty();
        auto *item = new QTreeWidgetItem(mList);
        item->setText(0, named             ? path.fileName()
                         : model.isEmpty() ? tr("Never saved")
                                           : tr("%1 (never saved)").arg(model));
        item->setText(1, QLocale().toString(session.savedAt, QLocale::ShortFormat));
        item->setText(2, QDir::toNativeSeparators(named             ? path.path()
                                                  : model.isEmpty() ? QString()
                                                                    : QFileInfo(session.modelPath).path()));
        item->setToolTip(2, item->text(2));
        item->setIcon(0, thumbnail(session, devicePixelRatioF()));
    }
    mList->resizeColumnToContents(0);
    mList->resizeColumnToContents(1);
    mList->setCurrentItem(mList->topLevelItem(0));
}

void RecoveryDialog::discard()
{
    const int row = currentRow();
    const QString name = mList->topLevelItem(row)->text(0);
    if (!mQuestions.confirm(tr("Discard what was recovered of %1?").arg(name),
                            tr("The changes since it was last saved by hand are lost."), tr("&Discard")))
        return;
    discardSession(mSessions[row]);
    mSessions.erase(mSessions.begin() + row);
    if (mSessions.empty())
        reject();
    else
        fill();
}

int RecoveryDialog::currentRow() const
{
    return std::max(0, mList->indexOfTopLevelItem(mList->currentItem()));
}

} // namespace autocuts
