#include "support/artistsession.h"

#include "model/document/makesnapshot.h"
#include "model/io/meshes/meshfile.h"
#include "model/plain/udimtiles.h"
#include "support/editsupport.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"

namespace autocuts::test {

using namespace homotopy;

using namespace metrics;

namespace {

using namespace Qt::Literals::StringLiterals;

constexpr int hovers = 24;

class Session
{
public:
    Session(Artist &artist, const QString &file) : mArtist(artist), mFile(file) {}

    QString run()
    {
        using Step = void (Session::*)();
        for (const Step step :
             {&Session::open, &Session::cutAndJoin, &Session::paint, &Session::solve,
              &Session::takeARegionOut, &Session::finish, &Session::steerInTheMap, &Session::arrange,
              &Session::pin, &Session::box, &Session::pack, &Session::keep, &Session::takeAllBack}) {
            if (mProblem.isEmpty())
                (this->*step)();
        }
        return mProblem;
    }

private:
    Document &document() { return mArtist.document(); }

    void require(bool fine, const QString &what)
    {
        if (!fine && mProblem.isEmpty())
            mProblem = what;
    }
    //! The last gesture has to have made one entry, which can be taken back.
    void requireEntry(const QString &what)
    {
        require(document().undoStack().index() == mEntries + 1, what + u": not one entry"_s);
        if (mProblem.isEmpty())
            mProblem = mArtist.undoAndRedo();
        mEntries = document().undoStack().index();
    }
    void requireCleanMap(const QString &after)
    {
        require(mArtist.studio.measured(), after + u": not measured"_s);
        if (!mProblem.isEmpty())
            return;
        const UvMetrics &metrics = mArtist.studio.context.map.figures()->metrics;
        require(metrics.flipped == 0, after + u": flipped triangles"_s);
        require(metrics.overlapPairs == 0, after + u": overlaps"_s);
    }
    int edgesIn(PairState state)
    {
        const auto &states = document().seams().states;
        return static_cast<int>(std::count(states.begin(), states.end(), state)) / 2;
    }

    void open()
    {
        require(mArtist.open(mFile), u"not opened"_s);
        mHadMap = mProblem.isEmpty() && hasUvs(document());
    }

    void cutAndJoin()
    {
        const QList<QPoint> edges = mArtist.edgesOn(mArtist.model(), hovers);
        require(edges.size() == hovers, u"no edges are seen"_s);
        if (!mProblem.isEmpty())
            return;
        mArtist.use("tool.cut");
        mArtist.hover("cut: hover", mArtist.model(), edges);
        mArtist.click("cut: click", mArtist.model(), edges[5]);
        require(edgesIn(PairState::Cut) == 1, u"one edge should be cut"_s);
        requireEntry(u"cut"_s);
        mArtist.use("tool.join");
        mArtist.hover("join: hover", mArtist.model(), edges);
        mArtist.click("join: click", mArtist.model(), edges[14]);
        require(edgesIn(PairState::Joined) == 1, u"one edge should be joined"_s);
        requireEntry(u"join"_s);
    }

    void paint()
    {
        mArtist.use("tool.paint");
        const QList<QPoint> places = mArtist.placesOn(mArtist.model(), 9);
        mArtist.hover("paint: hover", mArtist.model(), places);
        mArtist.drag("paint: stroke", mArtist.model(), places.mid(3, 3));
        const auto &weights = document().seams().weights;
        require(std::any_of(weights.begin(), weights.end(), [](double w) { return w != unpaintedWeight; }),
                u"nothing is painted"_s);
        requireEntry(u"paint"_s);
    }

    void solve()
    {
        StudioSession &studio = mArtist.studio;
        studio.press(Qt::Key_Space);
        const auto hasGoodMap = [&] {
            const auto map = studio.context.solver.map();
            return map && map->withinBound;
        };
        require(QTest::qWaitFor(hasGoodMap, patience), u"the solver finds no map within the bound"_s);
        mArtist.use("tool.cut");
        mArtist.hover("cut while solving: hover", mArtist.model(), mArtist.edgesOn(mArtist.model(), hovers));
        mArtist.hover("cut while solving: hover in the map", mArtist.map(),
                      mArtist.placesOn(mArtist.map(), hovers));
        require(studio.context.solver.isRunning() || studio.context.solver.mode() == SolveMode::Budget,
                u"the solver stopped by itself"_s);
        if (studio.context.solver.isRunning())
            studio.press(Qt::Key_Space);
        require(studio.solverRests() && hasUvs(document()), u"there is no map"_s);
        requireEntry(u"solve"_s);
        studio.press(Qt::Key_A); // the map has grown
    }

