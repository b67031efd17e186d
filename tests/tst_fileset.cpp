// Files that are written together: all new, or all as they were.
#include "model/io/files/savefile.h"
#include "model/io/files/setjournal.h"
#include "support/cliruns.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTest>

#include <csignal>

#include <sys/resource.h>

namespace tst_fileset {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Replaces two files of the folder and makes another one, as one set. \param names with spaces
bool replace(const QDir &folder, const QString &names)
{
    FileSet set;
    for (const QString &name : names.split(u' ')) {
        if (!set.add(folder.filePath(name), "new"))
            return false;
    }
    return set.putInPlace().ok();
}

} // namespace

class TestFileSet : public QObject, private test::OwnFolder
{
    Q_OBJECT

private:
    QStringList files() const
    {
        return QDir(mFolder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

private Q_SLOTS:
    void init()
    {
        QDir folder(mFolder.path());
        QVERIFY(folder.removeRecursively() && folder.mkpath(QStringLiteral(".")));
    }

    void nothingChangesBeforeAllAreWritten()
    {
        file("a", "old");
        {
            FileSet set;
            QVERIFY(set.add(at("a"), "new").ok());
            QVERIFY(set.add(at("b"), "new").ok());
            QCOMPARE(test::readBytes(at("a")), QByteArray("old"));
            QVERIFY(!QFileInfo::exists(at("b")));
        }
        QCOMPARE(files(), QStringList{QStringLiteral("a")});
        QCOMPARE(test::readBytes(at("a")), QByteArray("old"));
    }

    void allAreReplaced()
    {
        file("a", "old");
        FileSet set;
        QVERIFY(set.add(at("a"), "first").ok());
        QVERIFY(set.add(at("b"), "second").ok());
        QVERIFY(set.putInPlace().ok());
        QCOMPARE(set.paths(), (QStringList{at("a"), at("b")}));
        QCOMPARE(test::readBytes(at("a")), QByteArray("first"));
        QCOMPARE(test::readBytes(at("b")), QByteArray("second"));
        QCOMPARE(files().size(), 2);
    }

    //! The third target cannot be replaced: the first one gets its content back, the second one is gone
    //! again.
    void aFailureBringsTheOldFilesBack()
    {
        file("a", "old");
        FileSet set;
        QVERIFY(set.add(at("a"), "new").ok());
        QVERIFY(set.add(at("b"), "new").ok());
        QVERIFY(set.add(at("c"), "new").ok());
        QVERIFY(QDir(mFolder.path()).mkpath(QStringLiteral("c/full")));
        const Result<Done> placed = set.putInPlace();
        QVERIFY(!placed);
        QCOMPARE(placed.error().file, at("c"));
        QCOMPARE(test::readBytes(at("a")), QByteArray("old"));
        QVERIFY(!QFileInfo::exists(at("b")));
    }

    void aBadTargetIsToldAtOnce()
    {
        FileSet set;
        QVERIFY(!set.add(at("none/a"), "new"));
        QVERIFY(!set.add(mFolder.path(), "new"));
        QVERIFY(set.add(at("a"), "new").ok());
        QVERIFY(set.putInPlace().ok());
        QCOMPARE(files(), QStringList{QStringLiteral("a")});
    }

    void linksAndPermissionsStay()
    {
        const QString real = file("real", "old");
        QVERIFY(QFile::setPermissions(real, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
        const QFile::Permissions before = QFile::permissions(real);
        QVERIFY(QFile::link(real, at("link")));
        QVERIFY(saveAtomically(at("link"), "new").ok());
        QVERIFY(QFileInfo(at("link")).isSymLink());
        QCOMPARE(test::readBytes(real), QByteArray("new"));
        QCOMPARE(QFile::permissions(real), before);
    }

    //! The program is run again and killed at each of its calls on files. Who looks into the folder then
    //! finds all files old or all new, and nothing else; and is told when something was left to be done.
    void aKilledProgramLeavesNoMixture_data()
    {
        QTest::addColumn<QString>("names");
        QTest::newRow("one folder") << u"a b c"_s;
        QTest::newRow("several folders") << u"a one/b two/c"_s;
        QTest::newRow("a folder within") << u"one/a b one/c"_s;
    }
    void aKilledProgramLeavesNoMixture()
    {
#ifdef AUTOCUTS_SANITIZED
        QSKIP("sanitizers have to be the first library");
#endif
        QFETCH(const QString, names);
        const QStringList paths = names.split(u' ');
        const QString folder = at("work");
        int calls = 0, mixed = 0, allNew = 0, told = 0;
        for (int call = 0; call <= calls; ++call) {
            QVERIFY(QDir(folder).removeRecursively() && QDir().mkpath(folder));
            QVERIFY(QDir(folder).mkpath(u"one"_s) && QDir(folder).mkpath(u"two"_s));
            for (const QString &path : {paths.front(), paths.back()})
                QVERIFY(test::writeBytes(folder + u'/' + path, "old"));
            QFile::remove(at("calls.log"));
            QProcess process;
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            for (const auto &[name, value] :
                 {std::pair(u"REPLACE_IN"_s, folder), std::pair(u"REPLACE"_s, names),
                  std::pair(u"LD_PRELOAD"_s, QStringLiteral(FAILING_CALLS)),
                  std::pair(u"FAILING_FOLDER"_s, folder), std::pair(u"FAILING_LOG"_s, at("calls.log")),
                  std::pair(u"FAILING_CALL"_s, QString::number(call)),
                  std::pair(u"FAILING_WITH"_s, u"kill"_s)})
                environment.insert(name, value);
            process.setProcessEnvironment(environment);
            process.start(QCoreApplication::applicationFilePath(), {QCoreApplication::applicationName()});
            QVERIFY(process.waitForFinished());
            if (call == 0)
                calls = int(test::readBytes(at("calls.log")).count('\n'));
            else
                QCOMPARE(process.exitCode(), SIGKILL);
            const auto contents = [&] {
                QByteArrayList all;
                for (const QString &path : paths)
                    all << test::readBytes(folder + u'/' + path);
                return all.join(' ');
            };
            const QByteArray before = contents();
            mixed += before != "old  old" && before != "new new new" ? 1 : 0;
            // Whichever of the folders is looked into.
            const QStringList lines = endBrokenSets({QFileInfo(folder + u'/' + paths[call % 3]).path()});
            const QByteArray after = contents();
            const bool isOld = after == "old  old";
            QVERIFY2(isOld ? before == after : after == "new new new", after.constData());
            // A note on work that had not begun may be left in another folder.
            QStringList all;
            for (const QString &path : paths)
                all << folder + u'/' + path;
            QCOMPARE(endBrokenSets(all), QStringList());
            QCOMPARE(contents(), after);
            int left = 0;
            for (QDirIterator i(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
                 i.hasNext(); i.next())
                ++left;
            QCOMPARE(left, isOld ? 2 : 3);
            QVERIFY(lines.size() <= 1 && (before == after || !lines.isEmpty()));
            QVERIFY(lines.isEmpty() || lines.first().contains(isOld ? u"as they were"_s : u"new ones"_s));
            allNew += isOld ? 0 : 1;
            told += int(lines.size());
        }
        QVERIFY(calls > 15);
        QVERIFY(mixed > 0 && allNew > 2 && told > mixed);
    }

    //! What a program is at work on stays, and so do notes that name files elsewhere.
    void onlyBrokenSetsAreEnded()
    {
        file("a", "old");
        SetJournal journal;
        QCOMPARE(journal.begin({at("a"), at("b")}), 0);
        const QString fresh = journal.newName(at("b"));
        QVERIFY(test::writeBytes(fresh, "new"));
        QCOMPARE(endBrokenSets({mFolder.path()}), QStringList());
        QVERIFY(QFileInfo::exists(fresh) && !QFileInfo::exists(at("b")));
        journal.end();
        QVERIFY(QDir(mFolder.path()).mkpath(u"work"_s));
        file("a.12345678.new", "new");
        file("work/.autocuts-12345678.set", R"([{"name": "../a", "before": ""}])");
        QCOMPARE(endBrokenSets({at("work")}), QStringList());
        QCOMPARE(test::readBytes(at("a")), QByteArray("old"));
        QVERIFY(QFileInfo::exists(at("a.12345678.new")));
    }

    //! A file that was changed after the program was killed is not replaced, and it is said where the new one
    //! is.
    void aChangedFileStays()
    {
        file("a", "changed");
        file("a.12345678.new", "new");
        file(".autocuts-12345678.set", R"([{"name": "a", "before": "3 1 1 1"}])");
        for (int time = 0; time < 2; ++time) {
            const QStringList lines = endBrokenSets({at("a")});
            QCOMPARE(lines.size(), 1);
            QVERIFY2(lines.first().contains(u"12345678.new"_s), qPrintable(lines.first()));
            QCOMPARE(test::readBytes(at("a")), QByteArray("changed"));
            QCOMPARE(test::readBytes(at("a.12345678.new")), QByteArray("new"));
        }
        QVERIFY(QFile::remove(at("a.12345678.new")));
        QCOMPARE(endBrokenSets({at("a")}), QStringList());
        QCOMPARE(files(), QStringList{u"a"_s});
    }

    //! A note alone does not let files of another folder be replaced.
    void aFolderThatIsGoneIsSaid()
    {
        QVERIFY(QDir(mFolder.path()).mkpath(u"here"_s) && QDir(mFolder.path()).mkpath(u"there"_s));
        file("there/b", "old");
        file("there/b.12345678.new", "new");
        file("here/a.12345678.new", "new");
        const QByteArray stamp = "\"before\": \"-1 0 0 0\"";
        file("here/.autocuts-12345678.set", "[{\"name\": \"a\", " + stamp +
                                                "}, {\"folder\": \"../there\", \"name\": \"b\", " + stamp +
                                                "}]");
        for (const char *other : {"", "[]"}) {
            if (*other)
                file("there/.autocuts-12345678.set", other);
            const QStringList lines = endBrokenSets({at("here")});
            QCOMPARE(lines.size(), 1);
            QVERIFY2(lines.first().contains(u"several folders"_s), qPrintable(lines.first()));
            QCOMPARE(test::readBytes(at("there/b")), QByteArray("old"));
            QCOMPARE(QDir(at("there")).entryList(QDir::Files).size(), 2);
            QVERIFY(QFileInfo::exists(at("here/a.12345678.new")) && !QFileInfo::exists(at("here/a")));
        }
        QVERIFY(QFile::remove(at("here/a.12345678.new")));
        QCOMPARE(endBrokenSets({at("here")}), QStringList());
        QVERIFY(QDir(at("here")).isEmpty(QDir::Files | QDir::Hidden));
    }

    //! Two buffers of a model may be the same file.
    void theLastBytesOfATargetCount()
    {
        FileSet set;
        for (const char *bytes : {"first", "second"}) {
            QVERIFY(set.add(at("a"), bytes).ok());
            QVERIFY(set.add(at("b"), bytes).ok());
        }
        QVERIFY(set.putInPlace().ok());
        QCOMPARE(test::readBytes(at("a")), QByteArray("second"));
        QCOMPARE(files().size(), 2);
    }

    //! A new file is as readable as one that any other program makes.
    void aNewFileHasUsualPermissions()
    {
        QVERIFY(saveAtomically(at("a"), "new").ok());
        QFile usual(at("b"));
        QVERIFY(usual.open(QIODevice::WriteOnly));
        QCOMPARE(QFile::permissions(at("a")), usual.permissions());
    }

    void moreFilesThanMayUsuallyBeOpen()
    {
        rlimit before{};
        QCOMPARE(getrlimit(RLIMIT_NOFILE, &before), 0);
        if (before.rlim_max < 1000)
            QSKIP("too few files may be open here");
        const rlimit few{200, before.rlim_max};
        QCOMPARE(setrlimit(RLIMIT_NOFILE, &few), 0);
        FileSet set;
        for (int i = 0; i < 500; ++i)
            QVERIFY(set.add(at("f") + QString::number(i), "x").ok());
        QVERIFY(set.putInPlace().ok());
        QCOMPARE(files().size(), 500);
        setrlimit(RLIMIT_NOFILE, &before);
    }
};

int main(int argc, char *argv[])
{
    if (qEnvironmentVariableIsSet("REPLACE_IN"))
        return replace(QDir(qEnvironmentVariable("REPLACE_IN")), qEnvironmentVariable("REPLACE")) ? 0 : 1;
    QCoreApplication application(argc, argv);
    TestFileSet test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace tst_fileset

#include "tst_fileset.moc"
