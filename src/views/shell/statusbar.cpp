#include "views/shell/statusbar.h"

#include "model/document/document.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/panels/elidedlabel.h"
#include "views/panels/figurestrip.h"
#include "views/ui/numbertext.h"

#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int progressWidth = 140, widestSelection = 260, widestSet = 150;
constexpr int settleDelay = 120;  // milliseconds
constexpr int loadingDelay = 150; // milliseconds; what is read sooner is not worth a word

double selectedArea(const Document &document)
{
    const MeshData &mesh = document.mesh();
    std::vector<bool> selected(mesh.faceCount());
    for (int face : document.selection().faces)
        selected[face] = true;
    double area = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t)
        area += selected[mesh.triangleFace[t]] ? mesh.triangleArea[t] : 0;
    return area;
}

QString verticesText(const Document &document)
{
    const MeshData &mesh = document.mesh();
    std::vector<int> vertices;
    for (int corner : document.selection().corners)
        vertices.push_back(mesh.vertexWeld[mesh.cornerVertex[corner]]);
    std::sort(vertices.begin(), vertices.end());
    const auto count = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
    return StatusBar::tr("Vertices: %1, corners: %2")
        .arg(countText(count), countText(std::ssize(document.selection().corners)));
}

QString edgesText(const Document &document)
{
    double length = 0;
    for (int edge : document.selection().edges)
        length += document.adjacency().edgeLength(edge);
    return StatusBar::tr("Edges: %1, length %2")
        .arg(countText(document.selection().edges.size()), significantText(length, 4));
}

} // namespace

QString selectionSummary(const Document &document)
{
    const Selection &selection = document.selection();
    switch (selection.mode) {
    case SelectionMode::Vertices:
        return selection.corners.isEmpty() ? QString() : verticesText(document);
    case SelectionMode::Edges:
        return selection.edges.isEmpty() ? QString() : edgesText(document);
    case SelectionMode::Faces:
    case SelectionMode::Islands:
        break;
    }
    if (selection.faces.isEmpty())
        return {};
    const QString faces =
        StatusBar::tr("Faces: %1, area %2")
            .arg(countText(selection.faces.size()), significantText(selectedArea(document), 4));
    if (selection.mode == SelectionMode::Faces)
        return faces;
    const auto islands = document.islands().islandsOf(selection.faces).size();
    return StatusBar::tr("Islands: %1, %2").arg(countText(qint64(islands)), faces);
}

StatusBar::StatusBar(const StudioContext &context, QWidget *parent)
    : QStatusBar(parent), mContext(context), mText(new ElidedLabel), mSet(new ElidedLabel),
      mSelection(new ElidedLabel), mOfSoup(new QLabel(tr("Soup:"))), mFigures(new FigureStrip),
      mProgress(new QProgressBar), mCancel(new QToolButton)
{
    mText->setObjectName("statusText"_L1);
    mSelection->setObjectName("selectionText"_L1);
    mFigures->setObjectName("statusFigures"_L1);
    addWidget(mText, 1);
    addJob();
    mSet->setObjectName("uvSetText"_L1);
    mSet->setWidest(widestSet);
    addPermanentWidget(mSet);
    mSelection->setWidest(widestSelection);
    addPermanentWidget(mSelection);
    mOfSoup->setObjectName("ofSoup"_L1);
    mOfSoup->setToolTip(
        tr("These figures are of the separate triangles that lambda and delta act on. Those of "
           "the definite map are in the Unwrap panel"));
    addPermanentWidget(mOfSoup);
    addPermanentWidget(mFigures);
    addFigures();
    mMessageTimer.setSingleShot(true);
    connect(&mMessageTimer, &QTimer::timeout, this, [this] { showText({}, 0); });
    mRefreshTimer.setSingleShot(true);
    connect(&mRefreshTimer, &QTimer::timeout, this, &StatusBar::refresh);
    mIslandsRest.setSingleShot(true);
    mIslandsRest.setInterval(settleDelay);
    connect(&mIslandsRest, &QTimer::timeout, this, [this] {
        mSelectionStale = true;
        refresh();
    });
    mLoadingTimer.setSingleShot(true);
    mLoadingTimer.setInterval(loadingDelay);
    connect(&mLoadingTimer, &QTimer::timeout, this, [this] {
        mLoadingLong = true;
        showJob();
    });
    connectAll();
    refresh();
    showJob();
}

