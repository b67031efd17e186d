// Picture files: what is written is read again; formats that Qt does not know; damaged files.
#include "model/pictures/picturefiles.h"
#include "model/pictures/picturesize.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

namespace tst_picturefiles {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Values from 0 to 1, all different.
Picture ramp(int width, int height, int channels)
{
    Picture picture(width, height, channels);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        picture.values[i] = float(i) / float(picture.values.size() - 1);
    return picture;
}

QByteArray content(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

//! The largest difference of two values; 1000 where the shapes differ.
float difference(const Picture &a, const Picture &b)
{
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        return 1000;
    float most = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        most = std::max(most, std::abs(a.values[i] - b.values[i]));
    return most;
}

Imf::Slice slice(const std::vector<float> &values, int width)
{
    return {Imf::FLOAT, reinterpret_cast<char *>(const_cast<float *>(values.data())), sizeof(float),
            sizeof(float) * std::size_t(width)};
}

} // namespace

class TestPictureFiles : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir mFolder;
    QString path(const QString &name) const { return mFolder.filePath(name); }

private Q_SLOTS:
    void roundTrip_data()
    {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<int>("depth");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("png 8") << "png" << int(PictureDepth::Eight) << 0.5 / 255;
        QTest::newRow("png 16") << "png" << int(PictureDepth::Sixteen) << 0.5 / 65535;
        QTest::newRow("tif 8") << "tif" << int(PictureDepth::Eight) << 0.5 / 255;
        QTest::newRow("tif 16") << "TIFF" << int(PictureDepth::Sixteen) << 0.5 / 65535;
        QTest::newRow("tga") << "tga" << int(PictureDepth::Eight) << 0.5 / 255;
        QTest::newRow("jpg") << "jpg" << int(PictureDepth::Eight) << 0.1;
        QTest::newRow("exr half") << "exr" << int(PictureDepth::Sixteen) << 1.0 / 2048;
        QTest::newRow("exr float") << "exr" << int(PictureDepth::Float) << 0.0;
    }
    void roundTrip()
    {
        QFETCH(QString, suffix);
        QFETCH(int, depth);
        QFETCH(double, tolerance);
        for (const int channels : {1, 3, 4}) {
            const Picture picture = ramp(31, 17, channels);
            const QString file = path(u"p."_s + suffix);
            const auto written = writePicture(picture, file, PictureDepth(depth));
            QVERIFY2(written.ok(), written ? "" : qPrintable(written.error().toString()));
            const Result<Picture> back = readPicture(file);
            QVERIFY2(back.ok(), back ? "" : qPrintable(back.error().toString()));
            QCOMPARE(back->width, 31);
            QCOMPARE(back->height, 17);
            if (suffix == u"jpg"_s && channels != 1)
                continue; // alpha is lost, and neighbours differ too much in this picture
            if (suffix == u"TIFF"_s && channels == 1) {
                QCOMPARE(back->channels, 3); // Qt writes no grey ones of 16 bits
                QVERIFY(std::abs(back->at(5, 5)[1] - picture.at(5, 5)[0]) <= 1e-5F);
                continue;
            }
            if (suffix == u"tif"_s && channels == 4) {
                // Qt multiplies these colours by alpha while it reads, and back again.
                QVERIFY(difference(picture, back.value()) < 0.1F);
                continue;
            }
            QVERIFY2(difference(picture, back.value()) <= float(tolerance) + 1e-6F,
                     qPrintable(u"%1 channels: %2"_s.arg(channels).arg(difference(picture, back.value()))));
            const auto decoded = decodePicture(content(file), file);
            QVERIFY(decoded.ok());
            QCOMPARE(decoded->depth, suffix == u"exr"_s ? PictureDepth::Float : PictureDepth(depth));
        }
    }

    void valuesOutsideAreClamped()
    {
        Picture picture(3, 1, 1);
        picture.values = {-5, std::nanf(""), 7};
        QVERIFY(writePicture(picture, path(u"c.png"_s), PictureDepth::Sixteen).ok());
        QCOMPARE(readPicture(path(u"c.png"_s))->values, (std::vector<float>{0, 0, 1}));
        picture.values = {-5, 1e30F, INFINITY};
        QVERIFY(writePicture(picture, path(u"c.exr"_s), PictureDepth::Float).ok());
        QCOMPARE(readPicture(path(u"c.exr"_s))->values, picture.values);
    }

