// Autosave, recovery and saving under fire: programs that are killed while they save.
#include "model/io/files/savefile.h"
#include "model/io/projects/autosave.h"
#include "support/randomedits.h"
#include "support/sessions.h"

#include <QDir>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

namespace tst_autosave {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! A save function that writes a small session with a number in it.
Autosave::Save saving(int &number)
{
    return [&number](const QString &path, const Autosave::Saved &saved) {
        test::Session session = test::gridSession(2, 0, 1);
        session.state.viewState = QByteArray::number(++number);
        session.extras.sessionPath = u"/projects/a.acproj"_s;
        saved(saveAtomically(path, ProjectWriter().bytes(session.state, session.extras)));
    };
}

QStringList filesIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
}

//! Waits until an autosave would have come that was due when this was called.
bool intervalPasses(int interval)
{
    QTemporaryDir folder;
    int number = 0;
    const auto later = std::move(Autosave::start(folder.path(), saving(number)).value());
    later->setInterval(2 * interval);
    later->sessionChanged();
    return QTest::qWaitFor([&] { return number > 0; }, 20'000);
}

int numberIn(const QString &file)
{
    const Result<LoadedProject> loaded = loadProject(file);
    return loaded && loaded->notes.size() == 1 ? loaded->state.viewState.toInt() : -1;
}

//! Runs the saving program, kills it after some time, and remembers the numbers that it reported last.
class Victim
{
public:
    Victim(const QString &path, const QString &folder) : mPath(path), mFolder(folder) {}

    bool run(int milliseconds)
    {
        QProcess process;
        process.start(QStringLiteral(SAVINGLOOP), {mPath, mFolder, QString::number(newest)});
        if (!process.waitForReadyRead(20000))
            return false;
        QThread::msleep(static_cast<unsigned long>(milliseconds));
        process.kill();
        process.waitForFinished();
        for (const QByteArray &line : process.readAllStandardOutput().split('\n')) {
            const int number = line.mid(1).toInt();
            if (number == 0)
                continue;
            ++saves;
            (line[0] == 's' ? saved : autosaved) = number;
            newest = std::max(newest, number);
        }
        // The save that was interrupted may have used the next number.
        newest += 2;
        return process.exitStatus() == QProcess::CrashExit;
    }

    int saves = 0, saved = 0, autosaved = 0, newest = 0;

private:
    QString mPath, mFolder;
};

} // namespace

class TestAutosave : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void savesAfterTheInterval();
    void isNotPutOff();
    void savesWhenTheSessionRests();
    void nothingIsLeftInOrder();
    void failureIsReported();
    void listsWhatACrashLeft();
    void recoveredSessionGoesOn();
    void sessionInUseIsNotOffered();
    void unreadableLock();
    void damagedFileIsNotOffered();
    void unwantedWhileItIsWritten();
    void killedWhileSaving();
};

void TestAutosave::savesAfterTheInterval()
{
    QTemporaryDir folder;
    int number = 0;
    const auto autosave =
        std::move(Autosave::start(folder.filePath(u"new/recovery"_s), saving(number)).value());
    QCOMPARE(autosave->interval(), 20000);
    autosave->setInterval(10);
    QVERIFY(intervalPasses(autosave->interval()));
    QCOMPARE(number, 0); // nothing changed
    autosave->sessionChanged();
    autosave->sessionChanged();
    QTRY_COMPARE(number, 1);
    QVERIFY(intervalPasses(autosave->interval()));
    QCOMPARE(number, 1);
    autosave->sessionChanged();
    QTRY_COMPARE(number, 2);
    QCOMPARE(numberIn(autosave->file()), 2);
    autosave->sessionChanged();
    autosave->sessionSaved();
    QVERIFY(intervalPasses(autosave->interval()));
    QCOMPARE(number, 2);
    QVERIFY(!QFile::exists(autosave->file()));
}

//! A visit to the preferences sets the interval, too.
void TestAutosave::isNotPutOff()
{
    QTemporaryDir folder;
    int number = 0;
    const auto autosave = std::move(Autosave::start(folder.path(), saving(number)).value());
    autosave->setInterval(200);
    for (int i = 0; i < 60 && number == 0; ++i) {
        autosave->sessionChanged();
        autosave->setInterval(200);
        QTest::qWait(20);
    }
    QCOMPARE(number, 1);
    autosave->setInterval(3'600'000);
    autosave->sessionChanged();
    autosave->setInterval(10);
    QTRY_COMPARE(number, 2);
}