    void takeARegionOut()
    {
        mArtist.use("tool.region");
        const QList<QPoint> places = mArtist.placesOn(mArtist.map(), 5);
        require(places.size() == 5, u"the map is not seen"_s);
        if (!mProblem.isEmpty())
            return;
        mArtist.click("region: click", mArtist.map(), places[2]);
        require(QTest::qWaitFor([&] { return !document().selection().faces.isEmpty(); }, patience),
                u"no region is selected"_s);
        mArtist.drag("region: drag", mArtist.map(), {places[2], mArtist.emptyPlace(30)});
        requireEntry(u"region"_s);
    }

    void finish()
    {
        require(mArtist.runJob("uv.finish"), u"not finished"_s);
        requireCleanMap(u"finish"_s);
        requireEntry(u"finish"_s);
        mArtist.studio.press(Qt::Key_A);
    }

    void steerInTheMap()
    {
        const QList<QPoint> edges = mArtist.edgesOn(mArtist.map(), hovers);
        require(edges.size() == hovers, u"no edges are seen in the map"_s);
        if (!mProblem.isEmpty())
            return;
        mArtist.use("tool.cut");
        mArtist.hover("cut in the map: hover", mArtist.map(), edges);
        mArtist.click("cut in the map: click", mArtist.map(), edges[11]);
        requireEntry(u"cut in the map"_s);
        mArtist.use("tool.paint");
        mArtist.drag("paint in the map: stroke", mArtist.map(), mArtist.placesOn(mArtist.map(), 9).mid(2, 3));
        requireEntry(u"paint in the map"_s);
    }

    void arrange()
    {
        mArtist.use("select.islands");
        mArtist.use("tool.select");
        mArtist.hover("select: hover", mArtist.map(), mArtist.placesOn(mArtist.map(), hovers));
        // Looked for anew: a message above the view that ends moves the map.
        mArtist.click("select: click", mArtist.map(), mArtist.placesOn(mArtist.map(), hovers)[12]);
        require(!document().selection().faces.isEmpty(), u"no island is selected"_s);
        mArtist.use("tool.move");
        mArtist.type("islands: keys", mArtist.map(), u"\r"_s); // ends the move that the key began
        const QPoint island = mArtist.placesOn(mArtist.map(), 5)[2];
        mEntries = document().undoStack().index();
        mArtist.drag("islands: drag", mArtist.map(),
                     {island, island + QPoint(40, -25), island + QPoint(70, 10)});
        requireEntry(u"move"_s);
        mArtist.use("tool.rotate");
        mArtist.type("islands: keys", mArtist.map(), u"90\r"_s);
        requireEntry(u"rotate"_s);
        mArtist.use("tool.scale");
        mArtist.type("islands: keys", mArtist.map(), u".8\r"_s);
        requireEntry(u"scale"_s);
    }

    void pin()
    {
        mArtist.use("select.vertices");
        mArtist.use("tool.pin");
        mArtist.hover("pin: hover", mArtist.map(), mArtist.edgesOn(mArtist.map(), hovers));
        std::optional<QPoint> place;
        for (const QPoint &inside : mArtist.placesOn(mArtist.map(), hovers)) {
            const auto corner = mArtist.map().screenOf(3 * mArtist.map().pick(inside).triangle);
            if (!place && corner && mArtist.map().rect().contains(corner->toPoint()) &&
                mArtist.map().pick(*corner).soupCorner >= 0)
                place = corner->toPoint();
        }
        require(place.has_value(), u"no corner is seen"_s);
        if (!mProblem.isEmpty())
            return;
        mArtist.click("pin: click", mArtist.map(), *place);
        require(!document().constraints().pins.empty(), u"nothing is pinned"_s);
        requireEntry(u"pin"_s);
        mArtist.click("pin: click", mArtist.map(), *place);
        require(document().constraints().pins.empty(), u"still pinned"_s);
        requireEntry(u"unpin"_s);
    }

