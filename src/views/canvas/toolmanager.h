// The tools and which of them is active.
#pragma once

#include "views/canvas/abstracttool.h"

#include <QObject>
#include <QPointer>

#include <memory>
#include <vector>

namespace autocuts {

//! Owns the tools; one is active at any time, the selection tool at first.
class ToolManager final : public QObject
{
    Q_OBJECT

public:
    explicit ToolManager(const StudioContext &context, QObject *parent = nullptr);
    ~ToolManager() override;

    //! Adds a tool. \pre no other has its id
    void add(std::unique_ptr<AbstractTool> tool);
    //! Ends the gesture of the active tool and activates another. Unknown ids are ignored.
    void setTool(const QString &id);
    //! As setTool(), by the user's key or button: the tool may begin at once where the mouse is.
    void choose(const QString &id);
    //! Where the mouse is now. \param canvas null: over none
    void setMouse(ToolCanvas *canvas, const QPointF &position);
    AbstractTool *tool() const { return mActive; }

Q_SIGNALS:
    void toolChanged();
    //! \param hint of the active tool
    void hintChanged(const QString &hint);
    //! What the active tool draws.
    void overlayChanged();

private:
    std::vector<std::unique_ptr<AbstractTool>> mTools;
    AbstractTool *mActive = nullptr;
    QPointer<ToolCanvas> mMouseCanvas; //!< that the mouse is over
    QPointF mMouse;
};

} // namespace autocuts
