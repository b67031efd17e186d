// The messages of the live link: what is written is read, and nothing else.
#include "link/framereader.h"
#include "link/handedmodel.h"
#include "link/linkmap.h"
#include "link/linkplace.h"
#include "model/plain/uvlayout.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <cmath>
#include <limits>

namespace tst_linkmessages {

using namespace autocuts;
using namespace autocuts::link;
using namespace Qt::Literals::StringLiterals;

namespace {

template <class T>
void add(Message &message, const QString &name, const std::vector<T> &values, int columns = 1)
{
    message.add(name, std::span<const T>(values), columns);
}

//! Two squares side by side.
Message squares()
{
    Message message(u"mesh"_s);
    message.set(u"serial"_s, 3);
    message.set(u"model"_s, u"squares.blend"_s);
    message.set(u"objects"_s, QJsonArray{u"A"_s});
    message.set(u"materials"_s,
                QJsonArray{QJsonObject{{u"name"_s, u"Wood"_s},
                                       {u"textures"_s, QJsonObject{{u"baseColor"_s, u"/a.png"_s},
                                                                   {u"normal"_s, u"/n.png"_s}}}}});
    message.set(u"uvSets"_s, QJsonArray{u"UVMap"_s, u"Second"_s});
    add<double>(message, u"positions"_s, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}, 3);
    add<int>(message, u"sizes"_s, {4, 4});
    add<int>(message, u"corners"_s, {0, 1, 2, 3, 1, 4, 5, 2});
    add<int>(message, u"faceMaterials"_s, {0, -1});
    add<double>(message, u"uvs0"_s, {0, 0, .5, 0, .5, .5, 0, .5, .5, 0, 1, 0, 1, .5, .5, .5}, 2);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    add<double>(message, u"uvs1"_s, {0, 0, .5, 0, .5, .5, 0, .5, nan, 0, 1, 0, 1, .5, .5, .5}, 2);
    return message;
}

Message again(const Message &message)
{
    FrameReader reader;
    reader.feed(message.encoded());
    return reader.next().value().value();
}

QByteArray frame(quint32 fields, quint32 arrays, const QByteArray &content)
{
    QByteArray bytes(frameHeadSize, '\0');
    qToLittleEndian(fields, bytes.data());
    qToLittleEndian(arrays, bytes.data() + 4);
    return bytes + content;
}

QByteArray frameOf(const QByteArray &fields, const QByteArray &arrays = {})
{
    return frame(quint32(fields.size()), quint32(arrays.size()), fields + arrays);
}

} // namespace

