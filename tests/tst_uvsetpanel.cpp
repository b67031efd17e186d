// The UV sets of a model in the window: choosing, adding, renaming and deleting them by mouse and keys.
#include "commands/edituvsets.h"
#include "support/studiosession.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/uvsetpanel.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>

namespace tst_uvsetpanel {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

class Sets
{
public:
    explicit Sets(StudioSession &studio) : mStudio(studio)
    {
        studio.action("file.sample.bumpycube")->trigger();
        studio.jobsRest();
        auto *dock = studio.window.findChild<QDockWidget *>(u"uvSets"_s);
        dock->show();
        dock->raise();
        mList = dock->findChild<QListWidget *>(u"uvSets"_s);
        QCoreApplication::processEvents();
    }

    QListWidget &list() const { return *mList; }
    QStringList names() const
    {
        QStringList names;
        for (int i = 0; i < mList->count(); ++i)
            names << mList->item(i)->text();
        return names;
    }
    bool show(const QStringList &expected, int current) const
    {
        return QTest::qWaitFor([&] { return names() == expected && mList->currentRow() == current; });
    }
    void click(const char *button) const
    {
        QTest::mouseClick(mStudio.window.findChild<QToolButton *>(QLatin1String(button)), Qt::LeftButton);
    }
    void clickRow(int row) const { QTest::mouseClick(mList->viewport(), Qt::LeftButton, {}, middleOf(row)); }
    QPoint middleOf(int row) const { return mList->visualItemRect(mList->item(row)).center(); }
    void rename(int row, const QString &name) const
    {
        clickRow(row);
        QTest::keyClick(mList, Qt::Key_F2);
        auto *editor = qobject_cast<QLineEdit *>(QApplication::focusWidget());
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents();
    }

private:
    StudioSession &mStudio;
    QListWidget *mList;
};

} // namespace

class TestUvSetPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void setsAreAddedChosenAndDeleted()
    {
        StudioSession studio;
        const Sets sets(studio);
        const QString first = studio.document()->uvSets()[0].name;
        QVERIFY(sets.show({first}, 0));
        studio.press(Qt::Key_U);
        QVERIFY(studio.jobsRest());
        const UvMatrix map = studio.document()->uv();
        sets.click("uvset.copy");
        QTRY_COMPARE(sets.list().count(), 2);
        QCOMPARE(sets.list().currentRow(), 1);
        QVERIFY(sets.names()[1].startsWith(first));
        QCOMPARE(studio.document()->uv(), map);
        sets.click("uvset.add");
        QTRY_COMPARE(sets.list().count(), 3);
        QCOMPARE(studio.document()->activeUvSet(), 2);
        QVERIFY(!studio.document()->uv().allFinite());
        sets.clickRow(0);
        QTRY_COMPARE(studio.document()->activeUvSet(), 0);
        QCOMPARE(studio.document()->uv(), map);
        studio.press(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(studio.document()->activeUvSet(), 1);
        sets.click("uvset.delete");
        QTRY_COMPARE(sets.list().count(), 2);
        for (int i = 0; i < 2; ++i)
            sets.click("uvset.delete");
        QTRY_COMPARE(sets.list().count(), 1); // the last one stays
        for (const char *id : {"uvset.delete", "uvset.next"}) {
            QVERIFY(!studio.action(id)->isEnabled());
            QVERIFY(studio.action(id)->toolTip().contains(u"only one UV set"_s));
        }
        while (studio.document()->undoStack().canUndo())
            studio.document()->undoStack().undo();
        QVERIFY(sets.show({first}, 0));
        QCOMPARE(studio.document()->validate(), QString());
    }

    void namesAreEdited()
    {
        StudioSession studio;
        const Sets sets(studio);
        const QString first = studio.document()->uvSets()[0].name;
        sets.rename(0, u"Colour"_s);
        QVERIFY(sets.show({u"Colour"_s}, 0));
        QCOMPARE(studio.document()->undoStack().undoText(), u"Rename UV set"_s);
        sets.click("uvset.add");
        QTRY_COMPARE(sets.list().count(), 2);
        const QString second = sets.names()[1];
        sets.rename(1, u"Colour"_s); // in use
        QVERIFY(sets.show({u"Colour"_s, second}, 1));
        sets.rename(1, u" "_s);
        QVERIFY(sets.show({u"Colour"_s, second}, 1));
        studio.document()->undoStack().undo();
        studio.document()->undoStack().undo();
        QVERIFY(sets.show({first}, 0));
    }

    //! The live map belongs to the set that it was made for.
    void aLiveSolvePausesFirst()
    {
        StudioSession studio;
        const Sets sets(studio);
        studio.press(Qt::Key_U);
        QVERIFY(studio.jobsRest());
        sets.click("uvset.add");
        QTRY_COMPARE(sets.list().count(), 2);
        studio.press(Qt::Key_Space);
        QVERIFY(studio.context.solver.isRunning());
        QVERIFY(studio.runsTo(3));
        sets.clickRow(0);
        QVERIFY(studio.solverRests());
        QTRY_COMPARE(studio.document()->activeUvSet(), 0);
        QVERIFY(studio.document()->uvSets()[1].uv.allFinite());
        QVERIFY(sets.show(sets.names(), 0));
    }

    void jobsKeepTheirSet()
    {
        StudioSession studio;
        const Sets sets(studio);
        sets.click("uvset.add");
        QTRY_COMPARE(sets.list().count(), 2);
        studio.press(Qt::Key_U);
        QVERIFY(studio.context.map.jobs().isBusy());
        sets.clickRow(0);
        studio.press(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(studio.document()->activeUvSet(), 1);
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.document()->uvSets()[1].uv.allFinite());
        QVERIFY(!studio.document()->uvSets()[0].uv.allFinite());
        QVERIFY(sets.show(sets.names(), 1));
    }

    void lightmapsHaveAPlaceForEveryFace()
    {
        StudioSession studio;
        const Sets sets(studio);
        studio.press(Qt::Key_U);
        QVERIFY(studio.jobsRest());
        // Everything in one place.
        studio.press(Qt::Key_4);
        studio.press(Qt::Key_A, Qt::ControlModifier);
        studio.action("uv.alignLeft")->trigger();
        studio.action("uv.alignBottom")->trigger();
        const UvMatrix map = studio.document()->uv();
        sets.click("uvset.lightmap");
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.measured());
        QCOMPARE(studio.document()->uvSets()[1].name, u"Lightmap"_s);
        QCOMPARE(studio.context.map.figures()->metrics.overlapPairs, 0);
        QCOMPARE(studio.document()->uvSets()[0].uv, map);
        studio.press(Qt::Key_Z, Qt::ControlModifier);
        studio.press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(studio.document()->uvSets().size(), std::size_t(1));
    }

    void lightmapsOfModelsWithoutMaps()
    {
        StudioSession studio;
        const Sets sets(studio);
        sets.click("uvset.lightmap");
        QVERIFY(studio.jobsRest());
        QVERIFY(studio.document()->uvSets()[1].uv.allFinite());
        QVERIFY(!studio.document()->uvSets()[0].uv.allFinite());
    }
};

QTEST_MAIN(TestUvSetPanel)

} // namespace tst_uvsetpanel

#include "tst_uvsetpanel.moc"
