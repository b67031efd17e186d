// Files that are written together: all new, or all as they were.
#include "model/io/savefile.h"
#include "support/cliruns.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

#include <sys/resource.h>

using namespace autocuts;

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

QTEST_APPLESS_MAIN(TestFileSet)
#include "tst_fileset.moc"
