#include "views/shell/startpage.h"

#include "model/io/projects/projectfile.h"
#include "views/actions/actionregistry.h"
#include "views/control/files/filecontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/ui/icons.h"
#include "views/ui/preferences.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>

#include <vector>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QSize thumbnailSize(72, 54);
constexpr int widest = 820, mostFiles = 8;
constexpr const char *samples[] = {"file.sample.bumpycube", "file.sample.character", "file.sample.torus",
                                   "file.sample.machine"};

//! A recent file as it was found on the disk.
struct RecentFile
{
    QString path;
    QImage thumbnail; //!< null without one
};

std::vector<RecentFile> findFiles(const QStringList &paths, const std::atomic<bool> &stop)
{
    std::vector<RecentFile> files;
    for (const QString &path : paths) {
        if (stop || static_cast<int>(files.size()) == mostFiles)
            break;
        if (!QFileInfo::exists(path))
            continue;
        files.push_back({path, {}});
        if (!isProjectPath(path))
            continue;
        if (const Result<ProjectSummary> summary = loadProjectSummary(path))
            files.back().thumbnail = QImage::fromData(summary->thumbnail);
    }
    return files;
}

//! The thumbnail, or the program's picture of a model, in the middle of a box.
QPixmap pictureOf(const RecentFile &file, double scale)
{
    QPixmap picture(thumbnailSize * scale);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    if (file.thumbnail.isNull()) {
        icon(u"mode-islands"_s).paint(&painter, QRect(QPoint(20, 11), QSize(32, 32)));
        return picture;
    }
    const QSize size = file.thumbnail.size().scaled(thumbnailSize, Qt::KeepAspectRatio);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRect(QPoint((thumbnailSize.width() - size.width()) / 2,
                                   (thumbnailSize.height() - size.height()) / 2),
                            size),
                      file.thumbnail);
    return picture;
}

} // namespace

StartPage::StartPage(const StudioContext &context, QWidget *parent)
    : QWidget(parent), mContext(context), mRecentTitle(new QLabel(tr("Recent"))), mRecent(new QListWidget)
{
    setObjectName("startPage"_L1);
    setAutoFillBackground(true);
    auto *title = new QLabel(tr("Autocuts"));
    QFont large = title->font();
    large.setPointSizeF(2.2 * large.pointSizeF());
    large.setBold(true);
    title->setFont(large);
    QLabel *const line = makeRemark(tr("UV maps whose cuts and distortion are optimised together"));
    auto *columns = new QHBoxLayout;
    columns->setSpacing(32);
    columns->addWidget(makeOpening(), 2);
    columns->addWidget(makeRecent(), 3);
    auto *page = new QWidget;
    page->setMaximumWidth(widest);
    auto *rows = new QVBoxLayout(page);
    rows->addWidget(title);
    rows->addWidget(line);
    rows->addSpacing(16);
    rows->addLayout(columns, 1);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->addStretch(1);
    layout->addWidget(page, 1000);
    layout->addStretch(1);
    parent->installEventFilter(this);
    connect(&context.workspace, &Workspace::documentReplaced, this, &StartPage::showOrHide);
    connect(&context.preferences, &Preferences::recentFilesChanged, this, &StartPage::showRecent);
    showOrHide();
}

QWidget *StartPage::makeOpening()
{
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char *id, bool primary) {
        QAction *const action = mContext.actions.action(id);
        QPushButton *const button = makeButton(
            primary ? tr("Open a model or a session...") : action->iconText(), QLatin1StringView(id));
        button->setProperty("primary", primary);
        button->setIcon(primary ? accentIcon(QStringLiteral("open")) : action->icon());
        button->setMinimumWidth(button->minimumWidth() + (primary ? 60 : 0));
        button->setToolTip(action->toolTip());
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        layout->addWidget(button);
    };
    add("file.open", true);
    layout->addWidget(makeRemark(tr("or drop a file on the window")));
    layout->addSpacing(12);
    layout->addWidget(makeHeading(tr("Samples")));
    for (const char *id : samples)
        add(id, false);
    layout->addStretch(1);
    return box;
}

QWidget *StartPage::makeRecent()
{
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    QFont bold = mRecentTitle->font();
    bold.setBold(true);
    mRecentTitle->setFont(bold);
    mRecent->setObjectName("recentFiles"_L1);
    mRecent->setAccessibleName(tr("Recent files"));
    mRecent->setIconSize(thumbnailSize);
    mRecent->setFrameShape(QFrame::NoFrame);
    mRecent->setUniformItemSizes(true);
    layout->addWidget(mRecentTitle);
    layout->addWidget(mRecent, 1);
    const auto open = [this](const QListWidgetItem *item) {
        if (!mContext.files.jobs().isBusy()) // the second click of two
            Q_EMIT openRequested(item->data(Qt::UserRole).toString());
    };
    connect(mRecent, &QListWidget::itemClicked, this, open);
    connect(mRecent, &QListWidget::itemActivated, this, open);
    return box;
}

void StartPage::showOrHide()
{
    const bool show = mContext.workspace.document() == nullptr;
    if (show) {
        setGeometry(parentWidget()->rect());
        raise();
        showRecent();
    }
    setVisible(show);
}

//! Looks at the files on another thread: a folder may be slow.
void StartPage::showRecent()
{
    mReading.abandon();
    mReading.start(
        tr("Reading recent files"),
        [paths = mContext.preferences.recentFiles()](JobControl &job) {
            return findFiles(paths, job.stop());
        },
        [this](const std::vector<RecentFile> &files) {
            mRecent->clear();
            for (const RecentFile &file : files) {
                const QFileInfo info(file.path);
                auto *item = new QListWidgetItem(
                    pictureOf(file, devicePixelRatioF()),
                    info.fileName() + u'\n' + QDir::toNativeSeparators(info.absolutePath()), mRecent);
                item->setData(Qt::UserRole, file.path);
                item->setToolTip(QDir::toNativeSeparators(file.path));
            }
            mRecentTitle->setVisible(!files.empty());
            mRecent->setVisible(!files.empty());
        });
}

bool StartPage::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

} // namespace autocuts
