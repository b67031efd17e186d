// The interface of the views for tools.
#pragma once

#include "views/canvas/picking.h"

#include <QOpenGLWidget>

#include <optional>

namespace autocuts {

class MapCamera;
class SceneContent;
struct StudioContext;

//! What tools see of a view. Screen coordinates are logical pixels from the upper left.
class ToolCanvas : public QOpenGLWidget
{
    Q_OBJECT

public:
    enum class Kind { Model, Map };

    Kind kind() const { return mKind; }
    const StudioContext &studio() const { return mStudio; }
    //! The arrays that are drawn; for picking and measuring.
    virtual const SceneContent &content() const = 0;
    //! The camera of the UV view; null in the 3D view.
    virtual const MapCamera *mapCamera() const { return nullptr; }

    //! The elements at a pixel, including changes that have not been painted yet.
    virtual PickResult pick(const QPointF &pixel) const = 0;
    virtual BoxPick pickBox(const PickRegion &region) const = 0;
    //! The triangles that a click can reach at a pixel, the front-most first: more than one while one sees
    //! through the model.
    virtual std::vector<int> trianglesAt(const QPointF &pixel) const
    {
        const int triangle = pick(pixel).triangle;
        return triangle < 0 ? std::vector<int>() : std::vector<int>{triangle};
    }
    //! The position at which a soup corner is drawn; nothing when it is not drawn.
    virtual std::optional<QPointF> screenOf(int soupCorner) const = 0;

protected:
    ToolCanvas(Kind kind, const StudioContext &studio, QWidget *parent)
        : QOpenGLWidget(parent), mKind(kind), mStudio(studio)
    {}

private:
    const Kind mKind;
    const StudioContext mStudio;
};

//! The canvas when it is the UV view, null otherwise.
template <class AnyCanvas>
AnyCanvas *asMap(AnyCanvas *canvas)
{
    return canvas && canvas->kind() == ToolCanvas::Kind::Map ? canvas : nullptr;
}

} // namespace autocuts
