// What a tool sees of a view.
#pragma once

#include "views/canvas/picking.h"

#include <QOpenGLWidget>

#include <optional>

namespace autocuts {

class MapCamera;
class SceneContent;
struct StudioContext;

//! The interface of the views for tools. Screen coordinates are logical pixels from the upper left.
class ToolCanvas : public QOpenGLWidget
{
    Q_OBJECT

public:
    enum class Kind { Model, Map };

    Kind kind() const { return mKind; }
    const StudioContext &studio() const { return mStudio; }
    //! What is drawn; for picking and measuring.
    virtual const SceneContent &content() const = 0;
    //! Of the UV view; null in the 3D view.
    virtual const MapCamera *mapCamera() const { return nullptr; }

    //! What is at a place; also sees what is not painted yet.
    virtual PickResult pick(const QPointF &pixel) const = 0;
    virtual BoxPick pickBox(const PickRegion &region) const = 0;
    //! Where a soup corner is drawn; nothing when it has no place.
    virtual std::optional<QPointF> screenOf(int soupCorner) const = 0;

protected:
    ToolCanvas(Kind kind, const StudioContext &studio, QWidget *parent)
        : QOpenGLWidget(parent), mKind(kind), mStudio(studio)
    {}

private:
    const Kind mKind;
    const StudioContext mStudio;
};

//! The canvas when it is the UV view, else null.
template <class AnyCanvas>
AnyCanvas *asMap(AnyCanvas *canvas)
{
    return canvas && canvas->kind() == ToolCanvas::Kind::Map ? canvas : nullptr;
}

} // namespace autocuts
