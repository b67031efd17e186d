#include "batch.h"

#include "model/io/exportlosses.h"
#include "model/io/meshdoctor.h"
#include "model/io/meshfile.h"
#include "model/io/report.h"
#include "model/io/savefile.h"
#include "model/io/uvexport.h"
#include "model/samples.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/separatemap.h"
#include "solver/packing/islandgeometry.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

namespace autocuts {

namespace {

using Command = CliOptions::Command;

//! Requests a stop after a time, unless it is destroyed before.
class Timer
{
public:
    Timer(double seconds, StopSource &stop)
    {
        if (seconds <= 0)
            return;
        mThread = std::jthread([seconds, &stop](const std::stop_token &token) {
            std::mutex mutex;
            std::unique_lock lock(mutex);
            std::condition_variable_any wake;
            const bool ended = wake.wait_for(lock, token, std::chrono::duration<double>(seconds),
                                             [&token] { return token.stop_requested(); });
            if (!ended)
                stop.request(StopReason::TimeLimit);
        });
    }

private:
    std::jthread mThread;
};

//! One line on a terminal that is written over and over.
class ProgressLine
{
public:
    ProgressLine(bool show, QTextStream &err) : mShow(show), mErr(err) { mSince.start(); }
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine &) = delete;
    ProgressLine &operator=(const ProgressLine &) = delete;

