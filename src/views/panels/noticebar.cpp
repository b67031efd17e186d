#include "views/panels/noticebar.h"

#include "model/document/document.h"
#include "views/control/session/workspace.h"
#include "views/ui/icons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

NoticeBar::NoticeBar(Workspace &workspace, QWidget *parent)
    : QFrame(parent), mWorkspace(workspace), mText(new QLabel), mSelect(new QToolButton),
      mClose(new QToolButton)
{
    setObjectName("noticeBar"_L1);
    setFrameShape(QFrame::StyledPanel);
    mText->setObjectName("noticeText"_L1);
    mText->setWordWrap(true);
    mText->setTextInteractionFlags(Qt::TextSelectableByMouse);
    mSelect->setObjectName("noticeSelect"_L1);
    mSelect->setText(tr("Select them"));
    mSelect->setToolTip(tr("Select what the message is about"));
    mClose->setObjectName("noticeClose"_L1);
    mClose->setIcon(icon(u"cancel"_s));
    mClose->setToolTip(tr("Close this message"));
    mClose->setAutoRaise(true);
    auto *picture = new QLabel;
    picture->setPixmap(coloredIcon(u"dialog-warning"_s).pixmap(fontMetrics().height()));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 4, 4);
    row->addWidget(picture);
    row->addWidget(mText, 1);
    row->addWidget(mSelect);
    row->addWidget(mClose);
    connect(mSelect, &QToolButton::clicked, this, &NoticeBar::selectItems);
    connect(mClose, &QToolButton::clicked, this, [this] { showNotice({}); });
    connect(&workspace, &Workspace::documentReplaced, this, [this] { showNotice({}); });
    setAutoFillBackground(true);
    if (parent)
        parent->installEventFilter(this);
    hide();
}

//! Lies over the bottom of what it belongs to, which keeps its place and size: its controls are at the top.
void NoticeBar::place()
{
    if (!parentWidget() || isHidden()) {
        Q_EMIT placed();
        return;
    }
    const int width = parentWidget()->width();
    const int height = hasHeightForWidth() ? heightForWidth(width) : sizeHint().height();
    setGeometry(0, parentWidget()->height() - height, width, height);
    raise();
    Q_EMIT placed();
}

bool NoticeBar::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void NoticeBar::showNotice(const QString &message, const Selection &items)
{
    mText->setText(message);
    mItems = items;
    mSelect->setVisible(!items.isEmpty());
    setVisible(!message.isEmpty());
    place();
}

QString NoticeBar::message() const
{
    return mText->text();
}

void NoticeBar::selectItems()
{
    if (Document *document = mWorkspace.document())
        document->setSelection(mItems);
}

} // namespace autocuts
