// Keeps the figures of the document's map up to date.
#pragma once

#include "views/control/figures/mapfigures.h"
#include "views/control/session/jobrunner.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace autocuts {

class Workspace;
struct ChangeEvent;

//! Measures the document's map on another thread, a moment after it has changed.
class MapMeasuring final : public QObject
{
    Q_OBJECT

public:
    explicit MapMeasuring(Workspace &workspace, QObject *parent = nullptr);

    //! Of the newest measured map; null before the first measurement.
    const MapFigures *figures() const { return mFigures ? &*mFigures : nullptr; }
    //! True when the figures belong to the document's current map.
    bool areFresh() const;
    //! True when the change makes figures outdated.
    static bool dependOn(const ChangeEvent &event);

Q_SIGNALS:
    //! figures() changed, or whether they are fresh.
    void changed();
    //! \param message translated, one line
    void failed(const QString &message);

private:
    void measure();

    Workspace &mWorkspace;
    JobRunner mJobs;
    QTimer mSoon;
    std::optional<MapFigures> mFigures;
    int mFigureChanges = 0; //!< how often stacks, texel weights and the sharing of meshes changed
};

} // namespace autocuts
