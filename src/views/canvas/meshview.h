// The 3D view.
#pragma once

#include "views/canvas/canvas.h"
#include "views/canvas/meshpicker.h"
#include "views/canvas/orbitcamera.h"

namespace autocuts {

struct SoupDrawing;

//! Shows the model.
class MeshView final : public Canvas
{
    Q_OBJECT

public:
    MeshView(const StudioContext &context, ToolManager &tools, QWidget *parent = nullptr);
    ~MeshView() override;

    const OrbitCamera &camera() const { return mCamera; }
    void setCamera(const OrbitCamera &camera);
    //! Shows the model straight from a side.
    void lookFrom(ViewSide side);

    PickResult pick(const QPointF &pixel) const override;
    BoxPick pickBox(const PickRegion &region) const override;
    std::vector<int> trianglesAt(const QPointF &pixel) const override;
    std::optional<QPointF> screenOf(int soupCorner) const override;
    void frameAll() override;
    void frameSelection() override;
    QCborMap viewState() const override;
    void restoreViewState(const QCborMap &state) override;

protected:
    void drawScene(GlResources &gl) override;
    void drawOverlay(QPainter &painter) override;
    void navigate(Navigation navigation, const QPointF &pixels, const QPointF &start) override;
    void zoomAt(double factor, const QPointF &pixel) override;
    bool overlayTakes(const QPointF &pixel, bool pressed) override;
    void viewResized() override;
    void documentReplaced() override;

private:
    const MeshPicker &picker() const;
    bool isXray() const { return studio().view.options().xray; }
    void drawModel(GlResources &gl, SoupDrawing drawing);
    void frameCorners(const std::vector<int> &soupCorners);

    OrbitCamera mCamera;
    std::optional<ViewSide> mHoveredAxis;              //!< the end of the axis gizmo under the mouse
    mutable std::unique_ptr<const MeshPicker> mPicker; //!< for mPickerMesh without mPickerHidden
    mutable const MeshData *mPickerMesh = nullptr;
    mutable QList<int> mPickerHidden;
};

} // namespace autocuts
