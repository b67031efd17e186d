// Manages the tools and which of them is active.
#pragma once

#include "views/canvas/abstracttool.h"

#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

namespace autocuts {

//! Owns the tools. One of them is active at any time; the selection tool at first.
class ToolManager final : public QObject
{
    Q_OBJECT

public:
    explicit ToolManager(const StudioContext &context, QObject *parent = nullptr);
    ~ToolManager() override;

    //! Adds a tool. \pre no other tool has its id
    void add(std::unique_ptr<AbstractTool> tool);
    //! Ends the gesture of the active tool and activates another tool. Unknown ids are ignored.
    void setTool(const QString &id);
    //! As setTool(), for the user's key or button: the tool may start a gesture where the mouse is.
    void choose(const QString &id);
    //! Stores the mouse position. \param canvas null when the mouse is over no canvas
    void setMouse(ToolCanvas *canvas, const QPointF &position);
    AbstractTool *tool() const { return mActive; }
    //! False when the active tool may not begin a gesture at the moment.
    bool mayBegin() const;

Q_SIGNALS:
    void toolChanged();
    //! \param hint hint of the active tool
    void hintChanged(const QString &hint);
    //! Emitted when the active tool's overlay changes.
    void overlayChanged();

private:
    const MapController &mMap;
    std::vector<std::unique_ptr<AbstractTool>> mTools;
    AbstractTool *mActive = nullptr;
    QPointer<ToolCanvas> mMouseCanvas; //!< the canvas under the mouse
    QPointF mMouse;
};

} // namespace autocuts
