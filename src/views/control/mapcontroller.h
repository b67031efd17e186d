// Work on whole maps off the GUI thread: unwrapping, finishing, packing, taking overlaps apart, measuring.
#pragma once

#include "model/plain/statetoken.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/unwrap.h"
#include "views/control/jobrunner.h"

#include <Eigen/Geometry>
#include <QList>
#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>

namespace autocuts {

class SolverController;
class Workspace;
struct MapInput;
struct MapJobResult;
struct PackTarget;

//! The document's map in figures.
struct MapFigures
{
    StateToken token; //!< of the state that was measured
    int textureSize = 0;
    metrics::UvMetrics metrics;
    std::vector<int> overlapping;                 //!< triangles that overlap another one, rising
    std::vector<std::array<int, 2>> overlapPairs; //!< of triangles, the largest area first
};

//! Which islands are packed; the others stay where they are and are obstacles.
enum class PackScope { All, Selection };

//! Starts jobs on copies of the document and pushes what they give as one command. A result is dropped, and
//! the user told, when the map was edited meanwhile. A live solve is paused first.
class MapController final : public QObject
{
    Q_OBJECT

public:
    MapController(Workspace &workspace, SolverController &solver, QObject *parent = nullptr);

    //! The job that runs, for progress and cancel.
    JobRunner &jobs() { return mJobs; }

    //! Of the document's map; null before they are measured for the first time, then those of the newest map
    //! that was measured.
    const MapFigures *figures() const { return mFigures ? &*mFigures : nullptr; }
    //! True while the figures are those of the document's map as it is.
    bool figuresAreFresh() const;

public Q_SLOTS:
    //! The whole automatic way (pipeline.h), as the command line does it.
    void unwrap(autocuts::unwrap::UnwrapQuality quality, double maxDistortion);
    //! Turns the live map, or else the document's, into a final one: definite seams, no overlaps.
    void finish(double maxDistortion);
    void pack(autocuts::PackScope scope);
    //! Packs the islands of the faces into a box instead of a tile; the others are obstacles.
    //! \param box texture space \param faces empty: those selected
    void packInto(const Eigen::AlignedBox2d &box, const QList<int> &faces = {});
    //! Cuts islands that cover themselves and packs.
    void separateOverlaps();
    //! Every island at the same texel density. \pre nothing runs
    void equalizeDensity();
    //! Makes the distortion of the selected faces small while all others stay. Pins and locks hold.
    void relaxSelection();
    //! Makes each chain of selected edges a straight line; the rest of its island follows.
    void straightenSelection();
    void cancel() { mJobs.cancel(); }

Q_SIGNALS:
    //! figures() or whether they are fresh.
    void figuresChanged();
    //! A job ended well. \param message translated, one line, for the status bar
    void done(const QString &message);
    //! A job could not do what was asked. \param message translated
    void failed(const QString &message);

private:
    MapInput input() const;
    void startJob(const QString &title, std::function<MapJobResult(const MapInput &, JobControl &)> work);
    void applyResult(const MapJobResult &result);
    void startPacking(const PackTarget &target);
    void measure();

    Workspace &mWorkspace;
    SolverController &mSolver;
    JobRunner mJobs;
    JobRunner mMeasuring;
    QTimer mMeasureSoon;
    std::optional<MapFigures> mFigures;
};

} // namespace autocuts
