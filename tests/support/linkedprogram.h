// A program at the other end of the live link, for tests.
#pragma once

#include "link/framereader.h"
#include "link/linkmap.h"
#include "model/document/scene.h"
#include "support/patience.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLocalSocket>
#include <QTest>

#include <vector>

namespace autocuts::test {

using namespace Qt::Literals::StringLiterals;

//! What a place file of this process says.
inline QJsonObject placeIn(const QString &folder)
{
    QFile file(u"%1/studio-%2.json"_s.arg(folder).arg(QCoreApplication::applicationPid()));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

//! A "mesh" message of a scene, without UVs.
inline link::Message meshMessage(const Scene &scene, int serial, bool open)
{
    const MeshData &mesh = *scene.mesh;
    link::Message message(u"mesh"_s);
    message.set(u"serial"_s, serial);
    message.set(u"model"_s, scene.path);
    message.set(u"open"_s, open);
    QJsonArray objects;
    for (const QString &name : scene.objectNames)
        objects << name;
    message.set(u"objects"_s, objects);
    std::vector<int> sizes;
    for (int face = 0; face < mesh.faceCount(); ++face)
        sizes.push_back(mesh.faceStart[face + 1] - mesh.faceStart[face]);
    message.add(u"positions"_s,
                std::span<const double>(mesh.positions.data(), std::size_t(mesh.positions.size())), 3);
    message.add(u"sizes"_s, std::span<const int>(sizes));
    message.add(u"corners"_s, std::span<const int>(mesh.cornerVertex));
    message.add(u"faceObjects"_s, std::span<const int>(mesh.faceObject));
    return message;
}

//! Talks to the studio of this process and notes what it says.
struct LinkedProgram
{
    QLocalSocket socket;
    link::FrameReader reader;
    std::vector<link::Message> heard;

    explicit LinkedProgram(const QString &folder)
    {
        QObject::connect(&socket, &QLocalSocket::readyRead, &socket, [this] { read(); });
        socket.connectToServer(placeIn(folder).value("socket"_L1).toString());
    }
    static link::Message hello(const QString &token, int version = link::protocolVersion)
    {
        link::Message message(u"hello"_s);
        message.set(u"version"_s, version);
        message.set(u"token"_s, token);
        message.set(u"program"_s, u"Test"_s);
        return message;
    }
    //! Shows the token, and waits for the welcome.
    bool enter(const QString &folder)
    {
        send(hello(placeIn(folder).value("token"_L1).toString()));
        return waitFor("welcome").type() == "welcome"_L1;
    }
    void send(const link::Message &message) { socket.write(message.encoded()); }
    void send(const char *type) { send(link::Message(QString::fromLatin1(type))); }
    void want(const char *mode)
    {
        link::Message message(u"want"_s);
        message.set(u"mode"_s, QString::fromLatin1(mode));
        send(message);
    }
    void read()
    {
        reader.feed(socket.readAll());
        for (auto message = reader.next(); message && message.value(); message = reader.next())
            heard.push_back(*message.value());
    }
    //! The next message of a type; what came before it is forgotten. One without a type when none comes.
    link::Message waitFor(const char *type)
    {
        const auto found = [&] {
            return std::ranges::find(heard, QString::fromLatin1(type), &link::Message::type);
        };
        if (!QTest::qWaitFor([&] { return found() != heard.end(); }, patience))
            return {};
        const link::Message message = *found();
        heard.erase(heard.begin(), found() + 1);
        return message;
    }
    //! Hands a mesh over; the answer.
    link::Message hand(const link::Message &mesh)
    {
        send(mesh);
        [[maybe_unused]] const bool answered = QTest::qWaitFor(
            [this] {
                return std::ranges::any_of(heard, [](const link::Message &message) {
                    return message.type() == "taken"_L1 || message.type() == "refused"_L1;
                });
            },
            patience);
        const auto answer = std::ranges::find_if(heard, [](const link::Message &message) {
            return message.type() == "taken"_L1 || message.type() == "refused"_L1;
        });
        if (answer == heard.end())
            return {};
        const link::Message result = *answer;
        heard.erase(heard.begin(), answer + 1);
        return result;
    }
    bool isLetGo()
    {
        return QTest::qWaitFor([this] { return socket.state() == QLocalSocket::UnconnectedState; }, patience);
    }
};

} // namespace autocuts::test
