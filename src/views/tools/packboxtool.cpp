#include "views/tools/packboxtool.h"

#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/selecting/selecting.h"
#include "views/tools/snapping.h"

#include <QPainter>

#include <cmath>
#include <numeric>

namespace autocuts {

PackBoxTool::PackBoxTool(const StudioContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("packBox"), parent)
{
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::hintChanged);
}

QString PackBoxTool::hint() const
{
    const Document *document = context().workspace.document();
    if (!document)
        return {};
    if (mView) {
        const Vec2 texels = box().sizes() * document->packingSettings().textureSize;
        return tr("Box of %1 \u00d7 %2 texels: release to pack, Escape: cancel")
            .arg(std::round(texels.x()))
            .arg(std::round(texels.y()));
    }
    return document->selection().isEmpty()
               ? tr("Pack into a box: drag a box in the UV view for all islands, Ctrl snaps to the grid")
               : tr("Pack into a box: drag a box in the UV view for the selected islands, Ctrl snaps to the "
                    "grid");
}

Eigen::Vector2d PackBoxTool::placeOf(const ToolEvent &event) const
{
    const MapCamera &camera = *mView->mapCamera();
    const PackingSettings &packing = context().workspace.document()->packingSettings();
    const Vec2 step = snapStep(snapOf(event.modifiers, context().view.tools().snap), camera, packing);
    return snappedPoint(camera.toUv(event.position), step);
}

Eigen::AlignedBox2d PackBoxTool::box() const
{
    return {Vec2(mStart.cwiseMin(mEnd)), Vec2(mStart.cwiseMax(mEnd))};
}

void PackBoxTool::press(const ToolEvent &event)
{
    if (mView && event.button == Qt::RightButton)
        cancel();
    auto *view = asMap(&event.canvas);
    if (event.button != Qt::LeftButton || mView || !view)
        return;
    mView = view;
    mPressed = event.position;
    mStart = mEnd = placeOf(event);
}

void PackBoxTool::move(const ToolEvent &event)
{
    if (!mView || &event.canvas != mView)
        return;
    mEnd = placeOf(event);
    Q_EMIT overlayChanged();
    Q_EMIT hintChanged();
}

void PackBoxTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || !mView || &event.canvas != mView)
        return;
    mEnd = placeOf(event);
    const Eigen::AlignedBox2d drawn = box();
    const QPointF way = event.position - mPressed;
    cancel();
    if (std::hypot(way.x(), way.y()) < dragDistance || !(drawn.sizes().minCoeff() > 0))
        return;
    const Document &document = *context().workspace.document();
    QList<int> faces = facesOf(document, document.selection());
    if (faces.isEmpty())
        faces = everything(document, SelectionMode::Faces).faces;
    context().map.packInto(drawn, faces);
}

bool PackBoxTool::isBusy() const
{
    return !mView.isNull();
}

void PackBoxTool::cancel()
{
    mView = nullptr;
    Q_EMIT overlayChanged();
    Q_EMIT hintChanged();
}

void PackBoxTool::drawOverlay(QPainter &painter, const ToolCanvas &canvas)
{
    if (!mView || &canvas != mView)
        return;
    const QColor color = canvas.content().colors().selection;
    QColor fill = color;
    fill.setAlphaF(0.12f);
    painter.setPen(QPen(color, 1, Qt::DashLine));
    painter.setBrush(fill);
    const MapCamera &camera = *mView->mapCamera();
    painter.drawRect(QRectF(camera.toScreen(mStart), camera.toScreen(mEnd)).normalized());
}

} // namespace autocuts
