// The tool for painting texel weights.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/brush.h"
#include "views/tools/toolcoloring.h"

#include <QPointer>

#include <vector>

namespace autocuts {

//! Paints how many times the texels per length faces are to have, on the model and in the map. One stroke is
//! one undo entry. Within a stroke, a face comes as near to the weight of the brush as its strength there
//! says, however often it is crossed; the next stroke goes on from there. While the tool is active, the faces
//! show the weights.
class TexelTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit TexelTool(const StudioContext &context, QObject *parent = nullptr);

    const Brush &brush() const { return mBrush; }
    double weight() const { return mWeight; }
    //! True when the mirror images of faces, in the plane x = 0, are painted too.
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
    //! The weight for these modifiers: Shift goes back to 1, Ctrl is the inverse.
    double weightFor(Qt::KeyboardModifiers modifiers) const;
    void tellSettings();
    void setSymmetric(bool symmetric);
    int mirrored(int face);
    void showBrush(const ToolEvent &event);
    void strokeTo(const ToolEvent &event);
    //! Adds the paint of some brush dabs.
    void lay(const std::vector<FaceTouch> &touches);

    Brush mBrush;
    double mWeight = 2, mShown = 2; //!< the chosen weight, and that with the modifiers
    QPointer<ToolCanvas> mCanvas;   //!< the canvas under the mouse
    QPointF mMouse;
    bool mSymmetric = false;
    std::vector<int> mMirror; //!< of the faces of the open model; made when needed
    ToolColoring mColoring;

    // State of the stroke.
    quint64 mGesture = 0;
    double mStroke = 1;
    std::vector<double> mBase;   //!< weights of all faces before the stroke
    std::vector<double> mEffect; //!< per face, the paint it got
};

} // namespace autocuts
