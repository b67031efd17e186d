#include "views/control/figures/mapmeasuring.h"

#include "model/document/uvsetorder.h"
#include "views/control/session/workspace.h"

#include <utility>

namespace autocuts {

namespace {

//! Milliseconds without an edit after which the map is measured. Chosen by hand.
constexpr int measureDelay = 250;

//! Not all of the document: it is copied after each edit.
MeasuredModel modelToMeasure(const Document &document)
{
    MeasuredModel model{document.state().scene, document.marks().faceFlags, document.packingSettings(),
                        document.weightedMesh()};
    putFirst(model.scene.uvSets, document.activeUvSet());
    return model;
}

//! The figures depend on what changed, though the map is the same.
bool changesFigures(const ChangeEvent &event)
{
    using Type = ChangeEvent::Type;
    return (event.type == Type::IslandFlag &&
            (static_cast<const IslandFlagEvent &>(event).properties & IslandFlagEvent::Stack)) ||
           event.type == Type::TexelWeight || event.type == Type::SharedMeshes;
}

} // namespace

MapMeasuring::MapMeasuring(Workspace &workspace, QObject *parent) : QObject(parent), mWorkspace(workspace)
{
    mSoon.setSingleShot(true);
    mSoon.setInterval(measureDelay);
    connect(&mSoon, &QTimer::timeout, this, &MapMeasuring::measure);
    connect(&mJobs, &JobRunner::failed, this, &MapMeasuring::failed);
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        mJobs.abandon();
        mFigures.reset();
        mSoon.start();
        Q_EMIT changed();
    });
    connect(&workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        mFigureChanges += changesFigures(event);
        if (!dependOn(event))
            return;
        mSoon.start();
        Q_EMIT changed();
    });
}

bool MapMeasuring::dependOn(const ChangeEvent &event)
{
    const bool textureSize =
        event.type == ChangeEvent::Type::PackingSettings &&
        (static_cast<const PackingSettingsEvent &>(event).properties & TextureSizeProperty);
    return textureSize || changesFigures(event) || event.type == ChangeEvent::Type::Uv ||
           event.type == ChangeEvent::Type::UvSet;
}

bool MapMeasuring::areFresh() const
{
    return mFigures && mWorkspace.hasMapOf(mFigures->token) && mFigures->figureChanges == mFigureChanges &&
           mFigures->textureSize == mWorkspace.document()->packingSettings().textureSize &&
           mFigures->textureHeight == mWorkspace.document()->packingSettings().height();
}

void MapMeasuring::measure()
{
    mJobs.abandon(); // the map or the texture size that is being measured is outdated
    const Document *document = mWorkspace.document();
    if (!document || areFresh())
        return;
    mJobs.start(
        tr("Measuring"),
        [model = modelToMeasure(*document)](JobControl &control) { return measuredMap(model, control); },
        [this, token = document->token(), figureChanges = mFigureChanges](MapFigures figures) {
            mFigures = std::move(figures);
            mFigures->token = token;
            mFigures->figureChanges = figureChanges;
            Q_EMIT changed();
        });
}

} // namespace autocuts
