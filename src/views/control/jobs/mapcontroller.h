// Starts jobs on whole maps off the GUI thread: unwrapping, finishing, packing, separating overlaps,
// measuring.
#pragma once

#include "model/document/selection.h"
#include "solver/unwrap/seamprices.h"
#include "solver/unwrap/unwrapquality.h"
#include "views/control/figures/mapmeasuring.h"
#include "views/control/jobs/jobpreview.h"
#include "views/control/session/jobrunner.h"

#include <Eigen/Geometry>
#include <QList>
#include <QObject>
#include <QTimer>

#include <functional>
#include <optional>

namespace autocuts {

enum class SceneKind;
class ShownMap;
class SolverController;
class Workspace;
struct MapInput;
struct MapJobResult;
struct PackTarget;
namespace jobs {
struct TransferChoice;
}

//! Which islands are packed. The others keep their places and are obstacles.
enum class PackScope { All, Selection };
//! Which faces a job may change. What is shown, and the selection, stays continuous with the rest of its
//! islands, or is cut free.
enum class JobReach { All, Shown, SelectionAttached, SelectionFree };

//! Starts jobs on copies of the document and pushes each result as one command. A running live solve is
//! paused first. When the map is edited meanwhile, the result is discarded and the user is told; unwrapping
//! and finishing end at once. Unwrapping shows its best map, and begins again when the steering or the layout
//! settings are edited meanwhile.
class MapController final : public QObject
{
    Q_OBJECT

public:
    MapController(Workspace &workspace, SolverController &solver, ShownMap &shownMap,
                  QObject *parent = nullptr);

    //! The running job, for its progress.
    JobRunner &jobs() { return mJobs; }
    //! True while the views show the best map of the running job instead of the document's.
    bool isPreviewing() const { return mPreview.isShown(); }
    //! A job is running that gives the document another map.
    bool makesMap() const { return mJobs.isBusy() && mReplacesMap; }

    //! The figures of the newest measured map; null before the first measurement.
    const MapFigures *figures() const { return mMeasuring.figures(); }
    //! True when the figures belong to the document's current map.
    bool figuresAreFresh() const { return mMeasuring.areFresh(); }

    //! The prices of the seams of the document's current map; null when they are not known.
    const unwrap::SeamPrices *seamPrices() const;
    //! Share of the model's area in parts that the last unwrap took for hard surfaces; nothing: unknown.
    std::optional<double> hardShare() const { return mHardShare; }

    //! The work of a job, on another thread.
    using Work = std::function<MapJobResult(const MapInput &, JobControl &)>;
    //! Starts a job for the document as it is when a running solve has paused.
    //! \param replacesMap it makes a map in place of the document's, or a picture for a map made for that: it
    //! ends when the map is edited
    void startJob(const QString &title, Work work, bool replacesMap = false);

    //! Asked before a job that would change all faces while some are hidden; once for each model, until all
    //! faces are shown again. Without it such a job changes all faces. \param ask returns All, Shown, or
    //! nothing when the job is not wanted
    using HiddenQuestion = std::function<std::optional<JobReach>(qsizetype hiddenFaces)>;
    void setHiddenQuestion(HiddenQuestion ask) { mAskHidden = std::move(ask); }

