// The tool for painting seam weights.
#pragma once

#include "model/plain/types.h"
#include "views/canvas/abstracttool.h"
#include "views/tools/brush.h"
#include "views/tools/toolcoloring.h"

#include <QPointer>

#include <memory>
#include <vector>

namespace autocuts {

//! The effect of the brush.
enum class Paint { KeepTogether, AttractCuts, Erase };

//! Paints weights of seams (paper, section 4, "Assisted cutting") on the model and in the map. One stroke is
//! one undo entry. Within a stroke, an edge gets at most the strength of the brush, however often it is
//! crossed; the next stroke adds to that. While the tool is active, the faces show the weights.
class PaintTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit PaintTool(const StudioContext &context, QObject *parent = nullptr);

    const Brush &brush() const { return mBrush; }
    Paint paint() const { return mPaint; }
    //! True when the mirror images of edges, in the plane x = 0, are painted too.
    bool isSymmetric() const { return mSymmetric; }

    QString hint() const override;
    std::vector<ToolOption> options() override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void activate() override;
    void deactivate() override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    void leave() override;
    bool wantsKey(const QKeyEvent &event) const override;
    bool keyPress(const QKeyEvent &event, ToolCanvas &canvas) override;
    bool wheel(const QWheelEvent &event, ToolCanvas &canvas) override;
    bool isBusy() const override { return mGesture != 0; }
    void cancel() override;
    bool marksHover() const override { return false; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

private:
    //! The effect for these modifiers: Shift erases, Ctrl reverses the effect.
    Paint paintFor(Qt::KeyboardModifiers modifiers) const;
    void setPaint(Paint paint);
    void setSymmetric(bool symmetric);
    void tellSettings();
    void showBrush(const ToolEvent &event);
    void strokeTo(const ToolEvent &event);
    //! Adds the paint of some brush dabs.
    void lay(const std::vector<BrushTouch> &touches);
    int mirrored(int edgePair);

    Brush mBrush;
    //! The chosen effect, and that with the modifiers.
    Paint mPaint = Paint::KeepTogether, mShown = Paint::KeepTogether;
    bool mSymmetric = false;
    std::vector<int> mMirror;     //!< of the edge pairs of the open model; made when needed
    QPointer<ToolCanvas> mCanvas; //!< the canvas under the mouse
    QPointF mMouse;
    ToolColoring mColoring;

    // State of the stroke.
    quint64 mGesture = 0;
    Paint mStroke = Paint::KeepTogether;
    std::vector<double> mBase;   //!< weights of all corner pairs before the stroke
    std::vector<double> mEffect; //!< per edge pair, the paint it got
};

} // namespace autocuts