    void show(const QString &text)
    {
        if (!mShow || (mWritten && mSince.elapsed() < 100))
            return;
        mErr << '\r' << text.leftJustified(78) << Qt::flush;
        mWritten = true;
        mSince.restart();
    }
    void clear()
    {
        if (mWritten)
            mErr << '\r' << QString(78, QLatin1Char(' ')) << '\r' << Qt::flush;
        mWritten = false;
    }

private:
    bool mShow;
    QTextStream &mErr;
    QElapsedTimer mSince;
    bool mWritten = false;
};

QString statusWord(const StopSource &stop)
{
    switch (stop.reason.load()) {
    case StopReason::Interrupted:
        return QStringLiteral("interrupted");
    case StopReason::TimeLimit:
        return QStringLiteral("time_limit");
    case StopReason::None:
        break;
    }
    return QStringLiteral("done");
}

MapReport makeReport(const UvMetrics &m)
{
    MapReport r;
    r.triangles = m.triangles;
    r.charts = m.charts;
    r.seamLength = m.seamLength;
    r.seamNorm = m.seamNorm;
    r.symDirichlet = m.symDirichlet;
    r.symDirichletMax = m.symDirichletMax;
    r.flipped = m.flipped;
    if (m.overlapPairs >= 0)
        r.overlapPairs = m.overlapPairs;
    r.overlapAreaRatio = m.overlapAreaRatio;
    r.packingEfficiency = m.packingUnit;
    r.minGutterTexels = m.minGutterTexels;
    r.faces = m.faces;
    r.seamEdges = m.seamEdges;
    r.symDirichletInfinite = m.symDirichletInfinite;
    r.uvDegenerate = m.uvDegenerate;
    r.mirroredCharts = m.mirroredCharts;
    r.nonDiskCharts = m.nonDiskCharts;
    r.facesWithoutUv = m.facesWithoutUv;
    r.zeroAreaTriangles = m.zeroAreaTriangles;
    r.symDirichletP99 = m.symDirichletP99;
    r.symDirichletScale = m.symDirichletScale;
    r.l2Stretch = m.l2Stretch;
    r.angleDistortion = m.angleDistortion;
    r.areaDistortion = m.areaDistortion;
    r.texelDensitySpread = m.texelDensitySpread;
    r.packingBox = m.packingBox;
    r.minGutter = m.minGutter;
    r.borderGutterTexels = m.borderGutterTexels;
    r.inUnitSquare = m.inUnitSquare;
    return r;
}

UvMatrix soupUvOf(const MeshData &mesh, const UvMatrix &uv)
{
    UvMatrix soup(mesh.soupCornerCount(), 2);
    for (int c = 0; c < mesh.soupCornerCount(); ++c)
        soup.row(c) = uv.row(mesh.cornerOfSoup(c));
    return soup;
}

std::vector<int> overlappingTriangles(const MeshData &mesh, const UvMatrix &uv)
{
    std::vector<int> result;
    for (const OverlapPair &pair : findOverlaps(soupUvOf(mesh, uv), {}).pairs) {
        result.push_back(pair.first);
        result.push_back(pair.second);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

class Job
{
public:
    Job(const CliOptions &options, StopSource &stop, bool showProgress, QTextStream &out, QTextStream &err)
        : mOptions(options), mStop(stop), mOut(out), mErr(err), mProgress(showProgress && !options.quiet, err)
    {
        mClock.start();
    }

    int run()
    {
        switch (mOptions.command) {
        case Command::Help:
            mOut << usageText() << Qt::flush;
            return 0;
        case Command::Version:
            mOut << "autocuts-cli " << QCoreApplication::applicationVersion() << Qt::endl;
            return 0;
        case Command::Sample:
            return runSample();
        case Command::Check:
            return runCheck();
        case Command::Convert:
            return runConvert();
        case Command::Unwrap:
            return runMapping([this](Scene &scene) { return unwrapScene(scene); });
        case Command::Pack:
            return runMapping([this](Scene &scene) { return packScene(scene); });
        case Command::Separate:
            return runMapping([this](Scene &scene) { return separateScene(scene); });
        }
        return 1;
    }

    int fail(const Error &error)
    {
        mProgress.clear();
        mErr << "autocuts-cli: " << error.toString() << Qt::endl;
        return 1;
    }

private:
    //! What a mapping command found out beside the UVs.
    struct Outcome
    {
        std::optional<int> iterations;
        double lambda = MapReport::unknown, delta = MapReport::unknown;
        QStringList notes;
    };

    int runSample()
    {
        const Result<Scene> scene = makeSample(mOptions.input);
        if (!scene)
            return fail(scene.error());
        const Result<Done> written = writeMesh(scene.value(), mOptions.output);
        return written ? 0 : fail(written.error());
    }

    int runConvert()
    {
        const Result<Scene> scene = readMesh(mOptions.input);
        if (!scene)
            return fail(scene.error());
        sayLosses(scene.value());
        const Result<Done> written = writeMesh(scene.value(), mOptions.output);
        return written ? 0 : fail(written.error());
    }

    int runCheck()
    {
        const Result<Scene> scene = readMesh(mOptions.input);
        if (!scene)
            return fail(scene.error());
        MapReport report;
        if (scene->hasUv()) {
            report = makeReport(measureUv(*scene->mesh, scene->uvSets.front().uv));
        } else {
            report.triangles = scene->mesh->triangleCount();
            report.facesWithoutUv = scene->mesh->faceCount();
        }
        report.status = QStringLiteral("done");
        describe(scene.value(), report);
        if (mOptions.json)
            mOut << QString::fromUtf8(reportJson(report)) << Qt::flush;
        else
            printTable(report);
        return 0;
    }

    template <class Work>
    int runMapping(Work &&work)
    {
        // The slow part must not be for nothing: an output that cannot be written is better found now.
        const QFileInfo folder(QFileInfo(mOptions.output).absolutePath());
        if (!folder.isDir())
            return fail({QStringLiteral("the output folder does not exist"), folder.filePath(), 0,
                         QStringLiteral("Create it first")});
        Result<Scene> scene = readMesh(mOptions.input);
        if (!scene)
            return fail(scene.error());
        if (!(scene->mesh->area > 0))
            return fail({QStringLiteral("all faces are without area, there is nothing to map"), mOptions.input, 0,
                         QStringLiteral("Check the scale and the vertices of the model")});
        const Timer timer(mOptions.timeLimit, mStop);
        Result<Outcome> outcome = work(scene.value());
        mProgress.clear();
        if (!outcome)
            return fail(outcome.error());
        return writeResults(scene.value(), outcome.value());
    }

    Result<Outcome> unwrapScene(Scene &scene)
    {
        Snapshot snapshot;
        snapshot.mesh = scene.mesh;
        snapshot.settings = mOptions.settings;
        if (snapshot.settings.start == StartMode::ExistingUv) {
            if (!scene.hasUv())
                return Error{QStringLiteral("the file has no UVs to start from"), mOptions.input, 0,
                             QStringLiteral("Use --init rigid")};
            snapshot.startUv = startUvFromCorners(*scene.mesh, scene.uvSets.front().uv);
        }
        const UnwrapResult result =
            unwrap(snapshot, mOptions.unwrap, &mStop.stop, [this](const UnwrapProgress &p) { showProgress(p); });
        setUv(scene, result.uv);
        Outcome outcome;
        outcome.iterations = result.iterations;
        outcome.lambda = result.lambda;
        outcome.delta = result.delta;
        if (!result.withinBound)
            outcome.notes << QStringLiteral("the distortion bound %1 was not reached: %2")
                                 .arg(mOptions.unwrap.maxDistortion)
                                 .arg(result.distortion);
        return outcome;
    }

    Result<Outcome> packScene(Scene &scene)
    {
        if (!scene.hasUv())
            return noUvs();
        UvMatrix uv = scene.uvSets.front().uv;
        const MeshData &mesh = *scene.mesh;
        const ChartMap charts = findCharts(mesh, uv);
        PackSettings settings = mOptions.unwrap.packing;
        if (!settings.keepScale)
            equalizeTexelDensity(mesh, charts, uv);
        if (const Result<Done> packed = packCharts(mesh, charts, settings, uv); !packed)
            return packed.error();
        setUv(scene, uv);
        return Outcome{};
    }

    Result<Outcome> separateScene(Scene &scene)
    {
        if (!scene.hasUv())
            return noUvs();
        const MeshData &mesh = *scene.mesh;
        UvMatrix uv = scene.uvSets.front().uv;
        const Separated separated = separateMap(mesh, uv, &mStop.stop);
        if (mOptions.unwrap.pack) {
            PackSettings settings = mOptions.unwrap.packing;
            if (const Result<Done> packed = packCharts(mesh, separated.charts, settings, uv); !packed)
                return packed.error();
        }
        setUv(scene, uv);
        Outcome outcome;
        outcome.notes << QStringLiteral("%1 edges were cut to take overlaps apart").arg(separated.newSeams);
        if (separated.unresolvedPairs > 0)
            outcome.notes << QStringLiteral("%1 overlaps lie inside single polygons and remain")
                                 .arg(separated.unresolvedPairs);
        return outcome;
    }

    Result<Done> packCharts(const MeshData &mesh, const ChartMap &charts, const PackSettings &settings,
                            UvMatrix &uv)
    {
        const PackResult packed =
            packIslands(makePackIslands(mesh, uv, charts), settings, &mStop.stop, [this](double done) {
                mProgress.show(QStringLiteral("packing %1 %").arg(100 * done, 0, 'f', 0));
            });
        if (!packed.complete)
            return Error{settings.keepScale ? QStringLiteral("the islands do not fit at their size")
                                            : QStringLiteral("there is no room for the margins"),
                         mOptions.input, 0,
                         QStringLiteral("Use a smaller --margin, a larger --texture-size or no --keep-scale")};
        applyPlacements(packed, mesh, charts, uv);
        return Done{};
    }

    Error noUvs() const
    {
        return {QStringLiteral("the file has no UVs"), mOptions.input, 0,
                QStringLiteral("Make them with autocuts-cli unwrap")};
    }

    static void setUv(Scene &scene, const UvMatrix &uv)
    {
        if (scene.uvSets.empty())
            scene.uvSets.push_back({QStringLiteral("UVMap"), {}});
        scene.uvSets.front().uv = uv;
    }

    int writeResults(const Scene &scene, const Outcome &outcome)
    {
        sayLosses(scene);
        if (const Result<Done> written = writeMesh(scene, mOptions.output); !written)
            return fail(written.error());
        const UvMatrix &uv = scene.uvSets.front().uv;
        UvMetricsOptions metricsOptions;
        metricsOptions.textureSize = mOptions.unwrap.packing.textureSize;
        MapReport report = makeReport(measureUv(*scene.mesh, uv, metricsOptions));
        describe(scene, report);
        report.output = mOptions.output;
        report.layout = mOptions.layout;
        report.textureSize = mOptions.unwrap.packing.textureSize;
        if (outcome.iterations)
            report.iterations = *outcome.iterations;
        report.lambda = outcome.lambda;
        report.delta = outcome.delta;
        report.status = statusWord(mStop);
        report.notes += outcome.notes;
        if (!mOptions.layout.isEmpty()) {
            if (const Result<Done> drawn = writeLayout(*scene.mesh, uv, report); !drawn)
                return fail(drawn.error());
        }
        report.seconds = double(mClock.elapsed()) / 1000;
        if (!mOptions.report.isEmpty()) {
            if (const Result<Done> saved = saveAtomically(mOptions.report, reportJson(report)); !saved)
                return fail(saved.error());
        }
        for (const QString &note : outcome.notes)
            mErr << "autocuts-cli: " << note << Qt::endl;
        if (!mOptions.quiet)
            printTable(report);
        return mStop.reason == StopReason::Interrupted ? 130 : 0;
    }

    Result<Done> writeLayout(const MeshData &mesh, const UvMatrix &uv, const MapReport &report)
    {
        LayoutOptions options;
        options.size = std::clamp(mOptions.unwrap.packing.textureSize, 256, 4096);
        if (report.overlapPairs.value_or(0) > 0)
            options.overlapping = overlappingTriangles(mesh, uv);
        const bool svg = mOptions.layout.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
        const Result<QByteArray> bytes = svg ? layoutSvg(mesh, uv, options) : layoutPng(mesh, uv, options);
        if (!bytes)
            return bytes.error();
        return saveAtomically(mOptions.layout, bytes.value());
    }

    void describe(const Scene &scene, MapReport &report) const
    {
        report.input = mOptions.input;
        report.mesh = scene.mesh->report;
        report.notes = meshDoctorNotes(scene.mesh->report);
        for (const QString &note : scene.notes)
            report.notes << note;
    }

    void sayLosses(const Scene &scene)
    {
        mProgress.clear();
        for (const QString &loss : exportLosses(scene, QFileInfo(mOptions.output).suffix().toLower()))
            mErr << "autocuts-cli: note: " << loss << Qt::endl;
    }

    void showProgress(const UnwrapProgress &p)
    {
        static const char *const stages[] = {"optimising", "separating", "packing"};
        QString text = QStringLiteral("%1 %2 %")
                           .arg(QLatin1String(stages[static_cast<int>(p.stage)]))
                           .arg(100 * p.fraction, 3, 'f', 0);
        if (p.distortion > 0)
            text += QStringLiteral("   distortion %1   seams %2")
                        .arg(p.distortion, 0, 'f', 4)
                        .arg(p.seamLength, 0, 'f', 3);
        mProgress.show(text);
    }

    void printTable(const MapReport &r)
    {
        const auto line = [this](const char *name, const QString &value) {
            mOut << QString::fromLatin1(name).leftJustified(20) << value << '\n';
        };
        const auto number = [](double value) {
            return std::isfinite(value) ? QString::number(value, 'g', 7) : QStringLiteral("-");
        };
        const auto count = [](const MapReport::Count &value) {
            return value ? QString::number(*value) : QStringLiteral("-");
        };
        line("triangles", count(r.triangles));
        line("charts", count(r.charts));
        line("seam_length", number(r.seamLength));
        line("seam_norm", number(r.seamNorm));
        line("sym_dirichlet", number(r.symDirichlet));
        line("sym_dirichlet_max", number(r.symDirichletMax));
        line("flipped", count(r.flipped));
        line("overlap_pairs", count(r.overlapPairs));
        line("packing_efficiency", number(r.packingEfficiency));
        line("min_gutter_texels", number(r.minGutterTexels));
        line("status", r.status);
        for (const QString &note : r.notes)
            mOut << "note: " << note << '\n';
        mOut << Qt::flush;
    }

    const CliOptions &mOptions;
    StopSource &mStop;
    QTextStream &mOut;
    QTextStream &mErr;
    ProgressLine mProgress;
    QElapsedTimer mClock;
};

} // namespace

int runCommand(const CliOptions &options, StopSource &stop, bool showProgress, QTextStream &out,
               QTextStream &err)
{
    Job job(options, stop, showProgress, out, err);
    const auto failure = [&](const QString &what, const QString &remedy) {
        return job.fail({what, options.input, 0, remedy});
    };
    try {
        return job.run();
    } catch (const std::bad_alloc &) {
        return failure(QStringLiteral("not enough memory"),
                       QStringLiteral("Close other programs or use a smaller model"));
    } catch (const std::exception &e) {
        return failure(QString::fromUtf8(e.what()), {});
    }
}

} // namespace autocuts