    void refusedToWrite_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("depth");
        QTest::addColumn<QString>("text");
        QTest::newRow("jpg 16") << "a.jpg" << int(PictureDepth::Sixteen) << "16 bits";
        QTest::newRow("png float") << "a.png" << int(PictureDepth::Float) << "float";
        QTest::newRow("tga 16") << "a.tga" << int(PictureDepth::Sixteen) << "16 bits";
        QTest::newRow("exr 8") << "a.exr" << int(PictureDepth::Eight) << "8 bits";
        QTest::newRow("unknown") << "a.doc" << int(PictureDepth::Eight) << "\"doc\"";
        QTest::newRow("no folder") << "nowhere/a.png" << int(PictureDepth::Eight) << "does not exist";
    }
    void refusedToWrite()
    {
        QFETCH(QString, name);
        QFETCH(int, depth);
        QFETCH(QString, text);
        const auto result = writePicture(ramp(4, 4, 3), path(name), PictureDepth(depth));
        QVERIFY(!result.ok());
        QVERIFY2(result.error().toString().contains(text), qPrintable(result.error().toString()));
        QVERIFY(!QFile::exists(path(name)));
        QVERIFY(!writePicture(Picture(), path(u"e.png"_s), PictureDepth::Eight).ok());
    }

    void refusedToRead()
    {
        QVERIFY(!readPicture(path(u"missing.png"_s)).ok());
        const auto folder = readPicture(mFolder.path());
        QVERIFY(!folder.ok() && folder.error().message.contains(u"folder"_s));
        write(path(u"text.png"_s), "this is no picture");
        QVERIFY(!readPicture(path(u"text.png"_s)).ok());
        write(path(u"empty.exr"_s), {});
        QVERIFY(!readPicture(path(u"empty.exr"_s)).ok());
        write(path(u"hidden.png"_s), "x");
        QFile::setPermissions(path(u"hidden.png"_s), {});
        QVERIFY(!readPicture(path(u"hidden.png"_s)).ok()); // also where permissions do not count
    }

    void tooManyPixels()
    {
        write(path(u"big.hdr"_s), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 100000 +X 100000\n");
        auto result = readPicture(path(u"big.hdr"_s));
        QVERIFY(!result.ok() && result.error().message.contains(u"100000 x 100000"_s));
        write(path(u"short.hdr"_s), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16000 +X 16000\nabc");
        QVERIFY(!readPicture(path(u"short.hdr"_s)).ok());
        QByteArray png;
        {
            QVERIFY(writePicture(ramp(4, 4, 3), path(u"small.png"_s), PictureDepth::Eight).ok());
            png = content(path(u"small.png"_s));
            png[16] = 0; // the width, 100000; its checksum is wrong then, too
            png[17] = 1;
            png[18] = char(0x86);
            png[19] = char(0xa0);
            write(path(u"big.png"_s), png);
        }
        QVERIFY(!readPicture(path(u"big.png"_s)).ok());
        QVERIFY(writePicture(ramp(4, 4, 3), path(u"small.exr"_s), PictureDepth::Float).ok());
        QByteArray exr = content(path(u"small.exr"_s));
        for (const QByteArray &window : {"dataWindow\0box2i\0"_ba, "displayWindow\0box2i\0"_ba}) {
            QByteArray wide = exr;
            const qsizetype at = wide.indexOf(window) + window.size() + 4 + 8;
            wide[at + 2] = 2; // 131072 and some
            write(path(u"wide.exr"_s), wide);
            result = readPicture(path(u"wide.exr"_s));
            QVERIFY(!result.ok());
        }
    }

    void hdrRuns()
    {
        // One line of eight pixels in split runs, one of plain pixels with an old run.
        QByteArray bytes = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n";
        bytes += QByteArray("\x02\x02\x00\x08", 4);
        for (const char value : {char(128), char(64), char(0), char(129)})
            bytes += QByteArray("\x88", 1) + value;
        bytes += QByteArray("\x80\x80\x80\x81\x01\x01\x01\x06\x00\x00\x00\x00", 12);
        write(path(u"runs.hdr"_s), bytes);
        const auto picture = readPicture(path(u"runs.hdr"_s));
        QVERIFY2(picture.ok(), picture ? "" : qPrintable(picture.error().toString()));
        QCOMPARE(picture->width, 8);
        QCOMPARE(picture->at(3, 0)[0], 1.0F);
        QCOMPARE(picture->at(7, 0)[1], 0.5F);
        QCOMPARE(picture->at(7, 0)[2], 0.0F);
        QCOMPARE(picture->at(6, 1)[2], 1.0F);
        QCOMPARE(picture->at(7, 1)[0], 0.0F);
    }

    void tgaRuns()
    {
        // 4 x 1 pixels of 24 bits from below: a run of three, one plain.
        QByteArray bytes(18, '\0');
        bytes[2] = 10;
        bytes[12] = 4;
        bytes[14] = 1;
        bytes[16] = 24;
        bytes += QByteArray("\x82\x00\x00\xff\x00\xff\x00\x00", 8);
        write(path(u"runs.tga"_s), bytes);
        const auto picture = readPicture(path(u"runs.tga"_s));
        QVERIFY2(picture.ok(), picture ? "" : qPrintable(picture.error().toString()));
        QCOMPARE(picture->values, (std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1}));
        bytes.chop(1);
        write(path(u"runs.tga"_s), bytes);
        QVERIFY(!readPicture(path(u"runs.tga"_s)).ok());
    }

    void exrLayers_data()
    {
        QTest::addColumn<QStringList>("names");
        QTest::addColumn<QList<int>>("order"); // which channel each of the picture's is
        QTest::newRow("plain") << QStringList{u"R"_s, u"G"_s, u"B"_s} << QList<int>{0, 1, 2};
        QTest::newRow("layer") << QStringList{u"view.Combined.R"_s, u"view.Combined.G"_s,
                                              u"view.Combined.B"_s, u"view.Combined.A"_s}
                               << QList<int>{0, 1, 2, 3};
        QTest::newRow("first of two")
            << QStringList{u"b.R"_s, u"b.G"_s, u"b.B"_s, u"a.R"_s, u"a.G"_s, u"a.B"_s} << QList<int>{3, 4, 5};
        QTest::newRow("grey") << QStringList{u"Y"_s} << QList<int>{0};
        QTest::newRow("grey and alpha") << QStringList{u"Y"_s, u"A"_s} << QList<int>{0, 0, 0, 1};
        QTest::newRow("other") << QStringList{u"height"_s} << QList<int>{0};
        QTest::newRow("without depth") << QStringList{u"Z"_s, u"R"_s, u"G"_s, u"B"_s} << QList<int>{1, 2, 3};
    }
    void exrLayers()
    {
        QFETCH(QStringList, names);
        QFETCH(QList<int>, order);
        constexpr int side = 5;
        for (const int kind : {0, 1, 2}) { // lines, tiles, the first of two parts
            Imf::Header header(side, side);
            Imf::FrameBuffer buffer;
            std::vector<std::vector<float>> values;
            for (qsizetype i = 0; i < names.size(); ++i)
                values.emplace_back(side * side, float(i) + 0.25F);
            for (qsizetype i = 0; i < names.size(); ++i) {
                header.channels().insert(names[i].toStdString(), Imf::Channel(Imf::FLOAT));
                buffer.insert(names[i].toStdString(), slice(values[std::size_t(i)], side));
            }
            const QString file = path(u"layers.exr"_s);
            if (kind == 0) {
                Imf::OutputFile out(file.toUtf8().constData(), header);
                out.setFrameBuffer(buffer);
                out.writePixels(side);
            } else if (kind == 1) {
                header.setTileDescription(Imf::TileDescription(2, 2));
                Imf::TiledOutputFile out(file.toUtf8().constData(), header);
                out.setFrameBuffer(buffer);
                out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
            } else {
                header.setType(Imf::SCANLINEIMAGE);
                std::vector<Imf::Header> headers(2, header);
                headers[0].setName("first");
                headers[1].setName("second");
                Imf::MultiPartOutputFile out(file.toUtf8().constData(), headers.data(), 2);
                for (int part = 0; part < 2; ++part) {
                    Imf::OutputPart output(out, part);
                    output.setFrameBuffer(buffer);
                    output.writePixels(side);
                    for (auto &channel : values)
                        std::fill(channel.begin(), channel.end(), -1.0F);
                }
            }
            const auto picture = readPicture(file);
            QVERIFY2(picture.ok(), picture ? "" : qPrintable(picture.error().toString()));
            QCOMPARE(picture->channels, int(order.size()));
            for (qsizetype k = 0; k < order.size(); ++k)
                QCOMPARE(picture->at(4, 3)[std::size_t(k)], float(order[k]) + 0.25F);
        }
    }

    void exrWindows()
    {
        Imf::Header header(Imath::Box2i({0, 0}, {3, 3}), Imath::Box2i({2, 1}, {5, 2}));
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        const std::vector<float> values{1, 2, 3, 4, 5, 6, 7, 8};
        Imf::FrameBuffer buffer;
        buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
        {
            Imf::OutputFile out(path(u"window.exr"_s).toUtf8().constData(), header);
            out.setFrameBuffer(buffer);
            out.writePixels(2);
        }
        const auto picture = readPicture(path(u"window.exr"_s));
        QVERIFY(picture.ok());
        QCOMPARE(picture->values, (std::vector<float>{0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 5, 6, 0, 0, 0, 0}));
    }

    //! Qt printed a warning about its own call.
    void aFileShorterThanTheEndOfATga()
    {
        QTest::failOnWarning(QRegularExpression(u".*"_s));
        for (const QString &name : {u"short.tga"_s, u"short.png"_s}) {
            const Result<DecodedPicture> made = decodePicture(QByteArray(20, '\7'), name);
            QVERIFY(!made);
            QVERIFY(made.error().toString().contains(name));
        }
    }

    void damagedFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("depth");
        QTest::newRow("png") << "d.png" << int(PictureDepth::Sixteen);
        QTest::newRow("tif") << "d.tif" << int(PictureDepth::Eight);
        QTest::newRow("tga") << "d.tga" << int(PictureDepth::Eight);
        QTest::newRow("exr") << "d.exr" << int(PictureDepth::Sixteen);
        QTest::newRow("hdr") << "d.hdr" << -1;
    }
    void damagedFiles()
    {
        QFETCH(QString, name);
        QFETCH(int, depth);
        QByteArray good = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 9 +X 16\n";
        for (int line = 0; line < 9; ++line)
            good += QByteArray("\x02\x02\x00\x10\x90\x80\x84\x01\x02\x03\x04\x8a\x09\x90\x20\x90\x81", 17);
        if (depth >= 0) {
            QVERIFY(writePicture(ramp(16, 9, 4), path(name), PictureDepth(depth)).ok());
            good = content(path(name));
        }
        QVERIFY(decodePicture(good, name).ok());
        std::mt19937 random(7);
        for (int round = 0; round < 300; ++round) {
            QByteArray bytes = good;
            const auto place = [&] { return qsizetype(random() % std::size_t(bytes.size())); };
            if (round % 5 == 0)
                bytes.truncate(place());
            for (unsigned changes = 1 + random() % 6; changes > 0 && !bytes.isEmpty(); --changes)
                bytes[place()] = char(random() % 4 == 0 ? 255 : random());
            const auto decoded = decodePicture(bytes, name);
            if (decoded) {
                const Picture &picture = decoded->picture;
                QCOMPARE(picture.values.size(), std::size_t(picture.width) * std::size_t(picture.height) *
                                                    std::size_t(picture.channels));
                QVERIFY(picture.width <= maxPictureSide && picture.height <= maxPictureSide);
            } else {
                QVERIFY(!decoded.error().message.isEmpty());
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestPictureFiles)

} // namespace tst_picturefiles

#include "tst_picturefiles.moc"
