// The base class of the tools that paint weights.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/brush.h"
#include "views/tools/toolcoloring.h"

#include <QPointer>

#include <map>
#include <memory>
#include <vector>

namespace autocuts {

class Document;
class DocumentCommand;
struct MeshData;
struct ViewColors;

//! Paints weights of edges or faces, the elements, on the model and in the map. One stroke is one undo entry.
//! Within a stroke, an element gets at most the strength of the brush, however often it is crossed; the next
//! stroke adds to that. While the tool is active, the faces show the weights.
//!
//! A derived class has an effect that the user chooses and that modifiers change for one stroke.
class WeightTool : public AbstractTool
{
    Q_OBJECT

public:
    const Brush &brush() const { return mBrush; }
    //! True when the mirror images of elements, in the plane x = 0, are painted too.
    bool isSymmetric() const { return mSymmetric; }

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

protected:
    WeightTool(const StudioContext &context, const QString &id, Coloring coloring, QObject *parent);

    //! Makes the effect for these modifiers the current one. Not called during a stroke.
    virtual void takeModifiers(Qt::KeyboardModifiers modifiers) = 0;
    //! Remembers the weights of all elements; returns their number.
    virtual std::size_t beginStroke(const Document &document) = 0;
    virtual std::vector<BrushTouch> touched(const ToolCanvas &canvas, const QPointF &middle,
                                            const PickResult &pick) const = 0;
    //! For each element its mirror image, or -1.
    virtual std::vector<int> mirrorImages(const MeshData &mesh) const = 0;
    //! Brings elements from their weights before the stroke nearer to the current effect. \param shares how
    //! much nearer, by element; 1 is all the way
    virtual std::unique_ptr<DocumentCommand> commandFor(Document &document,
                                                        const std::map<int, double> &shares) const = 0;
    //! The tool option for the effect.
    virtual ToolOption effectOption() = 0;
    //! Of the current effect.
    virtual QString effectText() const = 0;
    virtual QColor effectColor(const ViewColors &colors) const = 0;

    //! To be called after a change of the effect.
    void tellSettings();

private:
    void setSymmetric(bool symmetric);
    void showBrush(const ToolEvent &event);
    void strokeTo(const ToolEvent &event);
    //! Adds the paint of some brush dabs.
    void lay(const std::vector<BrushTouch> &touches);
    int mirrored(int element);

    Brush mBrush;
    bool mSymmetric = false;
    std::vector<int> mMirror;     //!< of the elements of the open model; made when needed
    QPointer<ToolCanvas> mCanvas; //!< the canvas under the mouse
    QPointF mMouse;
    ToolColoring mColoring;

    // State of the stroke.
    quint64 mGesture = 0;
    std::vector<double> mShares; //!< per element, how much of the effect it got
};

} // namespace autocuts
