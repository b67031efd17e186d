// Selecting along rows: rings, strips, every second one, growing and shrinking; and edges that are alike.
#include "commands/setuvs.h"
#include "support/gridstudio.h"
#include "views/dialogs/numberdialog.h"

#include <QDoubleSpinBox>
#include <QTest>

#include <algorithm>

namespace tst_selectrows {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::GridStudio;

namespace {

//! Four columns and four rows of quads; face 4 * row + column.
struct Grid : GridStudio
{
    Vec2 middleOf(int edge)
    {
        const auto [a, b] = document().adjacency().edgeVertices(edge);
        const Vec3 middle = (document().mesh().positions.row(a) + document().mesh().positions.row(b)) / 2;
        return middle.head<2>();
    }
    //! The edge with its middle there, in eighths of the grid.
    int edgeAt(int x, int y)
    {
        for (int edge = 0; edge < document().adjacency().edgeCount(); ++edge) {
            if (!document().adjacency().isDiagonal(edge) && (8 * middleOf(edge) - Vec2(x, y)).norm() < 1e-9)
                return edge;
        }
        return -1;
    }
    QList<int> edgesAt(const QList<QPoint> &places)
    {
        QList<int> edges;
        for (const QPoint &place : places)
            edges.append(edgeAt(place.x(), place.y()));
        std::sort(edges.begin(), edges.end());
        return edges;
    }
    //! Selects the corners at vertices, in quarters of the grid.
    void selectVertices(const QList<QPoint> &places)
    {
        Selection selection;
        selection.mode = SelectionMode::Vertices;
        selection.corners = cornersAt(places);
        document().setSelection(selection);
    }
    QList<int> cornersAt(const QList<QPoint> &places)
    {
        QList<int> corners;
        for (int corner = 0; corner < document().mesh().cornerCount(); ++corner) {
            const Vec3 position = 4 * document().mesh().cornerPosition(corner);
            if (places.contains(QPoint(qRound(position.x()), qRound(position.y()))))
                corners.append(corner);
        }
        return corners;
    }
    //! Makes the island of the right two columns three times as wide in the map.
    void widenTheRightIsland()
    {
        UvMatrix uv = document().uv();
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            if (uv(c, 0) > 1)
                uv(c, 0) *= 3;
        }
        pushCommand(std::make_unique<SetUvs>(document(), UvEdit::Scale, uv));
    }
};

using Places = QList<QPoint>;

} // namespace

