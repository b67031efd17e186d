// The graph of a running solve: distortion and separation by iteration, or of each definite map.
#pragma once

#include "views/control/live/solvercontroller.h"
#include "views/panels/graphaxis.h"

#include <QWidget>

#include <vector>

namespace autocuts {

//! Shows D on the left axis, S on the right axis, and delta, where there is one, as steps in the background.
//! The values of one iteration are shown for the mouse position or for a mark that Left and Right move. Each
//! curve is drawn with at most one vertical line per pixel column, whatever the number of points.
class ConvergenceGraph final : public QWidget
{
    Q_OBJECT

public:
    explicit ConvergenceGraph(QWidget *parent = nullptr);

    //! \param trace ascending by iteration
    void setTrace(const std::vector<live::TracePoint> &trace);
    const std::vector<live::TracePoint> &trace() const { return mTrace; }

    //! The point whose values are shown; null when there is none.
    const live::TracePoint *marked() const;

    QSize sizeHint() const override { return {250, 160}; }
    QSize minimumSizeHint() const override { return {180, 120}; }

Q_SIGNALS:
    void markChanged();

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    struct Colors;
    //! Smallest, largest and last value of the points in one pixel column.
    struct Column
    {
        int x = 0;
        float low = 0, high = 0, last = 0;
    };

    Colors colors() const;
    bool hasDelta() const;
    QRectF plotRect() const;
    double xOf(int iteration, const QRectF &plot) const;
    std::vector<Column> columns(float live::TracePoint::*field, const QRectF &plot) const;
    void setMark(int index);
    void drawFrame(QPainter &painter, const QRectF &plot, const Colors &colors) const;
    void drawDelta(QPainter &painter, const QRectF &plot, const Colors &colors) const;
    void drawCurve(QPainter &painter, const QRectF &plot, float live::TracePoint::*field,
                   const GraphAxis &axis, const QColor &color) const;
    void drawLegend(QPainter &painter, const QRectF &plot, const Colors &colors) const;
    void drawMark(QPainter &painter, const QRectF &plot, const Colors &colors) const;

    std::vector<live::TracePoint> mTrace;
    GraphAxis mDistortionAxis, mSeparationAxis, mDeltaAxis;
    int mMark = -1; //!< index into mTrace
};

} // namespace autocuts
