// Packing into a box that is dragged.
#pragma once

#include "views/canvas/abstracttool.h"

#include <Eigen/Geometry>

#include <QPointer>

namespace autocuts {

class ToolCanvas;

//! A drag in the UV view draws a box, and the selected islands are packed into it; all islands when none is
//! selected. Ctrl snaps as when rectangles are drawn. The settings are those of the Packing panel.
class PackBoxTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit PackBoxTool(const StudioContext &context, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    bool isBusy() const override;
    void cancel() override;
    bool wantsPicks() const override { return false; }
    bool marksHover() const override { return false; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

private:
    //! The place under the mouse, snapped.
    Eigen::Vector2d placeOf(const ToolEvent &event) const;
    Eigen::AlignedBox2d box() const;

    QPointer<ToolCanvas> mView; //!< where the gesture began; null: none
    QPointF mPressed;
    Eigen::Vector2d mStart = Eigen::Vector2d::Zero(), mEnd = Eigen::Vector2d::Zero(); //!< texture space
};

} // namespace autocuts
