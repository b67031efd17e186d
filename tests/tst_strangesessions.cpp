// Sessions of strangers in the studio: whatever their parts hold, they open or are refused, and what is open
// can be worked on.
//
// In each of them values have been exchanged, left out, or put elsewhere; the checksums are right. SESSIONS
// in the environment is their number, and the seed is SEED; scripts/soak tries more of them.
#include "model/io/files/savefile.h"
#include "support/randomedits.h"
#include "support/sessions.h"
#include "support/studiosession.h"
#include "views/actions/actionregistry.h"
#include "views/control/files/filecontroller.h"
#include "views/control/session/workspace.h"

#include <QAction>
#include <QCborArray>
#include <QCborMap>
#include <QTest>

#include <cmath>
#include <limits>

namespace tst_strangesessions {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

constexpr int usualSessions = 15;

int number(const char *variable, int otherwise)
{
    return qEnvironmentVariableIsSet(variable) ? qEnvironmentVariableIntValue(variable) : otherwise;
}

QCborValue oddValue(test::Random &random)
{
    const QCborValue values[] = {QCborValue(),
                                 true,
                                 0,
                                 -1,
                                 qint64(1) << 31,
                                 std::numeric_limits<qint64>::max(),
                                 std::numeric_limits<qint64>::min(),
                                 std::nan(""),
                                 1e300,
                                 QString(),
                                 QString(10'000, u'x'),
                                 QByteArray(),
                                 QByteArray(7, '\xff'),
                                 QCborArray(),
                                 QCborMap()};
    return values[random.below(int(std::size(values)))];
}

//! The tree with one of its values exchanged, left out or doubled.
QCborValue mutated(const QCborValue &value, test::Random &random)
{
    if (value.isMap() && !value.toMap().isEmpty() && !random.oneIn(7)) {
        QCborMap map = value.toMap();
        const QCborValue key = map.keys().at(random.below(int(map.size())));
        if (random.oneIn(7))
            map.remove(key);
        else
            map[key] = mutated(map.value(key), random);
        return map;
    }
    if (value.isArray() && !value.toArray().isEmpty() && !random.oneIn(7)) {
        QCborArray array = value.toArray();
        const int place = random.below(int(array.size()));
        if (random.oneIn(7))
            array.removeAt(place);
        else if (random.oneIn(7))
            array.insert(place, array.at(place));
        else
            array[place] = mutated(array.at(place), random);
        return array;
    }
    return oddValue(random);
}

void change(PartMap &parts, test::Random &random)
{
    QByteArray &content = std::next(parts.begin(), random.below(int(parts.size())))->second;
    QCborParserError problem;
    QCborValue tree = QCborValue::fromCbor(content, &problem);
    const bool isTree = problem.error == QCborError::NoError && problem.offset == content.size();
    for (int i = random.below(3); isTree && i >= 0; --i)
        tree = mutated(tree, random);
    if (isTree)
        content = tree.toCbor();
    else if (!content.isEmpty())
        content[random.below(int(content.size()))] = char(random.below(256));
}

} // namespace

class TestStrangeSessions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyOpenOrAreRefused_data()
    {
        QTest::addColumn<bool>("obj");
        QTest::newRow("of an OBJ file") << true;
        QTest::newRow("of polygons") << false;
    }
    void theyOpenOrAreRefused()
    {
        QFETCH(const bool, obj);
        const QByteArray whole = test::bytesOf(obj ? test::cubeSession() : test::gridSession(6, 20, 4));
        test::Random random(std::uint64_t(number("SEED", 1)));
        const int count = number("SESSIONS", usualSessions);
        const QTemporaryDir folder;
        StudioSession studio;
        int opened = 0;
        for (int i = 0; i < count; ++i) {
            const QString path = folder.filePath(u"%1.acproj"_s.arg(i));
            const QByteArray bytes =
                test::repacked(whole, [&random](PartMap &parts) { change(parts, random); });
            QVERIFY(saveAtomically(path, bytes).ok());
            studio.answers->errors.clear();
            studio.context.files.open(path);
            QVERIFY2(studio.jobsRest(), qPrintable(path));
            if (studio.context.workspace.sessionPath() != path) {
                QVERIFY2(!studio.answers->errors.isEmpty(), qPrintable(path));
                continue;
            }
            ++opened;
            QCOMPARE(studio.document()->state().validate(), QString());
            for (const char *id : {"edit.undo", "edit.undo", "edit.redo", "select.all", "select.invert"})
                studio.action(id)->trigger();
            QVERIFY2(studio.jobsRest() && studio.measured(), qPrintable(path));
            QVERIFY(!studio.window.grab().isNull());
            QCOMPARE(studio.document()->state().validate(), QString());
            QVERIFY(QFile::remove(path));
        }
        qInfo("%d sessions, %d of them open", count, opened);
        QVERIFY(opened > count / 4);
    }
};

QTEST_MAIN(TestStrangeSessions)

} // namespace tst_strangesessions

#include "tst_strangesessions.moc"