void StatusBar::addJob()
{
    mProgress->setObjectName("progress"_L1);
    mProgress->setFixedWidth(progressWidth);
    mProgress->setMaximumHeight(fontMetrics().height() + 2);
    mProgress->setTextVisible(true);
    mCancel->setObjectName("cancel"_L1);
    mCancel->setText(tr("Cancel"));
    mCancel->setToolTip(tr("Stop the job; what it has so far is used when that makes sense"));
    mCancel->setAutoRaise(true);
    mCancel->setFocusPolicy(Qt::TabFocus);
    connect(mCancel, &QToolButton::clicked, this, [this] {
        JobRunner *job = runningJob();
        if (job == &mContext.map.jobs())
            mContext.map.cancel();
        else if (job)
            job->cancel();
    });
    addPermanentWidget(mProgress);
    addPermanentWidget(mCancel);
}

void StatusBar::addFigures()
{
    // In the order of enum Figure.
    mFigures->addFigure(
        tr("D"), u"00.0000"_s,
        tr("Distortion D: area-weighted mean of the distortion energy, 4 where nothing is distorted"));
    mFigures->addFigure(tr("seams"), u"000.000"_s, tr("Length of the seams, on the mesh scaled to area π"));
    mFigures->addFigure(tr("islands"), u"0000"_s, tr("Number of islands"));
    mFigures->addFigure(tr("flips"), u"000"_s, tr("Flipped triangles of the map"));
    mFigures->addFigure(tr("overlaps"), u"000,000"_s, tr("Pairs of triangles of the map that overlap"));
    mFigures->addFigure(tr("λ"), u"0.0000"_s, tr("Lambda in effect: balance of distortion and seams"));
    mFigures->addFigure(tr("δ"), u"0.000000"_s, tr("Delta in effect: how sharply edges are cut or joined"));
    mFigures->addFigure(tr("E"), u"000.000"_s,
                        tr("Energy E = (1 − λ) D + λ S, and that of pins and rectangles"));
    mFigures->addFigure(tr("S"), u"000.000"_s,
                        tr("Separation S: smoothed length of the seams, on the mesh scaled to area π"));
    mFigures->addFigure(tr("it/s"), u"000.0"_s, tr("Newton steps of the solver per second"));
}

void StatusBar::connectAll()
{
    connect(&mContext.workspace, &Workspace::documentReplaced, this, [this] {
        mSelectionStale = true;
        refreshSoon();
    });
    connect(&mContext.workspace, &Workspace::selectionChanged, this, [this] {
        mSelectionStale = true;
        refreshSoon();
    });
    connect(&mContext.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::Uv)
            mIslandsRest.start(); // finding islands takes too long to be done for every event of a drag
        refreshSoon();
    });
    connect(&mContext.solver, &SolverController::statusChanged, this, &StatusBar::refreshSoon);
    connect(&mContext.solver, &SolverController::stateChanged, this, &StatusBar::refreshSoon);
    connect(&mContext.map, &MapController::figuresChanged, this, &StatusBar::refreshSoon);
    connect(&mContext.shownMap, &ShownMap::changed, this, &StatusBar::refreshSoon);
    connect(&mContext.pictures, &ModelPictures::loadingChanged, this, [this] {
        mLoadingLong = false;
        if (mContext.pictures.isLoading())
            mLoadingTimer.start();
        else
            mLoadingTimer.stop();
        showJob();
    });
    for (const JobRunner *jobs : {&mContext.map.jobs(), &mContext.files.jobs()}) {
        connect(jobs, &JobRunner::busyChanged, this, [this, jobs, wasBusy = false]() mutable {
            if (jobs->isBusy() && !wasBusy)
                mMessage.clear(); // it is of what was before the job
            wasBusy = jobs->isBusy();
            showJob();
        });
        connect(jobs, &JobRunner::progressChanged, this, &StatusBar::showJob);
    }
}

void StatusBar::setHint(const QString &hint)
{
    mHint = hint;
    showLeftText();
}

void StatusBar::showText(const QString &message, int timeoutMs)
{
    mMessage = message;
    if (timeoutMs > 0 && !message.isEmpty())
        mMessageTimer.start(timeoutMs);
    else
        mMessageTimer.stop();
    showLeftText();
}

QString StatusBar::shownText() const
{
    return mText->text();
}

QString StatusBar::setText() const
{
    return mSet->text();
}

QString StatusBar::selectionText() const
{
    return mSelection->text();
}

JobRunner *StatusBar::runningJob() const
{
    for (JobRunner *jobs : {&mContext.files.jobs(), &mContext.map.jobs()}) {
        if (jobs->isBusy())
            return jobs;
    }
    return nullptr;
}

void StatusBar::showJob()
{
    const JobRunner *job = runningJob();
    mProgress->setVisible(job || mLoadingLong);
    mCancel->setVisible(job != nullptr);
    if (mProgress->isVisibleTo(this)) {
        const double progress = job ? job->progress() : -1;
        // A job of unknown length only shows activity.
        mProgress->setRange(0, progress < 0 ? 0 : 100);
        mProgress->setValue(static_cast<int>(100 * std::max(0.0, progress)));
    }
    showLeftText();
}

