// No output overwrites what is read: files are compared by what they are, not by their paths.
#include "support/cliruns.h"

#include <QDir>
#include <QImage>
#include <QTest>

#include <unistd.h>

namespace tst_outputclash {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

class TestOutputClash : public QObject, private test::OwnFolder
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void nothingIsOverwritten_data();
    void nothingIsOverwritten();
    void rewritingTheInput();
    void bakingAgain();

private:
    void makeFiles();
    QStringList inFolder(QString words) const
    {
        return words.replace(u"@"_s, mFolder.path() + u'/').split(u' ');
    }
};

void TestOutputClash::init()
{
    mFolder = QTemporaryDir();
    makeFiles();
}

void TestOutputClash::makeFiles()
{
    file("in.obj", "mtllib in.mtl\n" + test::quadCubeObj());
    file("in.mtl", "newmtl red\nmap_Kd wood.png\nnewmtl blue\n");
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(Qt::red);
    QVERIFY(picture.save(at("wood.png")));
    QCOMPARE(test::runInProcess(
                 {u"unwrap"_s, at("in.obj"), u"-o"_s, at("mapped.obj"), u"--quality=draft"_s, u"--quiet"_s})
                 .code,
             0);
    QCOMPARE(test::runInProcess({u"convert"_s, at("mapped.obj"), u"-o"_s, at("s.acproj")}).code, 0);
    QCOMPARE(test::runInProcess({u"convert"_s, at("in.obj"), u"-o"_s, at("in.glb")}).code, 0);
    file("other.obj", test::readBytes(at("mapped.obj")));
    file("high.obj", "mtllib high.mtl\n" + test::readBytes(at("mapped.obj")));
    file("high.mtl", "newmtl red\nmap_Kd other_color.png\nnewmtl blue\n");
    QVERIFY(picture.save(at("other_color.png")));
    const auto link = [&](const char *to, const char *from) {
        QVERIFY(symlink(qPrintable(at(to)), qPrintable(at(from))) == 0);
    };
    link("in.obj", "link.png");
    link("mapped.obj", "mappedlink.png");
    link("in.obj", "link.acproj");
    link("wood.png", "report.json");
    QVERIFY(::link(qPrintable(at("in.obj")), qPrintable(at("hard.json"))) == 0);
    QVERIFY(::link(qPrintable(at("mapped.obj")), qPrintable(at("mapped_ao.png"))) == 0);
}

void TestOutputClash::nothingIsOverwritten_data()
{
    QTest::addColumn<QString>("words");
    const QString draft = u"unwrap @in.obj --quality=draft -o @out.obj "_s;
    QTest::newRow("report over the input") << draft + u"--report @in.obj"_s;
    QTest::newRow("report over a hard link to the input") << draft + u"--report @hard.json"_s;
    QTest::newRow("report over a link to a texture") << draft + u"--report @report.json"_s;
    QTest::newRow("report over the materials") << draft + u"--report @in.mtl"_s;
    QTest::newRow("layout over a link to the input") << draft + u"--layout @link.png"_s;
    QTest::newRow("layout over a texture") << draft + u"--layout @wood.png"_s;
    QTest::newRow("layout is the report") << draft + u"--layout @new.png --report @new.png"_s;
    QTest::newRow("report over the buffer of the output")
        << u"unwrap @in.obj --quality=draft -o @out.gltf --report @out.bin"_s;
    QTest::newRow("report over the materials of the output")
        << u"unwrap @in.glb --quality=draft -o @out.obj --report @out.mtl"_s;
    QTest::newRow("layout over a texture of the output")
        << u"unwrap @in.glb --quality=draft -o @out.obj --layout @out_wood.png"_s;
    QTest::newRow("layout over a texture of a Collada file")
        << u"unwrap @in.glb --quality=draft -o @out.dae --layout @out_wood.png"_s;
    QTest::newRow("report over a backup of the output")
        << u"pack @s.acproj -o @s.acproj --report @s.acproj.1"_s;
    QTest::newRow("session over a link to the input") << u"convert @in.obj -o @link.acproj"_s;
    QTest::newRow("output over the other model") << u"transfer @in.obj --from @other.obj -o @other.obj"_s;
    QTest::newRow("picture over a link to the input") << u"bake @mapped.obj -o @ --maps ao --size 16"_s;
    QTest::newRow("report of a bake over the input")
        << u"bake @mapped.obj -o @new --maps normal --size 16 --report @mapped.obj"_s;
    QTest::newRow("report of a bake over its picture")
        << u"bake @mapped.obj -o @new --maps normal --size 16 --report @new/mapped_normal.png"_s;
    QTest::newRow("report of a bake over the materials of the detailed model")
        << u"bake @mapped.obj --high @high.obj -o @new --maps color --size 16 --report @high.mtl"_s;
    QTest::newRow("picture over a texture of the detailed model")
        << u"bake @other.obj --high @high.obj -o @ --maps color --size 16"_s;
    QTest::newRow("report of a bake over the materials of the cage")
        << u"bake @mapped.obj --high @other.obj --cage-file @high.obj -o @new --size 16 --report @high.mtl"_s;
    QTest::newRow("report over the materials of the model with the UVs")
        << u"transfer @in.obj --from @high.obj -o @out.obj --report @high.mtl"_s;
    QTest::newRow("report of carried textures over the materials of the old model")
        << u"transfer @mapped.obj --from @high.obj --textures @wood.png -o @new --report @high.mtl"_s;
    QTest::newRow("light over a link to the input")
        << u"lightbake @mapped.obj -o @mappedlink.png --size 16"_s;
}

void TestOutputClash::nothingIsOverwritten()
{
    QFETCH(QString, words);
    QDir folder(mFolder.path());
    const auto contents = [&] {
        std::map<QString, QByteArray> all;
        for (const QString &name : folder.entryList(QDir::Files))
            all[name] = test::readBytes(folder.filePath(name));
        return all;
    };
    const auto before = contents();
    QVERIFY(folder.mkpath(u"new"_s));
    const test::CliRun run = test::runInProcess(inFolder(words));
    QVERIFY2(run.code == 1, qPrintable(run.out + run.err));
    QVERIFY2(run.err.contains(u"would overwrite another file"_s), qPrintable(run.err));
    QVERIFY(contents() == before);
    QVERIFY(QDir(at("new")).isEmpty());
}

void TestOutputClash::rewritingTheInput()
{
    for (const QString &words :
         {u"unwrap @in.obj --quality=draft -o @in.obj --quiet"_s, u"convert @s.acproj -o @s.acproj"_s,
          u"convert @s.acproj -o @mapped.obj"_s}) {
        const test::CliRun run = test::runInProcess(inFolder(words));
        QVERIFY2(run.code == 0, qPrintable(run.err));
    }
}

void TestOutputClash::bakingAgain()
{
    // The model may name what is baked.
    file("named.mtl", "newmtl red\nmap_Bump mapped_normal.png\nnewmtl blue\n");
    file("mapped.obj", "mtllib named.mtl\n" + test::readBytes(at("mapped.obj")));
    QVERIFY(QFile::remove(at("mapped_ao.png")));
    for (int i = 0; i < 2; ++i) {
        const test::CliRun run =
            test::runInProcess(inFolder(u"bake @mapped.obj -o @ --maps normal --size 16 --quiet"_s));
        QVERIFY2(run.code == 0, qPrintable(run.err));
    }
}

QTEST_GUILESS_MAIN(TestOutputClash)

} // namespace tst_outputclash

#include "tst_outputclash.moc"
