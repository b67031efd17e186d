#include "views/ui/dialogsize.h"

#include <QLayout>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>

#include <algorithm>

namespace autocuts {

namespace {

constexpr QSize frame(24, 48); // more than window frames take

//! Wants as much room as its widget does.
class WholeScrollArea final : public QScrollArea
{
public:
    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override
    {
        // It is scrolled down before it is scrolled to the right.
        const int bar = verticalScrollBar()->sizeHint().width();
        return QScrollArea::minimumSizeHint().expandedTo(
            {std::min(widget()->minimumSizeHint().width() + bar, screen()->availableSize().width() / 2), 0});
    }
};

} // namespace

void resizeOnScreen(QWidget &window, const QSize &wanted)
{
    window.resize(wanted.boundedTo(window.screen()->availableSize() - frame));
}

void resizeToContent(QWidget &window)
{
    // The style sheet makes widgets larger once they are polished, at the latest when they are shown.
    for (QWidget *widget : window.findChildren<QWidget *>())
        widget->ensurePolished();
    for (QLayout *layout : window.findChildren<QLayout *>())
        layout->invalidate();
    QSize wanted = window.sizeHint();
    if (wanted.height() > window.screen()->availableSize().height() - frame.height())
        wanted.rwidth() += window.style()->pixelMetric(QStyle::PM_ScrollBarExtent); // it is scrolled
    resizeOnScreen(window, wanted);
}

QWidget *scrolled(QLayout *layout)
{
    auto *area = new WholeScrollArea;
    auto *content = new QWidget;
    layout->setContentsMargins(0, 0, 0, 0);
    content->setLayout(layout);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidgetResizable(true);
    area->setWidget(content);
    return area;
}

} // namespace autocuts