void TestAutosave::savesWhenTheSessionRests()
{
    QTemporaryDir folder;
    int number = 0;
    const auto autosave = std::move(Autosave::start(folder.path(), saving(number)).value());
    autosave->setInterval(3'600'000);
    autosave->sessionChanged();
    QTRY_COMPARE_WITH_TIMEOUT(number, 1, 60'000);
}

void TestAutosave::nothingIsLeftInOrder()
{
    QTemporaryDir folder;
    int number = 0;
    {
        const auto autosave = std::move(Autosave::start(folder.path(), saving(number)).value());
        autosave->saveNow();
        QCOMPARE(filesIn(folder.path()).size(), 2);
        QVERIFY(QFile::copy(autosave->file(), autosave->file() + u".1"_s)); // as a second saving leaves it
    }
    QCOMPARE(filesIn(folder.path()), QStringList());
}

void TestAutosave::failureIsReported()
{
    QTemporaryDir folder;
    int calls = 0;
    const auto autosave =
        std::move(Autosave::start(folder.path(), [&](const QString &path, const Autosave::Saved &saved) {
                      if (++calls == 1)
                          saved(Error{u"the disk is full"_s, path, 0, {}});
                      else
                          saved(Done{});
                  }).value());
    QStringList messages;
    connect(autosave.get(), &Autosave::failed, this, [&](const Error &error) { messages << error.message; });
    autosave->setInterval(10);
    autosave->sessionChanged();
    QTRY_COMPARE(calls, 2); // tried again
    QCOMPARE(messages, QStringList{u"the disk is full"_s});
    QVERIFY(intervalPasses(autosave->interval()));
    QCOMPARE(calls, 2);
    QFile file(folder.filePath(u"file"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(!Autosave::start(folder.filePath(u"file/sub"_s), saving(calls)).ok());
}

//! Leaves behind what a crash leaves: the files of a session whose program is gone.
void leaveCrashed(const QString &folder, const QString &id)
{
    int number = 41;
    saving(number)(folder + u'/' + id + u".acproj"_s, [](const Result<Done> &) {});
    QFile lock(folder + u'/' + id + u".lock"_s);
    QVERIFY(lock.open(QIODevice::WriteOnly));
    // No process has this id; the name of the host is left out, as on systems that have none.
    lock.write("2147483646\ntst_autosave\n" + QSysInfo::machineHostName().toUtf8() + "\n");
}

void TestAutosave::listsWhatACrashLeft()
{
    QTemporaryDir folder;
    leaveCrashed(folder.path(), u"one"_s);
    leaveCrashed(folder.path(), u"two"_s);
    // Of a save that was killed, and of a session that was never saved.
    for (const auto *name : {"one.acproj.XyZabc", "three.lock"}) {
        QFile file(folder.filePath(QString::fromLatin1(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("2147483646\ntst_autosave\n" + QSysInfo::machineHostName().toUtf8() + "\n");
    }
    const std::vector<RecoverableSession> sessions = recoverableSessions(folder.path());
    QCOMPARE(sessions.size(), std::size_t(2));
    for (const RecoverableSession &session : sessions) {
        QCOMPARE(session.sessionPath, u"/projects/a.acproj"_s);
        QVERIFY(std::abs(session.savedAt.secsTo(QDateTime::currentDateTime())) < 100);
        QCOMPARE(numberIn(session.file), 42);
    }
    QCOMPARE(filesIn(folder.path()), (QStringList{u"one.acproj"_s, u"two.acproj"_s}));
    discardSession(sessions.front());
    QCOMPARE(recoverableSessions(folder.path()).size(), std::size_t(1));
    QVERIFY(recoverableSessions(folder.filePath(u"none"_s)).empty());
}

void TestAutosave::recoveredSessionGoesOn()
{
    QTemporaryDir folder;
    leaveCrashed(folder.path(), u"one"_s);
    const RecoverableSession session = recoverableSessions(folder.path()).front();
    int number = 99;
    auto autosave = std::move(Autosave::start(folder.path(), saving(number), &session).value());
    // Until the first autosave a second crash would cost nothing.
    QCOMPARE(numberIn(session.file), 42);
    QVERIFY(!Autosave::start(folder.path(), saving(number), &session).ok());
    discardSession(session);
    QCOMPARE(numberIn(session.file), 42);
    autosave->saveNow();
    QCOMPARE(numberIn(session.file), 100);
    autosave.reset();
    QCOMPARE(filesIn(folder.path()), QStringList());
}

void TestAutosave::sessionInUseIsNotOffered()
{
    QTemporaryDir folder;
    int number = 0;
    const auto autosave = std::move(Autosave::start(folder.path(), saving(number)).value());
    autosave->saveNow();
    QVERIFY(recoverableSessions(folder.path()).empty());
    QCOMPARE(filesIn(folder.path()).size(), 2);
}

void TestAutosave::unreadableLock()
{
    QTemporaryDir folder;
    leaveCrashed(folder.path(), u"one"_s);
    QFile lock(folder.filePath(u"one.lock"_s));
    QVERIFY(lock.open(QIODevice::WriteOnly | QIODevice::Truncate));
    lock.close();
    // It may belong to a program that is just starting.
    QVERIFY(recoverableSessions(folder.path()).empty());
    QVERIFY(lock.open(QIODevice::ReadWrite));
    QVERIFY(lock.setFileTime(QDateTime::currentDateTime().addSecs(-60), QFileDevice::FileModificationTime));
    lock.close();
    QCOMPARE(recoverableSessions(folder.path()).size(), std::size_t(1));
}

void TestAutosave::damagedFileIsNotOffered()
{
    QTemporaryDir folder;
    QFile file(folder.filePath(u"one.acproj"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("nonsense");
    file.close();
    QVERIFY(recoverableSessions(folder.path()).empty());
    QVERIFY(file.exists());
}

void TestAutosave::unwantedWhileItIsWritten()
{
    QTemporaryDir folder;
    int number = 0;
    std::vector<std::function<void()>> writes;
    const auto autosave =
        std::move(Autosave::start(folder.path(), [&](const QString &path, const Autosave::Saved &saved) {
                      writes.push_back([=, &number] { saving(number)(path, saved); });
                  }).value());
    autosave->saveNow();
    autosave->saveNow();
    autosave->sessionSaved();
    for (const auto &write : writes) {
        write();
        QVERIFY(!QFile::exists(autosave->file()));
    }
    // What is saved afterwards is wanted again.
    autosave->saveNow();
    autosave->sessionSaved();
    autosave->saveNow();
    writes[2]();
    writes[3]();
    QCOMPARE(numberIn(autosave->file()), 4);
}

void TestAutosave::killedWhileSaving()
{
    QTemporaryDir folder, recovery;
    const QString path = folder.filePath(u"a.acproj"_s);
    Victim victim(path, recovery.path());
    test::Random random(5);
    int rounds = 0;
    for (; rounds < 40 || (victim.saves < 200 && rounds < 2000); ++rounds) {
        const int before = victim.newest;
        QVERIFY(victim.run(random.below(20)));
        // The session is the newest one that was reported, or the one that was being saved.
        const int number = numberIn(path);
        QVERIFY2(number >= victim.saved && number <= victim.newest, qPrintable(QString::number(number)));
        for (const char *suffix : {".1", ".2"}) {
            const QString backup = path + QLatin1StringView(suffix);
            QVERIFY2(!QFile::exists(backup) || numberIn(backup) > 0, suffix);
        }
        const std::vector<RecoverableSession> sessions = recoverableSessions(recovery.path());
        if (victim.autosaved > before) {
            QCOMPARE(sessions.size(), std::size_t(1));
            QCOMPARE(sessions.front().sessionPath, path);
            QVERIFY(numberIn(sessions.front().file) >= victim.autosaved);
        }
        for (const RecoverableSession &session : sessions)
            discardSession(session);
        QCOMPARE(filesIn(recovery.path()), QStringList());
    }
    QVERIFY(victim.saves >= 200);
}

QTEST_GUILESS_MAIN(TestAutosave)

} // namespace tst_autosave

#include "tst_autosave.moc"
