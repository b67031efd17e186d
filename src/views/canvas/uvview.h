// The UV view.
#pragma once

#include "model/plain/packingsettings.h"
#include "model/plain/statetoken.h"
#include "views/canvas/canvas.h"
#include "views/canvas/mapcamera.h"

#include <QTimer>
#include <functional>

namespace autocuts {

struct MapScene;
struct PaperDrawing;

//! Shows the map in texture space, with v pointing up.
class UvView final : public Canvas
{
    Q_OBJECT

public:
    UvView(const StudioContext &context, ToolManager &tools, QWidget *parent = nullptr);
    ~UvView() override;

    const MapCamera &camera() const { return mCamera; }
    const MapCamera *mapCamera() const override { return &mCamera; }
    void setCamera(const MapCamera &camera);

    PickResult pick(const QPointF &pixel) const override;
    BoxPick pickBox(const PickRegion &region) const override;
    std::optional<QPointF> screenOf(int soupCorner) const override;
    void frameAll() override;
    void frameSelection() override;
    QCborMap viewState() const override;
    void restoreViewState(const QCborMap &state) override;
    //! Gives the line that is shown while there is no map, translated.
    void setEmptyHint(std::function<QString()> hint) { mEmptyHint = std::move(hint); }

protected:
    void drawScene(GlResources &gl) override;
    bool showGradually(GlResources &gl) override;
    void workOn() override;
    void drawOverlay(QPainter &painter) override;
    void navigate(Navigation navigation, const QPointF &pixels, const QPointF &start) override;
    void zoomAt(double factor, const QPointF &pixel) override;
    void viewResized() override;
    void documentReplaced() override;

private:
    //! The texture of the document, or of new sessions.
    PackingSettings packing() const;
    int shownChannel() const;
    PaperDrawing paper(GlResources &gl) const;
    MapScene scene(GlResources &gl) const;
    std::vector<std::pair<int, QColor>> tilesInUse() const;
    void frameIfLost();
    //! What the rulers cover.
    QMarginsF covered() const;

    std::function<QString()> mEmptyHint;
    MapCamera mCamera;
    QTimer mSizeSettles;    //!< runs while the view gets one size after another
    bool mFramesAll = true; //!< shows everything, also when its size changes, until the camera is moved
    bool mWasLive = false;  //!< ShownMap::isLive() at its last change
    StateToken mJobsBegin;  //!< of the document when the last job began
};

} // namespace autocuts