class TestSelectRows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void faces_data()
    {
        QTest::addColumn<QString>("action");
        QTest::addColumn<QList<int>>("from");
        QTest::addColumn<QList<int>>("to");
        const auto row = [](const char *name, const char *action, QList<int> from, QList<int> to) {
            QTest::newRow(name) << QString::fromLatin1(action) << from << to;
        };
        row("strip of two", "select.strip", {5, 6}, {4, 5, 6, 7});
        row("strip upwards", "select.strip", {1, 5}, {1, 5, 9, 13});
        row("strips of one", "select.strip", {5}, {1, 4, 5, 6, 7, 9, 13});
        row("strips of a corner", "select.strip", {0, 1, 4}, {0, 1, 2, 3, 4, 8, 12});
        row("checkerboard", "select.everySecond", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
            {0, 2, 5, 7, 8, 10, 13, 15});
        row("every second of a row, and one alone", "select.everySecond", {4, 5, 6, 7, 12}, {4, 6, 12});
        row("grow a row", "select.growAlong", {5, 6}, {4, 5, 6, 7});
        row("a row from border to border", "select.growAlong", {4, 5, 6, 7}, {4, 5, 6, 7});
        row("one face has no row", "select.growAlong", {5}, {5});
        row("grow a block", "select.growAlong", {5, 6, 9, 10}, {1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14});
        row("shrink a row", "select.shrinkAlong", {4, 5, 6, 7}, {5, 6});
        row("shrink what is not a row", "select.shrinkAlong", {0, 5, 10}, {0, 5, 10});
    }
    void faces()
    {
        QFETCH(const QString, action);
        QFETCH(const QList<int>, from);
        QFETCH(const QList<int>, to);
        Grid studio;
        studio.selectFaces(from);
        studio.trigger(qPrintable(action));
        QCOMPARE(studio.selection().faces, to);
        QCOMPARE(studio.selection().mode, SelectionMode::Faces);
        QCOMPARE(studio.entries(), 0);
    }

    void edges_data()
    {
        QTest::addColumn<QString>("action");
        QTest::addColumn<Places>("from");
        QTest::addColumn<Places>("to");
        const auto row = [](const char *name, const char *action, const Places &from, const Places &to) {
            QTest::newRow(name) << QString::fromLatin1(action) << from << to;
        };
        const Places ring{{0, 1}, {2, 1}, {4, 1}, {6, 1}, {8, 1}}, column{{4, 1}, {4, 3}, {4, 5}, {4, 7}};
        row("ring", "select.ring", {{4, 1}}, ring);
        row("ring from the border", "select.ring", {{8, 1}}, ring);
        row("two rings", "select.ring", {{4, 1}, {1, 4}},
            ring + Places{{1, 0}, {1, 2}, {1, 4}, {1, 6}, {1, 8}});
        row("grow one", "select.growAlong", {{4, 3}}, {{4, 1}, {4, 3}, {4, 5}});
        row("grow to the border", "select.growAlong", {{4, 1}, {4, 3}, {4, 5}}, column);
        row("shrink", "select.shrinkAlong", column, {{4, 3}, {4, 5}});
        row("one edge stays", "select.shrinkAlong", {{4, 3}}, {{4, 3}});
    }
    void edges()
    {
        QFETCH(const QString, action);
        QFETCH(const Places, from);
        QFETCH(const Places, to);
        Grid studio;
        studio.selectEdges(studio.edgesAt(from));
        QVERIFY(!studio.selection().edges.contains(-1));
        studio.trigger(qPrintable(action));
        QCOMPARE(studio.selection().edges, studio.edgesAt(to));
    }

    //! Which one comes first depends on the numbers of the edges; the kept ones are two apart.
    void everySecondEdge_data()
    {
        QTest::addColumn<Places>("from");
        QTest::newRow("loop") << Places{{4, 1}, {4, 3}, {4, 5}, {4, 7}};
        QTest::newRow("ring") << Places{{0, 1}, {2, 1}, {4, 1}, {6, 1}, {8, 1}};
    }
    void everySecondEdge()
    {
        QFETCH(const Places, from);
        Grid studio;
        studio.selectEdges(studio.edgesAt(from));
        studio.trigger("select.everySecond");
        const Places even{from.value(0), from.value(2), from.value(4, from.value(0))},
            odd{from.value(1), from.value(3)};
        QList<int> expected = studio.edgesAt(even);
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        QVERIFY(studio.selection().edges == expected || studio.selection().edges == studio.edgesAt(odd));
    }

    void vertices()
    {
        Grid studio;
        studio.selectVertices({{2, 1}, {2, 2}});
        studio.trigger("select.growAlong");
        QCOMPARE(studio.selection().corners, studio.cornersAt({{2, 0}, {2, 1}, {2, 2}, {2, 3}}));
        studio.trigger("select.growAlong");
        const QList<int> column = studio.cornersAt({{2, 0}, {2, 1}, {2, 2}, {2, 3}, {2, 4}});
        QCOMPARE(studio.selection().corners, column);
        studio.trigger("select.shrinkAlong");
        QCOMPARE(studio.selection().corners, studio.cornersAt({{2, 1}, {2, 2}, {2, 3}}));
        studio.trigger("select.everySecond");
        QVERIFY(studio.selection().corners == studio.cornersAt({{2, 1}, {2, 3}}) ||
                studio.selection().corners == studio.cornersAt({{2, 2}}));
    }

    void islands()
    {
        Grid studio;
        studio.trigger("select.islands");
        studio.trigger("select.all");
        studio.trigger("select.everySecond");
        QCOMPARE(studio.selection().faces, QList<int>({0, 1, 4, 5, 8, 9, 12, 13}));
        studio.trigger("select.growAlong");
        QCOMPARE(studio.selection().faces.size(), 8);
    }

    void edgesThatAreAlike()
    {
        Grid studio;
        studio.widenTheRightIsland();
        studio.selectEdges({studio.edgeAt(4, 1)});
        studio.trigger("select.similarDirection");
        QCOMPARE(studio.selection().edges.size(), 20);
        for (const int edge : studio.selection().edges)
            QVERIFY(qRound(8 * studio.middleOf(edge).x()) % 2 == 0);
        studio.selectEdges({studio.edgeAt(5, 2)});
        studio.trigger("select.similarLengthInMap");
        QCOMPARE(studio.selection().edges.size(), 10);
        for (const int edge : studio.selection().edges)
            QVERIFY(studio.middleOf(edge).x() > 0.5);
        studio.trigger("select.similarLength");
        QVERIFY(studio.selection().edges.size() > 10);
    }

    void facesAlikeInTheMap()
    {
        Grid studio;
        studio.widenTheRightIsland();
        studio.selectFaces({2});
        studio.trigger("select.similarAreaInMap");
        QCOMPARE(studio.selection().faces, QList<int>({2, 3, 6, 7, 10, 11, 14, 15}));
    }

    //! Faces that are flat together, up to an angle that is asked for and kept.
    void flatFacesAskForTheAngle()
    {
        GridStudio studio;
        // A strip of four squares, bent by 5, 20 and 5 degrees.
        std::vector<Vec3> points;
        std::vector<std::vector<int>> faces;
        Vec3 at = Vec3::Zero();
        double angle = 0;
        for (int k = 0; k <= 4; ++k) {
            points.push_back(at);
            points.emplace_back(at + Vec3(0, 1, 0));
            if (k < 4)
                faces.push_back({2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
            at += Vec3(std::cos(angle), 0, std::sin(angle));
            angle += (k == 1 ? 20 : 5) * 3.14159265358979 / 180;
        }
        studio.workspace.open(std::make_unique<Document>(test::sceneOf(test::polygonMesh(points, faces))),
                              {});
        const auto flatWith = [&](double degrees) {
            studio.selectFaces({0});
            studio.answers.onDialog = [degrees](QDialog &dialog) {
                dialog.findChild<QDoubleSpinBox *>(u"number"_s)->setValue(degrees);
                return static_cast<int>(QDialog::Accepted);
            };
            studio.trigger("select.flat");
            return studio.selection().faces;
        };
        QCOMPARE(flatWith(1), QList<int>{0});
        QCOMPARE(flatWith(10), QList<int>({0, 1}));
        QCOMPARE(flatWith(30), QList<int>({0, 1, 2, 3}));
    }
};

QTEST_MAIN(TestSelectRows)

} // namespace tst_selectrows

#include "tst_selectrows.moc"