    //! The quality of unwraps that name none.
    unwrap::UnwrapQuality quality() const { return mQuality; }
    void setQuality(unwrap::UnwrapQuality quality) { mQuality = quality; }

public Q_SLOTS:
    //! Unwraps automatically, as the command line does (solver/unwrap/unwrap.h).
    void unwrap(autocuts::unwrap::UnwrapQuality quality, autocuts::JobReach reach = JobReach::All);
    //! Finishes the live map, or the document's map when there is none: the result has definite seams and no
    //! overlaps.
    void finish(autocuts::JobReach reach = JobReach::All);
    void pack(autocuts::PackScope scope);
    //! Packs into one UDIM tile for each object or material, from the tile of the settings on: the islands of
    //! the selected faces, or all when none are selected.
    void packEach(autocuts::SceneKind kind);
    //! Gives the islands of the selected faces, or all when none are selected, a texel density, and packs
    //! them into as many UDIM tiles as that needs, from the tile of the settings on.
    //! \param density texels per unit of the model, > 0
    void packAtDensity(double density);
    //! Packs the islands of the selected faces into the free room of the tiles in use, and what does not fit
    //! into further ones. The others stay.
    void fillTiles();
    //! Packs the islands of the faces into a box instead of a tile; other islands are obstacles.
    //! \param box texture space
    //! \param faces empty: the selected faces
    void packInto(const Eigen::AlignedBox2d &box, const QList<int> &faces = {});
    //! Separates overlaps by cutting islands along short seams, and packs.
    void separateOverlaps();
    //! The same by the greedy way of the paper: islands that grow breadth first for as long as they do not
    //! cover themselves (figure 11, right).
    void separateGreedily();
    //! Adds a copy of the active UV set and makes it a map for lightmaps; without UVs, an unwrapped one.
    //! \param then what follows when the map is made
    void addLightmapSet(const std::function<void()> &then = {});
    //! Brings the UVs of another file, UV set or object onto the model.
    void transferUvs(const jobs::TransferChoice &choice);
    //! Gives every island the same texel density. \pre no job is running
    void equalizeDensity();
    //! Minimises the distortion of the selected faces while all others stay. Pins and locks are respected.
    void relaxSelection();
    //! Makes each chain of selected edges straight; the rest of its island follows.
    void straightenSelection();
    //! Makes the selected quads a rectangle of straight rows and columns; the rest of their islands follows.
    void gridSelection();
    //! Turns islands to the axes and makes straight what is straight on the model. \param faces of them
    void alignToAxes(const QList<int> &faces);
    //! Prices the seams of the map.
    void priceSeams();
    //! Cuts the map along edges at once and records the edges as cut. \param edges edges of MeshAdjacency
    void rip(const QList<int> &edges);
    //! Closes those of the edges that are seams of the map. \param edges edges of MeshAdjacency
    void stitch(const QList<int> &edges);
    void cancel();

Q_SIGNALS:
    //! figures() changed, or whether they are fresh.
    void figuresChanged();
    //! seamPrices() changed.
    void pricesChanged();
    //! The model has textures that were baked.
    void picturesBaked();
    //! A job succeeded. \param message translated, one line, for the status bar
    void done(const QString &message);
    //! A job failed, or could not do all that it was asked for.
    //! \param message translated \param items what it is about; empty: nothing in particular
    void failed(const QString &message, const autocuts::Selection &items = {});

private:
    MapInput input() const;
    std::optional<JobReach> asked(JobReach reach);
    QList<int> facesOf(JobReach reach) const;
    void beginUnwrap(unwrap::UnwrapQuality quality, JobReach reach, const QList<int> &faces);
    void takeUpEdits();
    void endUselessJob();
    void applyResult(const MapJobResult &result);
    bool pushMap(const MapJobResult &result);
    bool pushTextures(const MapJobResult &result);
    void startPacking(const PackTarget &target);

    Workspace &mWorkspace;
    SolverController &mSolver;
    JobRunner mJobs;
    JobPreview mPreview;
    StateToken mInputToken;         //!< token of the state that the job was given
    std::function<void()> mRestart; //!< begins the job again; null: it does not take up edits
    bool mReplacesMap = false;      //!< the running job does, see startJob()
    QTimer mRestartSoon{this};      //!< one new beginning for all edits of a gesture
    bool mRestarts = false;
    unwrap::UnwrapQuality mQuality = unwrap::UnwrapQuality::Standard;
    HiddenQuestion mAskHidden;
    std::optional<JobReach> mReachOfHidden; //!< what was answered
    std::function<void()> mOnSuccess;       //!< what follows when the job has made its map
    MapMeasuring mMeasuring;
    std::optional<double> mHardShare;
    std::optional<unwrap::SeamPrices> mPrices;
    StateToken mPricesToken; //!< of the state that they were made from
};

} // namespace autocuts
