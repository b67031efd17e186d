// Painting where seams are welcome and where not.
#pragma once

#include "model/plain/types.h"
#include "views/canvas/abstracttool.h"
#include "views/tools/brush.h"
#include "views/tools/mirrorededges.h"

#include <QPointer>

#include <memory>
#include <optional>
#include <vector>

namespace autocuts {

//! What the brush lays on.
enum class Paint { KeepTogether, AttractCuts, Erase };

//! A brush for the painted weights of the seams (paper, figure 6), on the model and in the map. One stroke is
//! one undo entry, and within it no edge gets more than the brush has, however often it is crossed; the next
//! stroke goes on from there. While the tool is active the faces show the weights.
class PaintTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit PaintTool(const StudioContext &context, QObject *parent = nullptr);

    const Brush &brush() const { return mBrush; }
    Paint paint() const { return mPaint; }
    //! Edges get their mirror images' paint too, about the plane x = 0.
    bool isSymmetric() const { return mSymmetric; }

    QString hint() const override;
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
    //! By the modifiers: Shift erases, Ctrl does the contrary.
    Paint paintFor(Qt::KeyboardModifiers modifiers) const;
    void showBrush(const ToolEvent &event);
    void strokeTo(const ToolEvent &event);
    //! Adds the paint of some dabs.
    void lay(const std::vector<BrushTouch> &touches);
    int mirrored(int edgePair);

    Brush mBrush;
    Paint mPaint = Paint::KeepTogether, mShown = Paint::KeepTogether; //!< chosen; with the modifiers
    bool mSymmetric = false;
    std::optional<MirroredEdges> mMirror; //!< of the open model, once needed
    QPointer<ToolCanvas> mCanvas;         //!< that the mouse is over
    QPointF mMouse;
    bool mColored = false; //!< the colouring was changed by this tool

    // The stroke.
    quint64 mGesture = 0;
    Paint mStroke = Paint::KeepTogether;
    std::vector<double> mBase;   //!< weights of all corner pairs before it
    std::vector<double> mEffect; //!< per edge pair, how much paint it got
};

} // namespace autocuts
