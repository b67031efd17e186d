// The command line packs into tiles and rectangles, by the marks of a session.
#include "cli/commandline.h"
#include "commands/editrectangles.h"
#include "commands/setislandflags.h"
#include "model/io/projectfile.h"
#include "support/cliruns.h"
#include "support/pieces.h"

#include <QTemporaryDir>
#include <QTest>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

class TestCliPacking : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        mDocument = test::partsDocument({{}, {{0.3, 0}, 1}, {{0.7, 0.1}, 2}, {{0.1, 0.5}}});
        pushCommand(EditRectangles::add(
            *mDocument,
            {1, u"two hands"_s, 0xff4080ff, {1.1, 0.1}, {1.6, 0.9}, false, 1, {0, 1, 2, 9, 10, 11}}));
    }

    void optionsAreRead()
    {
        const auto packing = [](const QStringList &words) {
            return parseCommandLine(QStringList{u"pack"_s, u"a.obj"_s, u"-o"_s, u"b.obj"_s} + words);
        };
        QCOMPARE(packing({}).value().unwrap.packing.lower, Vec2(0, 0));
        QCOMPARE(packing({u"--tile=1013"_s}).value().unwrap.packing.lower, Vec2(2, 1));
        QCOMPARE(packing({u"--tile=1013"_s}).value().unwrap.packing.upper, Vec2(3, 2));
        const CliOptions box = packing({u"--into"_s, u"0.25,-1,0.5,2"_s}).value();
        QCOMPARE(box.unwrap.packing.lower, Vec2(0.25, -1));
        QCOMPARE(box.unwrap.packing.upper, Vec2(0.5, 2));
        QCOMPARE(packing({u"--into"_s, u"left hand"_s}).value().intoRectangle, u"left hand"_s);
        for (const char *wrong : {"--tile=1000", "--tile=10000", "--into=1,0,0,1", "--into=0,0,1,1e9"})
            QVERIFY2(!packing({QString::fromLatin1(wrong)}).ok(), wrong);
        QVERIFY(!packing({u"--into=0,0,1,1"_s, u"--tile=1002"_s}).ok());
        QVERIFY(!parseCommandLine({u"unwrap"_s, u"a.obj"_s, u"-o"_s, u"b.obj"_s, u"--into=0,0,1,1"_s}).ok());
    }

    void sidesGiveARectangle()
    {
        const auto packed = pack({u"--into=0.5,0.5,0.75,1"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        for (int part = 0; part < 4; ++part)
            QVERIFY(Eigen::AlignedBox2d(Vec2(0.5, 0.5), Vec2(0.75, 1)).contains(packed->islands().box(part)));
    }

    void theBorderIsKept()
    {
        constexpr double border = 400.0 / 2048;
        const auto packed = pack({u"--tile-border=400"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        const Eigen::AlignedBox2d inside(Vec2::Constant(border - 1e-9), Vec2::Constant(1 - border + 1e-9));
        // The others have a rectangle.
        QVERIFY(inside.contains(packed->islands().box(1)) && inside.contains(packed->islands().box(2)));
        const auto usual = pack({});
        QVERIFY2(usual, qPrintable(mRun.err));
        QVERIFY(!inside.contains(usual->islands().box(1)) || !inside.contains(usual->islands().box(2)));
    }

    void namesGiveARectangleWithItsIslands()
    {
        const auto packed = pack({u"--into=two hands"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        const Eigen::AlignedBox2d box(Vec2(1.1, 0.1), Vec2(1.6, 0.9));
        for (int part = 0; part < 4; ++part)
            QCOMPARE(box.contains(packed->islands().box(part)), part == 0 || part == 3);
        QVERIFY(packed->uv().middleRows(test::partCorners, 2 * test::partCorners) ==
                mDocument->uv().middleRows(test::partCorners, 2 * test::partCorners));
        QVERIFY(!pack({u"--into=no such"_s}));
        QVERIFY2(mRun.err.contains(u"no rectangle \"no such\""_s), qPrintable(mRun.err));
    }

    void tilesAreThoseOfTheOptionOrTheSession()
    {
        auto packed = pack({u"--tile=1002"_s});
        QVERIFY(packed && packed->islands().box(0).min().x() > 1);
        QCOMPARE(packed->packingSettings().udimTile, 1002);
        mDocument = std::move(packed);
        packed = pack({});
        QVERIFY(packed && packed->islands().box(0).min().x() > 1);
    }

    void marksAreRespected()
    {
        using Edit = SetIslandFlags::Edit;
        pushCommand(std::make_unique<SetIslandFlags>(*mDocument, Edit::Lock, std::vector<int>{3}));
        pushCommand(std::make_unique<SetIslandFlags>(*mDocument, Edit::Group, std::vector<int>{0, 1}));
        const auto packed = pack({u"--keep-scale"_s});
        QVERIFY2(packed, qPrintable(mRun.err));
        const auto middle = [](const Document &document, int part) {
            const Eigen::Index rows = test::partCorners;
            return Vec2(document.uv().middleRows(part * rows, rows).colwise().mean().transpose());
        };
        QVERIFY(packed->uv().bottomRows(test::partCorners) == mDocument->uv().bottomRows(test::partCorners));
        const double before = (middle(*mDocument, 1) - middle(*mDocument, 0)).norm();
        QVERIFY(std::abs((middle(*packed, 1) - middle(*packed, 0)).norm() - before) < 1e-9);
    }

private:
    //! The session after it was packed; null when that failed.
    std::unique_ptr<Document> pack(const QStringList &options)
    {
        const QTemporaryDir folder;
        const QString in = folder.filePath(u"in.acproj"_s), out = folder.filePath(u"out.acproj"_s);
        if (!saveProject(mDocument->state(), {}, in))
            return nullptr;
        mRun = test::runInProcess(QStringList{u"pack"_s, in, u"-o"_s, out, u"--pack-time=0.05"_s} + options);
        if (mRun.code != 0)
            return nullptr;
        return Document::create(loadProject(out).value().state).value();
    }

    std::unique_ptr<Document> mDocument;
    test::CliRun mRun;
};

QTEST_GUILESS_MAIN(TestCliPacking)
#include "tst_clipacking.moc"