void StatusBar::showLeftText()
{
    const JobRunner *job = runningJob();
    QString text = mHint;
    if (!mMessage.isEmpty())
        text = mMessage;
    else if (job)
        text = job->stage().isEmpty() ? tr("%1…").arg(job->title())
                                      : tr("%1: %2").arg(job->title(), job->stage());
    if (mLoadingLong && !job)
        text = mMessage.isEmpty() ? tr("Reading textures…") : tr("%1 – reading textures…").arg(mMessage);
    mText->setText(text);
    showSelection();
}

//! What is selected leaves its place to a message that would be cut off.
void StatusBar::showSelection()
{
    const int room = mText->width() - (mSelection->isVisibleTo(this) ? 0 : mSelection->sizeHint().width());
    const bool isLong = !mMessage.isEmpty() && mText->sizeHint().width() > room;
    mSelection->setVisible(!mSelection->text().isEmpty() && !isLong);
}

void StatusBar::refreshSoon()
{
    if (!mRefreshTimer.isActive())
        mRefreshTimer.start(0);
}

void StatusBar::refresh()
{
    const Document *document = mContext.workspace.document();
    if (mSelectionStale) {
        mSelectionStale = false;
        mSelection->setText(document ? selectionSummary(*document) : QString());
        showSelection();
    }
    const bool several = document && document->uvSets().size() > 1;
    mSet->setText(several ? tr("UV set: %1").arg(document->uvSets()[document->activeUvSet()].name)
                          : QString());
    mSet->setVisible(several);
    mFigures->setVisible(document != nullptr);
    // Lambda, delta and the energies belong to the soup.
    const bool soup = mContext.shownMap.isSoup() || mContext.solver.mode() == homotopy::SolveMode::Manual;
    mFigures->setShownCount(soup ? FigureCount : Lambda);
    const bool live = document && (mContext.solver.isRunning() || mContext.solver.isPausing());
    mOfSoup->setVisible(live && mContext.shownMap.isSoup());
    if (live)
        showLiveFigures();
    else
        showMapFigures();
}

void StatusBar::showLiveFigures()
{
    const live::SolveStatus status = mContext.solver.status();
    const bool soup = mContext.shownMap.isSoup();
    mFigures->setFigure(Steps, soup ? fixedText(status.stepsPerSecond, 1) : missingText());
    const bool measured = status.distortion > 0; // not before the first step
    mFigures->setFigure(Energy, measured ? fixedText(status.energy, 3) : missingText());
    mFigures->setFigure(Distortion, measured ? fixedText(status.distortion, 4) : missingText());
    mFigures->setFigure(Separation, measured ? fixedText(status.separation, 3) : missingText());
    mFigures->setFigure(Lambda, fixedText(status.lambda, 4));
    mFigures->setFigure(Delta, significantText(status.delta, 3));
    mFigures->setFigure(SeamLength, fixedText(status.seamLength, 3));
    mFigures->setFigure(Islands, countText(status.islands));
    // The solver never flips a triangle. A definite map has no overlaps; those of the soup are not counted.
    mFigures->setFigure(Flips, countText(0));
    mFigures->setFigure(Overlaps, soup || !mContext.solver.map() ? missingText() : countText(0));
}

void StatusBar::showMapFigures()
{
    // The map of a job that is shown has not been measured.
    const bool known = mContext.map.figuresAreFresh() && !mContext.map.isPreviewing();
    const MapFigures *figures = known ? mContext.map.figures() : nullptr;
    const Document *document = mContext.workspace.document();
    for (int number = 0; number < FigureCount; ++number)
        mFigures->setFigure(number, missingText());
    if (document) {
        mFigures->setFigure(Lambda, fixedText(document->solveSettings().lambda, 4));
        mFigures->setFigure(Delta, significantText(document->solveSettings().delta, 3));
    }
    if (!figures || figures->metrics.charts == 0)
        return;
    const metrics::UvMetrics &metrics = figures->metrics;
    mFigures->setFigure(Distortion, fixedText(metrics.tileDirichlet, 4));
    mFigures->setFigure(SeamLength, fixedText(metrics.seamNorm, 3));
    mFigures->setFigure(Islands, countText(metrics.charts));
    mFigures->setFigure(Flips, countText(metrics.flipped), metrics.flipped > 0);
    mFigures->setFigure(Overlaps, countText(metrics.overlapPairs), metrics.overlapPairs > 0);
}

} // namespace autocuts