class TestLinkMessages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsWrittenIsRead()
    {
        Message message(u"maps"_s);
        message.set(u"name"_s, u"Größe"_s);
        add<int>(message, u"whole"_s, {1, -2, 3, std::numeric_limits<int>::max()}, 2);
        add<double>(message, u"numbers"_s, {0.1, -1e300});
        add<int>(message, u"none"_s, {}, 2);
        const Message read = again(message);
        QCOMPARE(read.type(), u"maps"_s);
        QCOMPARE(read.fields(), QJsonObject({{u"name"_s, u"Größe"_s}}));
        QCOMPARE(read.integers(u"whole"_s, 2).value(),
                 (std::vector{1, -2, 3, std::numeric_limits<int>::max()}));
        QCOMPARE(read.numbers(u"numbers"_s).value(), (std::vector{0.1, -1e300}));
        QVERIFY(read.has(u"none"_s));
        QCOMPARE(read.integers(u"none"_s, 2).value(), std::vector<int>());
        QVERIFY(!read.has(u"missing"_s));
        QCOMPARE(read.integers(u"missing"_s).value(), std::vector<int>());
        QVERIFY(!read.integers(u"whole"_s)); // other columns
        QVERIFY(!read.numbers(u"whole"_s, 2));
        QVERIFY(!read.integers(u"numbers"_s));
    }

    void theBytesAreThoseOfTheDescription()
    {
        Message message(u"x"_s);
        add<int>(message, u"a"_s, {258});
        const QByteArray text = R"({"arrays":[{"kind":"i4","name":"a","shape":[1,1]}],"type":"x"})";
        QCOMPARE(message.encoded(), frame(quint32(text.size()), 4, text + QByteArray("\x02\x01\0\0", 4)));
    }

    void singlePrecisionIsRead()
    {
        QByteArray values(8, '\0');
        qToLittleEndian(0.25f, values.data());
        qToLittleEndian(-3.0f, values.data() + 4);
        FrameReader reader;
        reader.feed(frameOf(R"({"type":"x","arrays":[{"name":"a","kind":"f4","shape":[2]}]})", values));
        QCOMPARE(reader.next().value()->numbers(u"a"_s).value(), (std::vector{0.25, -3.0}));
    }

    void piecesMakeFrames()
    {
        const QByteArray bytes = squares().encoded() + Message(u"send"_s).encoded();
        FrameReader reader;
        QStringList types;
        for (const char byte : bytes) {
            reader.feed(QByteArray(1, byte));
            if (const auto message = reader.next().value())
                types << message->type();
        }
        QCOMPARE(types, (QStringList{u"mesh"_s, u"send"_s}));
    }

    void damageIsAnError_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const auto array = [](const char *described, qsizetype size) {
            return frameOf(QByteArray(R"({"type":"x","arrays":[)") + described + "]}", QByteArray(size, 'a'));
        };
        QTest::newRow("fields too large") << frame((4 << 20) + 1, 0, {});
        QTest::newRow("arrays too large") << frame(2, (1u << 30) + 1, {});
        QTest::newRow("all ones") << frame(~0u, ~0u, {});
        QTest::newRow("no JSON") << frameOf("{\"type\":");
        QTest::newRow("empty") << frame(0, 0, {});
        QTest::newRow("a list") << frameOf("[1]");
        QTest::newRow("no type") << frameOf("{}");
        QTest::newRow("type is a number") << frameOf(R"({"type":3})");
        QTest::newRow("bytes without array") << frameOf(R"({"type":"x"})", "abcd");
        QTest::newRow("too few bytes") << array(R"({"name":"a","kind":"i4","shape":[2]})", 4);
        QTest::newRow("unknown kind") << array(R"({"name":"a","kind":"i8","shape":[1]})", 8);
        QTest::newRow("no name") << array(R"({"kind":"i4","shape":[1]})", 4);
        QTest::newRow("no shape") << array(R"({"name":"a","kind":"i4"})", 4);
        QTest::newRow("three dimensions") << array(R"({"name":"a","kind":"i4","shape":[1,1,1]})", 4);
        QTest::newRow("no columns") << array(R"({"name":"a","kind":"i4","shape":[1,0]})", 0);
        QTest::newRow("negative") << array(R"({"name":"a","kind":"i4","shape":[-1,-1]})", 4);
        QTest::newRow("half") << array(R"({"name":"a","kind":"i4","shape":[0.5]})", 4);
        QTest::newRow("overflow") << array(R"({"name":"a","kind":"i4","shape":[2147483647,2147483647]})", 4);
        QTest::newRow("twice") << array(
            R"({"name":"a","kind":"i4","shape":[1]},{"name":"a","kind":"i4","shape":[1]})", 8);
    }
    void damageIsAnError()
    {
        QFETCH(QByteArray, bytes);
        FrameReader reader;
        reader.feed(bytes);
        const auto read = reader.next();
        QVERIFY(!read);
        QVERIFY(!read.error().message.isEmpty());
    }

    void strangersMaySayLittle()
    {
        FrameReader reader;
        reader.setLimits(FrameLimits::ofStrangers());
        reader.feed(frame(4097, 0, {}));
        QVERIFY(!reader.next());
    }

    //! Changed, cut and random bytes: an answer, and no crash.
    void noise()
    {
        QRandomGenerator random(42);
        const QByteArray good = squares().encoded();
        int read = 0, refused = 0;
        for (int round = 0; round < 20'000; ++round) {
            QByteArray bytes = good;
            for (int change = random.bounded(1, 6); change > 0; --change)
                bytes[random.bounded(round % 3 ? 1000 : 8) % bytes.size()] = char(random.generate());
            if (round % 5 == 0)
                bytes.truncate(random.bounded(int(bytes.size())));
            FrameReader reader;
            reader.feed(bytes);
            const auto message = reader.next();
            if (!message)
                ++refused;
            else if (message.value())
                ++(readHandedModel(*message.value()) ? read : refused);
        }
        QVERIFY(read > 100);
        QVERIFY(refused > 1000);
    }

    void aModelIsRead()
    {
        const HandedModel model = readHandedModel(again(squares())).value();
        QCOMPARE(model.serial, 3);
        QVERIFY(!model.opens);
        QCOMPARE(model.scene.path, u"squares.blend"_s);
        QCOMPARE(model.scene.mesh->faceCount(), 2);
        QCOMPARE(model.scene.mesh->cornerVertex, (std::vector{0, 1, 2, 3, 1, 4, 5, 2}));
        QCOMPARE(model.scene.faceMaterial, (std::vector{0, -1}));
        QCOMPARE(model.scene.materialTextures[0].file, u"/a.png"_s);
        QCOMPARE(model.scene.materialSets[0].at(TextureChannel::Normal).picture.file, u"/n.png"_s);
        QCOMPARE(model.scene.uvSets.size(), std::size_t(2));
        QCOMPARE(model.scene.uvSets[0].uv(5, 0), 1.0);
        QVERIFY(std::isnan(model.scene.uvSets[1].uv(4, 1)));
    }

    void zUpIsTurned()
    {
        Message message = squares();
        message.set(u"up"_s, u"z"_s);
        const HandedModel model = readHandedModel(message).value();
        QCOMPARE(Vec3(model.scene.mesh->positions.row(5)), Vec3(2, 0, -1));
    }

    void wrongModelsAreErrors_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QJsonValue>("value");
        QTest::newRow("no number") << u"serial"_s << QJsonValue(0);
        QTest::newRow("no name") << u"model"_s << QJsonValue(QString());
        QTest::newRow("no objects") << u"objects"_s << QJsonValue(QJsonArray());
        QTest::newRow("no material") << u"materials"_s << QJsonValue(QJsonArray());
        QTest::newRow("a UV set too many") << u"uvSets"_s << QJsonValue(QJsonArray{u"a"_s, u"b"_s, u"c"_s});
    }
    void wrongModelsAreErrors()
    {
        QFETCH(QString, field);
        QFETCH(QJsonValue, value);
        Message message = squares();
        message.set(field, value);
        QVERIFY(!readHandedModel(message));
    }

    void edgesAreNamedByTheirVertices()
    {
        Message message = squares();
        add<int>(message, u"cuts"_s, {2, 1, 0, 1}, 2); // the second one is a border
        const HandedModel model = readHandedModel(message).value();
        QCOMPARE(model.marks.cuts, (std::vector<VertexPair>{{0, 1}, {1, 2}}));
        const std::vector<int> pairs = model.edges->edgePairs(model.marks.cuts);
        QCOMPARE(pairs.size(), std::size_t(1));
        std::vector<bool> chosen(model.scene.mesh->edgePairs.size());
        chosen[pairs[0]] = true;
        QCOMPARE(model.edges->names(chosen), (std::vector<VertexPair>{{1, 2}}));
    }

    void marksAddUp()
    {
        Marks marks{{{0, 1}, {2, 3}}, {{4, .5f, .5f}, {7, 0, 0}}, {1, 2}};
        const Marks other{{{0, 1}, {1, 2}}, {{4, .5f, .25f}, {9, 1, 1}}, {2}};
        const MarkChanges changes = marks.changesTo(other);
        QCOMPARE(changes.cuts, (std::vector<VertexPair>{{1, 2}}));
        QCOMPARE(changes.uncuts, (std::vector<VertexPair>{{2, 3}}));
        QCOMPARE(changes.unpins, std::vector{7});
        QCOMPARE(changes.pins.size(), std::size_t(2));
        Message message(u"marks"_s);
        changes.writeTo(message);
        const Result<MarkChanges> read = MarkChanges::read(again(message), 4, 10, 3);
        QVERIFY(read.ok());
        QCOMPARE(read.value(), changes);
        marks.apply(read.value());
        QVERIFY(marks.changesTo(other).isEmpty());
        QVERIFY(!MarkChanges::read(again(message), 3, 10, 3));
        QVERIFY(!MarkChanges::read(again(message), 4, 9, 3));
        QVERIFY(!MarkChanges::read(again(message), 4, 10, 2));
    }

    void onlyWhatDiffersIsSent()
    {
        const HandedModel handed = readHandedModel(squares()).value();
        SharedModel shared{handed.serial, handed.scene.mesh, handed.edges, {}, {}, false, {}};
        MapToSend send;
        send.states.assign(std::size_t(handed.scene.mesh->cornerPairCount()), PairState::Free);
        send.uv = handed.scene.uvSets[0].uv;
        send.uv(0, 1) = .75;
        send.tileHeight = .5; // the texture is twice as wide as high
        send.faces = {1};
        const QByteArray frames = messagesFor(shared, send);
        FrameReader reader;
        reader.feed(frames);
        const Message marks = reader.next().value().value(), maps = reader.next().value().value();
        QCOMPARE(marks.type(), u"marks"_s);
        QCOMPARE(marks.integers(u"selection"_s).value(), std::vector{1});
        QCOMPARE(maps.fields().value("serial"_L1).toInt(), 3);
        QCOMPARE(maps.numbers(u"uvs"_s, 2).value()[1], 1.5);
        QCOMPARE(maps.integers(u"seams"_s, 2).value(), std::vector<int>());
        QVERIFY(messagesFor(shared, send).isEmpty());
        send.always = true;
        QVERIFY(!messagesFor(shared, send).isEmpty());
        send.always = false;
        send.uv.row(4) << .6, .1; // opens the edge between the squares
        FrameReader second;
        second.feed(messagesFor(shared, send));
        QCOMPARE(second.next().value()->integers(u"seams"_s, 2).value(), (std::vector{1, 2}));
    }

    void placesAreTheUsersOwn()
    {
        const QTemporaryDir folder;
        const LinkPlace place{folder.filePath(u"autocuts"_s), 4711};
        QVERIFY(place.prepare().ok());
        QVERIFY(place.write("secret", u"a.blend"_s).ok());
        const auto others = QFileDevice::ReadGroup | QFileDevice::WriteGroup | QFileDevice::ReadOther |
                            QFileDevice::WriteOther | QFileDevice::ExeGroup | QFileDevice::ExeOther;
        QVERIFY(!(QFileInfo(place.file()).permissions() & others));
        QVERIFY(!(QFileInfo(place.folder).permissions() & others));
        QFile file(place.file());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject told = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(told.value("token"_L1).toString(), u"secret"_s);
        QCOMPARE(told.value("socket"_L1).toString(), place.socket());
        QCOMPARE(told.value("version"_L1).toInt(), protocolVersion);
        place.remove();
        QVERIFY(!QFile::exists(place.file()));
        QVERIFY(!LinkPlace({u"/proc/nowhere"_s, 1}).prepare());
    }

    void tokens()
    {
        const QByteArray a = newToken(), b = newToken();
        QCOMPARE(a.size(), 64);
        QVERIFY(sameToken(a, a));
        QVERIFY(!sameToken(a, b));
        QVERIFY(!sameToken(a, a.first(63)));
        QVERIFY(!sameToken(a, {}));
    }
};

QTEST_APPLESS_MAIN(TestLinkMessages)

} // namespace tst_linkmessages

#include "tst_linkmessages.moc"