    void box()
    {
        mArtist.use("tool.rectangle");
        const QPoint place = mArtist.emptyPlace(14);
        mArtist.drag("rectangle: draw", mArtist.map(), {place - QPoint(12, 12), place + QPoint(12, 12)});
        require(document().constraints().rectangles.size() == 1, u"no rectangle"_s);
        requireEntry(u"rectangle"_s);
        const QPoint island = mArtist.placesOn(mArtist.map(), 5)[2];
        mArtist.drag("rectangle: drop an island in", mArtist.map(), {island, place});
        require(mProblem.isEmpty() && !document().constraints().rectangles[0].faces.isEmpty(),
                u"the island is not assigned"_s);
        requireEntry(u"assign"_s);
        StudioSession &studio = mArtist.studio;
        studio.press(Qt::Key_Space);
        require(QTest::qWaitFor([&] { return studio.context.solver.map() != nullptr; }, patience),
                u"the solver does not run"_s);
        if (studio.context.solver.isRunning())
            studio.press(Qt::Key_Space);
        require(studio.solverRests(), u"the solver does not rest"_s);
        requireEntry(u"solve with a rectangle"_s);
    }

    //! True when every island of the rectangle lies in it, and each other one in a tile: where a region that
    //! was dragged out of the texture lies in the tile above, it stays there.
    bool liesWhereItBelongs()
    {
        const LayoutRectangle &rectangle = document().constraints().rectangles[0];
        const Vec2 margin = Vec2::Constant(1e-9);
        const Eigen::AlignedBox2d inside(rectangle.lower - Vec2::Constant(1e-6),
                                         rectangle.upper + Vec2::Constant(1e-6));
        const Islands &islands = document().islands();
        for (int i = 0; i < islands.count(); ++i) {
            const std::vector<int> &faces = islands.faces(i);
            const bool assigned = std::any_of(faces.begin(), faces.end(),
                                              [&](int face) { return rectangle.faces.contains(face); });
            const Eigen::AlignedBox2d tile = tileAt(islands.box(i).center(), 1);
            const Eigen::AlignedBox2d around(tile.min() - margin, tile.max() + margin);
            const bool isTile = tile.center().minCoeff() > 0;
            if (!(assigned ? inside : around).contains(islands.box(i)) || !(assigned || isTile))
                return false;
        }
        return true;
    }

    void pack()
    {
        mArtist.use("tool.select");
        require(mArtist.runJob("uv.finish"), u"not finished"_s);
        const int entries = document().undoStack().index() - mEntries; // none where nothing is gained
        require(entries == 0 || entries == 1, u"finish again: more than one entry"_s);
        require(mArtist.runJob("uv.pack"), u"not packed"_s);
        requireCleanMap(u"pack"_s);
        require(mProblem.isEmpty() && liesWhereItBelongs(), u"packed outside of tiles and rectangle"_s);
        mEntries = document().undoStack().index();
    }

    void keep()
    {
        StudioSession &studio = mArtist.studio;
        const QString project = studio.folder.filePath(u"session.acproj"_s);
        const QString mesh = studio.folder.filePath(u"mapped.obj"_s);
        const UvMatrix uv = document().uv();
        studio.context.files.exportMesh(mesh);
        require(studio.jobsRest(), u"not exported"_s);
        const Result<Scene> written = readMesh(mesh);
        require(written && (written->uvSets.front().uv - uv).cwiseAbs().maxCoeff() < 1e-6,
                u"the exported map is another one"_s);
        studio.answers->filesToSave << project;
        studio.press(Qt::Key_S, Qt::ControlModifier);
        require(QTest::qWaitFor([&] { return !studio.context.workspace.isModified(); }, patience),
                u"not saved"_s);
        mSaved = project;
        require(studio.answers->errors.isEmpty(), studio.answers->errors.join(u'\n'));
    }

    void takeAllBack()
    {
        const DocumentState after = withoutSelection(document().state());
        const int entries = document().undoStack().index();
        while (document().undoStack().canUndo())
            document().undoStack().undo();
        require(!hasUvs(document()) || mHadMap, u"a map is left after undoing all"_s);
        require(document().constraints().rectangles.empty() && edgesIn(PairState::Cut) == 0,
                u"steering is left after undoing all"_s);
        while (document().undoStack().canRedo())
            document().undoStack().redo();
        require(document().undoStack().index() == entries && withoutSelection(document().state()) == after,
                u"doing all again ends elsewhere"_s);
        require(document().validate().isEmpty(), document().validate());
        require(mArtist.open(mSaved), u"the session does not open"_s);
        require(withoutSelection(document().state()) == after, u"the session holds another document"_s);
    }

    Artist &mArtist;
    QString mFile, mSaved, mProblem;
    int mEntries = 0;
    bool mHadMap = false;
};

} // namespace

QString runArtistSession(Artist &artist, const QString &file)
{
    return Session(artist, file).run();
}

} // namespace autocuts::test
