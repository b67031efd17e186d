// The pictures of the documentation: how they are made, and that the pages have them.
#include "figures/picturesheet.h"
#include "figures/studiopictures.h"
#include "model/samples/samples.h"

#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace tst_docpictures {

using namespace autocuts;
using namespace autocuts::figures;
using namespace Qt::Literals::StringLiterals;

namespace {

QImage gradient(const QSize &size)
{
    QImage picture(size, QImage::Format_RGB32);
    for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x)
            picture.setPixel(x, y, qRgb(x * 255 / size.width(), y * 255 / size.height(), 90));
    }
    return picture;
}

int distance(QRgb a, QRgb b)
{
    return std::max(
        {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

} // namespace

class TestDocPictures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sheetsHaveColumnsBesideEachOther()
    {
        Column first, second;
        first.pictures = {gradient({40, 30}), gradient({40, 20})};
        second.pictures = {gradient({60, 30})};
        second.title = u"Title"_s;
        const QImage sheet = sheetOf({first, second});
        QCOMPARE(sheet.width(), 6 + 40 + 6 + 60 + 6);
        QVERIFY(sheet.height() > 6 + 30 + 6 + 20);
        QCOMPARE(sheet.copy(6, 6, 40, 30), first.pictures[0]);
        QCOMPARE(sheet.copy(6, 42, 40, 20), first.pictures[1]);
        QCOMPARE(sheet.copy(52, 6, 60, 30), second.pictures[0]);
    }

    void smallPicturesKeepTheirColours()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"a.png"_s);
        const QImage picture = gradient({64, 64});
        QVERIFY(saveSmall(picture, path));
        const QImage read(path);
        QVERIFY(read.colorCount() > 200 && read.colorCount() <= 256);
        int worst = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x)
                worst = std::max(worst, distance(read.pixel(x, y), picture.pixel(x, y)));
        }
        QVERIFY2(worst <= 16, qPrintable(QString::number(worst)));
        QVERIFY(!saveSmall(picture, folder.filePath(u"no/such/folder/a.png"_s)));
    }

    void modelsFillTheirPictures()
    {
        StudioPictures studio;
        studio.open(makeSample(u"bumpycube"_s).value());
        const QImage picture = studio.model({200, 200}, {30, 15});
        QCOMPARE(picture.size(), QSize(200, 200));
        // The background is a soft gradient from the top to the bottom.
        QRect model;
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 200; ++x) {
                if (distance(picture.pixel(x, y), picture.pixel(0, y)) > 24)
                    model |= QRect(x, y, 1, 1);
            }
        }
        const int longer = std::max(model.width(), model.height());
        QVERIFY2(longer > 170 && longer < 190, qPrintable(QString::number(longer)));
        QVERIFY((model.center() - QPoint(100, 100)).manhattanLength() < 8);
    }

    void pagesHaveTheirPictures_data()
    {
        QTest::addColumn<QString>("page");
        QTest::addColumn<int>("least");
        QTest::newRow("figures") << u"docs/figures/README.md"_s << 11;
        QTest::newRow("gallery") << u"docs/gallery.md"_s << 16;
    }
    void pagesHaveTheirPictures()
    {
        QFETCH(QString, page);
        QFETCH(int, least);
        QFile file(QLatin1String(AUTOCUTS_SOURCE_DIR "/") + page);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QDir folder = QFileInfo(file).dir();
        const QRegularExpression picture(u"!\\[[^\\]]*\\]\\(([^)]*)\\)"_s);
        int count = 0;
        qint64 bytes = 0;
        for (auto it = picture.globalMatch(QString::fromUtf8(file.readAll())); it.hasNext(); ++count) {
            const QString path = folder.filePath(it.next().captured(1));
            QVERIFY2(!QImage(path).isNull(), qPrintable(path));
            bytes += QFileInfo(path).size();
        }
        QVERIFY2(count >= least, qPrintable(QString::number(count)));
        QVERIFY(bytes < 4'000'000);
    }
};

QTEST_MAIN(TestDocPictures)

} // namespace tst_docpictures

#include "tst_docpictures.moc"
