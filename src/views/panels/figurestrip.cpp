#include "views/panels/figurestrip.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace autocuts {

namespace {

constexpr int captionGap = 4, figureGap = 12, leftMargin = 8;

} // namespace

FigureStrip::FigureStrip(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
}

int FigureStrip::addFigure(const QString &caption, const QString &widest, const QString &tip)
{
    mFigures.push_back({caption, widest, tip, {}});
    updateGeometry();
    return static_cast<int>(mFigures.size()) - 1;
}

void FigureStrip::setFigure(int number, const QString &text, bool alert)
{
    Figure &figure = mFigures[number];
    if (figure.text == text && figure.alert == alert)
        return;
    const int before = widthOf(figure);
    figure.text = text;
    figure.alert = alert;
    if (widthOf(figure) != before)
        updateGeometry();
    update();
}

void FigureStrip::setShownCount(int count)
{
    if (count == mShown)
        return;
    mShown = count;
    updateGeometry();
    update();
}

std::span<const FigureStrip::Figure> FigureStrip::shown() const
{
    return std::span(mFigures).first(std::min<std::size_t>(mFigures.size(), mShown));
}

int FigureStrip::widthOf(const Figure &figure) const
{
    return fontMetrics().horizontalAdvance(figure.caption) + captionGap +
           std::max(fontMetrics().horizontalAdvance(figure.widest),
                    fontMetrics().horizontalAdvance(figure.text)) +
           figureGap;
}

int FigureStrip::visibleCount() const
{
    int used = leftMargin, count = 0;
    for (const Figure &figure : shown()) {
        used += widthOf(figure);
        if (used > width())
            break;
        ++count;
    }
    return count;
}

QSize FigureStrip::sizeHint() const
{
    int width = leftMargin;
    for (const Figure &figure : shown())
        width += widthOf(figure);
    return {width, fontMetrics().height()};
}

QSize FigureStrip::minimumSizeHint() const
{
    return {mFigures.empty() ? 0 : widthOf(mFigures.front()), fontMetrics().height()};
}

int FigureStrip::figureAt(int x) const
{
    const int count = visibleCount();
    x -= leftMargin;
    for (int i = 0; i < count; ++i) {
        x -= widthOf(mFigures[i]);
        if (x < 0)
            return i;
    }
    return -1;
}

bool FigureStrip::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        const int number = figureAt(help->pos().x());
        QToolTip::showText(help->globalPos(), number < 0 ? QString() : mFigures[number].tip, this);
        return true;
    }
    return QWidget::event(event);
}

void FigureStrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const bool dark = palette().color(QPalette::Window).lightnessF() < 0.5;
    const QColor plain = palette().color(QPalette::WindowText);
    QColor faint = plain;
    faint.setAlphaF(0.6f);
    const QColor alert = dark ? QColor(0xFF7A6B) : QColor(0xB3140A);
    int left = leftMargin;
    const int count = visibleCount();
    for (int i = 0; i < count; ++i) {
        const Figure &figure = mFigures[i];
        const int end = left + widthOf(figure) - figureGap;
        painter.setPen(faint);
        painter.drawText(QRect(left, 0, end - left, height()), Qt::AlignLeft | Qt::AlignVCenter,
                         figure.caption);
        painter.setPen(figure.alert ? alert : plain);
        const int valueLeft = left + fontMetrics().horizontalAdvance(figure.caption) + captionGap;
        painter.drawText(QRect(valueLeft, 0, end - valueLeft, height()), Qt::AlignLeft | Qt::AlignVCenter,
                         figure.text);
        left = end + figureGap;
    }
}

} // namespace autocuts
