// The tool for packing islands into a box.
#pragma once

#include "views/canvas/abstracttool.h"

#include <Eigen/Geometry>

#include <QPointer>

namespace autocuts {

class ToolCanvas;

//! A drag in the UV view draws a box into which the selected islands are packed, or all islands when none is
//! selected. Ctrl snaps as when drawing rectangles. The settings are those of the Packing panel.
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
    //! The snapped position of the mouse.
    Eigen::Vector2d placeOf(const ToolEvent &event) const;
    Eigen::AlignedBox2d box() const;

    QPointer<ToolCanvas> mView; //!< the view in which the gesture began; null: none
    QPointF mPressed;
    Eigen::Vector2d mStart = Eigen::Vector2d::Zero(), mEnd = Eigen::Vector2d::Zero(); //!< texture space
};

} // namespace autocuts
