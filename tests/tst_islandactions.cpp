// The Layout menu at work: after, after undo and after redo.
#include "commands/setislandflags.h"
#include "commands/setislandtag.h"
#include "solver/metrics/uvmetrics.h"
#include "support/pieces.h"
#include "support/studioparts.h"
#include "support/studiosession.h"
#include "views/canvas/uvview.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace tst_islandactions {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double pi = std::numbers::pi;

//! The studio on four parts in the map, three of them selected.
struct PartsStudio : test::StudioParts
{
    QSignalSpy said{&actions.islands(), &IslandActions::said};

    PartsStudio()
    {
        workspace.open(test::partsDocument({{{0.1, 0.1}}, {{0.5, 0.2}, 0.4}, {{0.9, 0.7}, 2}, {{2, 2}}}), {});
        selectParts({0, 1, 2});
    }
    void selectParts(const QList<int> &parts)
    {
        Selection selection;
        selection.mode = SelectionMode::Islands;
        for (int part : parts) {
            for (int face = 0; face < test::partFaces; ++face)
                selection.faces << test::partFaces * part + face;
        }
        document().setSelection(selection);
    }
    Eigen::AlignedBox2d box(int part) { return document().islands().box(part); }
    Eigen::Index rowOf(int part) { return Eigen::Index(part) * test::partCorners; }
};

bool same(double a, double b)
{
    return std::abs(a - b) < 1e-12;
}

} // namespace

using Check = std::function<bool(PartsStudio &)>;

class TestIslandActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachIsOneEntry_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("text");
        QTest::addColumn<Check>("check");
        const auto row = [](const char *id, const char *text, const Check &check) {
            QTest::newRow(id) << QString::fromLatin1(id) << QString::fromLatin1(text) << check;
        };
        const auto sides = [](auto side) {
            return [side](PartsStudio &s) {
                return same(side(s.box(0)), side(s.box(1))) && same(side(s.box(1)), side(s.box(2)));
            };
        };
        using Box = const Eigen::AlignedBox2d &;
        row("uv.alignLeft", "Align 3 islands", sides([](Box b) { return b.min().x(); }));
        row("uv.alignRight", "Align 3 islands", sides([](Box b) { return b.max().x(); }));
        row("uv.alignTop", "Align 3 islands", sides([](Box b) { return b.max().y(); }));
        row("uv.alignBottom", "Align 3 islands", sides([](Box b) { return b.min().y(); }));
        row("uv.alignCentreU", "Align 3 islands", sides([](Box b) { return b.center().x(); }));
        row("uv.alignCentreV", "Align 3 islands", sides([](Box b) { return b.center().y(); }));
        row("uv.distributeU", "Distribute 3 islands", [](PartsStudio &s) {
            return same(s.box(1).center().x(), 0.5 * (s.box(0).center().x() + s.box(2).center().x()));
        });
        row("uv.distributeV", "Distribute 3 islands", [](PartsStudio &s) {
            return same(s.box(1).center().y(), 0.5 * (s.box(0).center().y() + s.box(2).center().y()));
        });
        row("uv.distributeGapsU", "Distribute 3 islands", [](PartsStudio &s) {
            return same(s.box(1).min().x() - s.box(0).max().x(), s.box(2).min().x() - s.box(1).max().x());
        });
        row("uv.distributeGapsV", "Distribute 3 islands", [](PartsStudio &s) {
            return same(s.box(1).min().y() - s.box(0).max().y(), s.box(2).min().y() - s.box(1).max().y());
        });
        row("uv.mirrorU", "Mirror 3 islands", [](PartsStudio &s) {
            return same(s.document().uv()(0, 0), 0.35) && same(s.document().uv()(0, 1), 0.1);
        });
        row("uv.mirrorV", "Mirror 3 islands", [](PartsStudio &s) {
            return same(s.document().uv()(0, 0), 0.1) && same(s.document().uv()(0, 1), 0.3);
        });
        row("uv.orientBox", "Orient 3 islands", [](PartsStudio &s) {
            const Vec2 size = s.box(1).sizes();
            return same(size.maxCoeff(), 0.25) && same(size.minCoeff(), 0.2);
        });
        row("uv.stackCopies", "Stack 3 islands", [](PartsStudio &s) {
            const UvMatrix &uv = s.document().uv();
            return uv.middleRows(s.rowOf(1), test::partCorners) == uv.topRows(test::partCorners) &&
                   s.document().marks().flagsOf(s.document().islands().faces(2)).stack > 0;
        });
    }

    void eachIsOneEntry()
    {
        QFETCH(QString, id);
        QFETCH(QString, text);
        QFETCH(Check, check);
        PartsStudio studio;
        const DocumentState before = studio.document().state();
        QVERIFY(studio.action(qPrintable(id))->isEnabled());
        QVERIFY(!check(studio));
        studio.trigger(qPrintable(id));
        QVERIFY(check(studio));
        QCOMPARE(studio.document().undoStack().count(), 1);
        QCOMPARE(studio.document().undoStack().undoText(), text);
        QCOMPARE(studio.said.count(), 1);
        QCOMPARE(studio.said.first().first().toString(), text);
        QCOMPARE(studio.document().validate(), QString());
        // What is not selected stays.
        QVERIFY(studio.document().uv().bottomRows(test::partCorners) ==
                before.scene.uvSets[0].uv.bottomRows(test::partCorners));
        const DocumentState after = studio.document().state();
        studio.trigger("edit.undo");
        QVERIFY(studio.document().state() == before);
        studio.trigger("edit.redo");
        QVERIFY(studio.document().state() == after);
        QVERIFY(check(studio));
    }

    void mirroredIslandsAreNoFlips()
    {
        PartsStudio studio;
        studio.trigger("uv.mirrorU");
        QVERIFY(QTest::qWaitFor([&] { return studio.map.figuresAreFresh(); }, 60'000));
        QCOMPARE(studio.map.figures()->metrics.flipped, 0);
        QCOMPARE(studio.map.figures()->metrics.mirroredCharts, 3);
        QVERIFY(studio.action("uv.mirrorU")->toolTip().contains(u"mirrored"_s));
    }

    void lockedIslandsStay()
    {
        PartsStudio studio;
        pushCommand(std::make_unique<SetIslandFlags>(studio.document(), SetIslandFlags::Edit::Lock,
                                                     std::vector<int>{0, 1, 2}));
        const DocumentState before = studio.document().state();
        for (const char *id : {"uv.alignTop", "uv.mirrorV", "uv.orientBox", "uv.distributeU"})
            studio.trigger(id);
        QVERIFY(studio.document().state() == before);
        QCOMPARE(studio.said.last().first().toString(), u"The selected islands are locked"_s);
    }

    void edgesSayHowToTurn()
    {
        PartsStudio studio;
        const MeshData &mesh = studio.document().mesh();
        Selection selection;
        selection.mode = SelectionMode::Edges;
        const int corner = mesh.faceStart[test::partFaces]; // from (0, 0) to (1, 0) of the second part
        selection.edges = {studio.document().adjacency().edgeOfCorner(corner)};
        studio.document().setSelection(selection);
        studio.trigger("uv.orientEdges");
        const UvMatrix &uv = studio.document().uv();
        QVERIFY(same(uv(corner, 1), uv(corner + 1, 1)) && uv(corner + 1, 0) > uv(corner, 0));
        QCOMPARE(studio.document().undoStack().undoText(), UndoText::tr("Orient %n islands", nullptr, 1));
    }

    void stacksAreLaidApart()
    {
        PartsStudio studio;
        studio.trigger("uv.stackCopies");
        const DocumentState stacked = studio.document().state();
        studio.trigger("uv.unstackCopies");
        QVERIFY(!studio.box(0).intersects(studio.box(1)) && !studio.box(1).intersects(studio.box(2)));
        QCOMPARE(studio.document().undoStack().count(), 2);
        QCOMPARE(studio.document().undoStack().undoText(), u"Unstack 3 islands"_s);
        studio.trigger("edit.undo");
        QVERIFY(studio.document().state() == stacked);
    }

    void stackedIslandsDoNotOverlap()
    {
        PartsStudio studio;
        studio.trigger("uv.stackCopies");
        QTRY_VERIFY(studio.map.figuresAreFresh());
        QCOMPARE(studio.map.figures()->metrics.overlapPairs, std::int64_t(0));
        QVERIFY(studio.map.figures()->metrics.stackedPairs > 0);
        QVERIFY(studio.map.figures()->overlapping.empty());

        // Separate finds nothing to do: it does not pack.
        const DocumentState stacked = studio.document().state();
        studio.trigger("uv.separate");
        QVERIFY(studio.rests());
        QVERIFY(studio.document().state() == stacked);

        // Islands that lie on each other without being a stack overlap, and do so as soon as it is taken
        // apart.
        pushCommand(std::make_unique<SetIslandFlags>(studio.document(), SetIslandFlags::Edit::Unstack,
                                                     std::vector{0, 1, 2}));
        QVERIFY(!studio.map.figuresAreFresh());
        QTRY_VERIFY(studio.map.figuresAreFresh());
        QVERIFY(studio.map.figures()->metrics.overlapPairs > 0);
        QVERIFY(!studio.map.figures()->overlapping.empty());
    }

    void packingKeepsAStack()
    {
        PartsStudio studio;
        studio.trigger("uv.stackCopies");
        studio.trigger("uv.pack");
        QVERIFY(studio.rests());
        const UvMatrix &uv = studio.document().uv();
        for (int part : {1, 2})
            QVERIFY((uv.middleRows(studio.rowOf(part), test::partCorners) - uv.topRows(test::partCorners))
                        .cwiseAbs()
                        .maxCoeff() < 1e-12);
        // Every island stays in its tile.
        QVERIFY(Eigen::AlignedBox2d(Vec2(0, 0), Vec2(1, 1)).contains(studio.box(0)));
        QVERIFY(Eigen::AlignedBox2d(Vec2(2, 2), Vec2(3, 3)).contains(studio.box(3)));
        QVERIFY((studio.box(0).center() - studio.box(3).center()).norm() > 0.1);
    }

    void randomIsAsked()
    {
        PartsStudio studio;
        const DocumentState before = studio.document().state();
        studio.trigger("uv.scatter"); // cancelled
        QVERIFY(studio.document().state() == before);
        studio.answers.onDialog = [](QDialog &dialog) {
            dialog.findChild<QDoubleSpinBox *>(u"move"_s)->setValue(100);
            dialog.findChild<QDoubleSpinBox *>(u"angle"_s)->setValue(20);
            dialog.findChild<QDoubleSpinBox *>(u"scale"_s)->setValue(0);
            dialog.findChild<QSpinBox *>(u"seed"_s)->setValue(5);
            return int(QDialog::Accepted);
        };
        studio.trigger("uv.scatter");
        const UvMatrix first = studio.document().uv();
        QVERIFY(first != before.scene.uvSets[0].uv);
        QCOMPARE(studio.document().undoStack().undoText(), u"Randomise 3 islands"_s);
        studio.trigger("edit.undo");
        QVERIFY(studio.document().state() == before);
        studio.trigger("uv.scatter");
        QVERIFY(studio.document().uv() == first);
    }

    //! The selected islands go to the same place in another tile; one entry, undone and done again.
    void islandsAreSentToATile()
    {
        PartsStudio studio;
        const UvMatrix before = studio.document().uv();
        studio.selectParts({0, 3});
        studio.answers.onDialog = [](QDialog &dialog) {
            dialog.findChild<QDoubleSpinBox *>()->setValue(1012);
            return int(QDialog::Accepted);
        };
        studio.trigger("uv.sendToTile");
        const UvMatrix after = studio.document().uv();
        for (int part = 0; part < 4; ++part) {
            const Vec2 way(part == 0   ? 1
                           : part == 3 ? -1
                                       : 0,
                           part == 0   ? 1
                           : part == 3 ? -1
                                       : 0); // from 1001 and 1023
            const auto rows = Eigen::seqN(studio.rowOf(part), test::partCorners);
            QVERIFY(((after - before)(rows, Eigen::all).rowwise() - way.transpose()).cwiseAbs().maxCoeff() <
                    1e-12);
        }
        QCOMPARE(studio.said.last().first().toString(), u"Islands sent to tile 1012: 2"_s);
        QCOMPARE(studio.document().undoStack().count(), 1);
        studio.trigger("edit.undo");
        QVERIFY(studio.document().uv() == before);
        studio.trigger("edit.redo");
        QVERIFY(studio.document().uv() == after);
    }

    //! All islands of a tile are locked, and unlocked again.
    void aTileIsLocked()
    {
        PartsStudio studio; // the parts 0 to 2 lie in 1001, of which one is locked, 3 in 1023
        const auto locked = [&] {
            QString text;
            for (int part = 0; part < 4; ++part)
                text += studio.document().marks().flagsOf(studio.document().islands().faces(part)).locked != 0
                            ? u'L'
                            : u'-';
            return text;
        };
        studio.selectParts({1});
        studio.trigger("uv.lock");
        studio.selectParts({0});
        studio.trigger("uv.lockTile");
        QCOMPARE(locked(), u"LLL-"_s);
        studio.trigger("uv.lockTile");
        QCOMPARE(locked(), u"----"_s);
        studio.trigger("edit.undo");
        QCOMPARE(locked(), u"LLL-"_s);
    }

    //! The dialog gives a tag, takes it away, and selects by it.
    void tagsAreGiven()
    {
        PartsStudio studio;
        QStringList enabled;
        // Types a name, then clicks a button or, without one, closes the dialog.
        const auto answer = [&](const QString &name, const QString &button) {
            studio.answers.onDialog = [&, name, button](QDialog &dialog) {
                if (dialog.focusWidget() != dialog.findChild<QComboBox *>(u"name"_s))
                    return int(QDialog::Rejected); // typing goes nowhere
                dialog.findChild<QComboBox *>(u"name"_s)->setEditText(name);
                enabled.clear();
                for (const auto *each : dialog.findChildren<QPushButton *>()) {
                    if (each->isEnabled() && !each->objectName().isEmpty())
                        enabled << each->objectName();
                }
                if (button.isEmpty())
                    dialog.reject();
                else
                    dialog.findChild<QPushButton *>(button)->click();
                return dialog.result();
            };
            studio.trigger("select.tags");
        };
        const auto facesOf = [&](const QString &name) {
            const IslandTag *tag = studio.document().marks().tag(name);
            return tag ? tag->faces.size() / test::partFaces : 0;
        };
        studio.selectParts({0, 2});
        answer(u"arm"_s, {});
        QCOMPARE(enabled, QStringList{u"tag"_s}); // there is no such tag yet
        QCOMPARE(facesOf(u"arm"_s), 0);
        answer(u" arm "_s, u"tag"_s);
        QCOMPARE(facesOf(u"arm"_s), 2);
        QCOMPARE(studio.said.last()[0].toString(), u"Tag 2 islands"_s);
        answer({}, {});
        QCOMPARE(enabled, QStringList());
        studio.document().setSelection({});
        answer(u"arm"_s, u"select"_s);
        QCOMPARE(enabled, QStringList{u"select"_s});
        QCOMPARE(studio.document().selection().faces.size(), 2 * test::partFaces);
        studio.selectParts({2});
        answer(u"arm"_s, u"untag"_s);
        QCOMPARE(facesOf(u"arm"_s), 1);
        studio.trigger("edit.undo");
        QCOMPARE(facesOf(u"arm"_s), 2);
        studio.trigger("edit.undo");
        QCOMPARE(facesOf(u"arm"_s), 0);
    }

    //! The islands of a tag get a tile of their own, the others the last one.
    void tagsGetTiles()
    {
        PartsStudio studio;
        QSignalSpy failed(&studio.map, &MapController::failed);
        studio.trigger("uv.packTags"); // there are none
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().contains(u"No island has a tag"_s));
        QVERIFY(studio.rests());
        QCOMPARE(studio.document().undoStack().count(), 0);
        for (const auto &[name, part] : {std::pair(u"arm"_s, 3), std::pair(u"leg"_s, 1)})
            pushCommand(
                std::make_unique<SetIslandTag>(studio.document(), name, std::vector<int>{part}, true));
        studio.document().setSelection({});
        studio.trigger("uv.packTags");
        QVERIFY(studio.rests());
        QList<int> tiles;
        for (int part = 0; part < 4; ++part)
            tiles << 1001 + int(std::floor(studio.box(part).center().x()));
        QCOMPARE(tiles, (QList<int>{1003, 1002, 1003, 1001}));
    }

    void densityIsAsked()
    {
        PartsStudio studio;
        double proposed = 0;
        studio.answers.onDialog = [&](QDialog &dialog) {
            auto *density = dialog.findChild<QDoubleSpinBox *>(u"density"_s);
            proposed = density->value();
            density->setValue(409.6);
            return int(QDialog::Accepted);
        };
        studio.trigger("uv.densitySet");
        QVERIFY(std::abs(proposed - 204.8) < 1e-3);
        QVERIFY((studio.box(0).sizes() - Vec2(0.5, 0.4)).norm() < 1e-9);
        QVERIFY((studio.box(0).center() - Vec2(0.225, 0.2)).norm() < 1e-9);
        QVERIFY((studio.box(3).sizes() - Vec2(0.25, 0.2)).norm() < 1e-9);
        studio.trigger("edit.undo");
        QVERIFY((studio.box(0).sizes() - Vec2(0.25, 0.2)).norm() < 1e-9);
    }

    void texelWeightsAreSetAndCleared()
    {
        PartsStudio studio;
        studio.answers.onDialog = [](QDialog &dialog) {
            dialog.findChild<QDoubleSpinBox *>()->setValue(2.5);
            return int(QDialog::Accepted);
        };
        const QList<int> faces = studio.document().selection().faces;
        studio.trigger("uv.texelWeight");
        for (int face = 0; face < studio.document().mesh().faceCount(); ++face)
            QCOMPARE(studio.document().texelWeights()[face], faces.contains(face) ? 2.5 : 1.0);
        studio.selectParts({0});
        studio.trigger("uv.clearTexelWeight");
        QCOMPARE(studio.document().texelWeights()[0], 1.0);
        QCOMPARE(studio.document().texelWeights()[test::partFaces], 2.5);
        studio.trigger("uv.clearTexelWeights");
        QVERIFY(studio.document().state().texelWeights.empty());
        QCOMPARE(studio.document().undoStack().count(), 3);
        studio.trigger("edit.undo");
        studio.trigger("edit.undo");
        QCOMPARE(studio.document().texelWeights()[0], 2.5);
        // A density that is set is that of faces without a weight: these get 2.5 times as much.
        studio.answers.onDialog = [](QDialog &dialog) {
            dialog.findChild<QDoubleSpinBox *>(u"density"_s)->setValue(204.8);
            return int(QDialog::Accepted);
        };
        studio.selectParts({0});
        const double before = studio.box(0).sizes().x();
        studio.trigger("uv.densitySet");
        QVERIFY(std::abs(studio.box(0).sizes().x() - 2.5 * before) < 1e-6);
    }

    void chainsAreMadeStraight()
    {
        test::StudioParts studio;
        studio.workspace.open(test::layoutDocument(test::grid(8)), {});
        Document &document = studio.document();
        // One island, bent.
        UvMatrix uv = document.uv();
        for (int c = 0; c < document.mesh().cornerCount(); ++c) {
            const Vec3 p = document.mesh().cornerPosition(c);
            uv.row(c) << p.x(), 0.6 * p.y() + 0.4 * p.x() * (1 - p.x());
        }
        pushCommand(std::make_unique<SetUvs>(document, UvEdit::Move, uv));
        QCOMPARE(document.islands().count(), 1);
        Selection selection;
        selection.mode = SelectionMode::Edges;
        for (int face = 32; face < 40; ++face)
            selection.edges << document.adjacency().edgeOfCorner(document.mesh().faceStart[face]);
        document.setSelection(selection);
        const DocumentState before = document.state();
        studio.trigger("uv.straighten");
        QVERIFY(studio.rests());
        QCOMPARE(document.undoStack().undoText(), UndoText::tr("Straighten %n chains of edges", nullptr, 1));
        double low = 1, high = 0;
        for (int face = 32; face < 40; ++face) {
            const double v = document.uv()(document.mesh().faceStart[face], 1);
            low = std::min(low, v);
            high = std::max(high, v);
        }
        QVERIFY(high - low < 1e-9); // the chain was level at its ends
        const DocumentState after = document.state();
        studio.trigger("edit.undo");
        QVERIFY(document.state() == before);
        studio.trigger("edit.redo");
        QVERIFY(document.state() == after);
    }

    void quadsBecomeAGrid()
    {
        test::StudioParts studio;
        studio.workspace.open(test::layoutDocument(test::grid(8)), {});
        Document &document = studio.document();
        // A wave, so that no row is straight.
        UvMatrix uv(document.mesh().cornerCount(), 2);
        for (int c = 0; c < uv.rows(); ++c) {
            const Vec3 p = document.mesh().cornerPosition(c);
            uv.row(c) << p.x() + 0.05 * std::sin(5 * p.y()), 0.6 * p.y() + 0.4 * p.x() * (1 - p.x());
        }
        pushCommand(std::make_unique<SetUvs>(document, UvEdit::Move, uv));
        const auto isStraight = [&](int face) {
            for (int k = 0; k < 4; ++k) {
                const int first = document.mesh().faceStart[face];
                const Vec2 edge = document.uv().row(first + (k + 1) % 4) - document.uv().row(first + k);
                if (edge.cwiseAbs().minCoeff() > 1e-12 || edge.norm() < 1e-3)
                    return false;
            }
            return true;
        };
        const auto select = [&](const QList<int> &faces) {
            Selection selection;
            selection.mode = SelectionMode::Faces;
            selection.faces = faces;
            document.setSelection(selection);
        };
        // A block in the middle: the faces around it follow.
        const QList<int> block{18, 19, 20, 26, 27, 28};
        select(block);
        const DocumentState before = document.state();
        studio.trigger("uv.grid");
        QVERIFY(studio.rests());
        QCOMPARE(document.undoStack().undoText(), u"Straighten 6 faces to a grid"_s);
        QVERIFY(std::all_of(block.begin(), block.end(), isStraight));
        QVERIFY(!isStraight(0));
        QCOMPARE(document.islands().count(), 1);
        metrics::UvMetrics figures = metrics::measureUv(document.mesh(), document.uv());
        QCOMPARE(figures.flipped, 0);
        QCOMPARE(figures.overlapPairs, std::int64_t(0));
        const DocumentState after = document.state();
        studio.trigger("edit.undo");
        QVERIFY(document.state() == before);
        studio.trigger("edit.redo");
        QVERIFY(document.state() == after);

        // The whole island.
        QList<int> all(document.mesh().faceCount());
        std::iota(all.begin(), all.end(), 0);
        select(all);
        studio.trigger("uv.grid");
        QVERIFY(studio.rests());
        QVERIFY(std::all_of(all.begin(), all.end(), isStraight));
        figures = metrics::measureUv(document.mesh(), document.uv());
        QVERIFY(figures.symDirichlet < 4 + 1e-9);

        // Locked islands stay, and it is said.
        pushCommand(std::make_unique<SetIslandFlags>(document, SetIslandFlags::Edit::Lock, std::vector{0}));
        const int count = document.undoStack().count();
        QSignalSpy failed(&studio.map, &MapController::failed);
        studio.trigger("uv.grid");
        QVERIFY(studio.rests());
        QCOMPARE(document.undoStack().count(), count);
        QCOMPARE(failed.count(), 1);
    }

    void selectionsAreRelaxed()
    {
        test::StudioParts studio;
        studio.workspace.open(test::layoutDocument(test::grid(8)), {});
        Document &document = studio.document();
        UvMatrix uv = document.uv();
        const Eigen::RowVector2d inner = uv.row(document.mesh().faceStart[18]);
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            if (uv.row(c) == inner)
                uv.row(c) += Eigen::RowVector2d(0.05, 0.04);
        }
        pushCommand(std::make_unique<SetUvs>(document, UvEdit::Move, uv));
        Selection selection;
        selection.faces = {9, 10, 17, 18};
        document.setSelection(selection);
        const DocumentState before = document.state();
        studio.trigger("uv.relax");
        QVERIFY(studio.rests());
        QCOMPARE(document.undoStack().undoText(), u"Relax 4 faces"_s);
        QVERIFY((document.uv().row(document.mesh().faceStart[18]) - inner).norm() < 1e-6);
        for (Eigen::Index c = 0; c < uv.rows(); ++c) {
            if (uv.row(c) != uv.row(document.mesh().faceStart[18]))
                QVERIFY(document.uv().row(c) == uv.row(c));
        }
        const DocumentState after = document.state();
        studio.trigger("edit.undo");
        QVERIFY(document.state() == before);
        studio.trigger("edit.redo");
        QVERIFY(document.state() == after);
    }

    void keysInTheWindow()
    {
        test::StudioSession session;
        session.context.workspace.open(test::partsDocument({{{0.1, 0.1}}, {{0.5, 0.4}}}), {});
        Selection selection;
        selection.faces = {0, 1, 2, 3, 4, 5};
        session.document()->setSelection(selection);
        session.window.uvView().setFocus();
        session.press(Qt::Key_Left, Qt::ControlModifier);
        const Islands &islands = session.document()->islands();
        QCOMPARE(islands.box(1).min().x(), islands.box(0).min().x());
        session.press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(session.document()->islands().box(1).min().x(), 0.5);
    }
};

QTEST_MAIN(TestIslandActions)

} // namespace tst_islandactions

#include "tst_islandactions.moc"
