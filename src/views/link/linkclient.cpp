#include "views/link/linkclient.h"

#include "link/linkplace.h"

#include <QCoreApplication>
#include <QLocalSocket>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qint64 readAtOnce = 1 << 20;   // bytes
constexpr qint64 mostToWrite = 16 << 20; // bytes; a program that does not read its answers is not read either
// Milliseconds; both chosen by hand.
constexpr int strangersPatience = 5000, farewellPatience = 1000;

} // namespace

LinkClient::LinkClient(QLocalSocket *socket, const QByteArray &token, const QString &model, QObject *parent)
    : QObject(parent), mSocket(socket), mToken(token), mModel(model)
{
    mSocket->setParent(this);
    mSocket->setReadBufferSize(readAtOnce); // a program that sends more waits
    mReader.setLimits(link::FrameLimits::ofStrangers());
    connect(mSocket, &QLocalSocket::readyRead, this, &LinkClient::read);
    connect(mSocket, &QLocalSocket::bytesWritten, this, [this] {
        if (isIdle())
            Q_EMIT drained();
        read();
    });
    connect(mSocket, &QLocalSocket::disconnected, this, &LinkClient::left);
    mStranger.setSingleShot(true);
    connect(&mStranger, &QTimer::timeout, this, [this] { end(link::linkError(u"no token was shown"_s)); });
    mStranger.start(strangersPatience);
    QMetaObject::invokeMethod(this, &LinkClient::read, Qt::QueuedConnection);
}

bool LinkClient::isIdle() const
{
    return mSocket->bytesToWrite() == 0;
}

void LinkClient::flush()
{
    mSocket->flush();
}

void LinkClient::sendBytes(const QByteArray &frames)
{
    if (!mEnding)
        mSocket->write(frames);
}

void LinkClient::refuse(int serial, const Error &error)
{
    link::Message refused(u"refused"_s);
    refused.set(u"serial"_s, serial);
    refused.set(u"reason"_s, error.message);
    refused.set(u"remedy"_s, error.remedy);
    send(refused);
}

void LinkClient::end(const Error &reason)
{
    if (mEnding)
        return;
    refuse(0, reason);
    close();
}

void LinkClient::leave()
{
    if (mEnding)
        return;
    send(link::Message(u"bye"_s));
    close();
}

void LinkClient::close()
{
    mEnding = true;
    mStranger.stop();
    // Goes on writing; what does not read is cut off.
    QTimer::singleShot(farewellPatience, this, [this] { mSocket->abort(); });
    mSocket->disconnectFromServer();
}

void LinkClient::next()
{
    mBusy = false;
    QMetaObject::invokeMethod(this, &LinkClient::read, Qt::QueuedConnection);
}

void LinkClient::read()
{
    while (!mBusy && !mEnding && mSocket->bytesToWrite() < mostToWrite) {
        const Result<std::optional<link::Message>> message = mReader.next();
        if (!message) {
            end(message.error());
        } else if (message.value()) {
            deal(*message.value());
        } else if (mSocket->bytesAvailable() > 0) {
            mReader.feed(mSocket->read(readAtOnce));
        } else {
            return;
        }
    }
}

void LinkClient::deal(const link::Message &message)
{
    if (!mWelcome) {
        greet(message);
    } else if (message.type() == "bye"_L1) {
        mEnding = true;
        mSocket->disconnectFromServer();
    } else {
        mBusy = true;
        Q_EMIT received(message);
    }
}

void LinkClient::greet(const link::Message &hello)
{
    const QJsonObject &fields = hello.fields();
    if (hello.type() != "hello"_L1 || fields.value("version"_L1).toInt() != link::protocolVersion) {
        end(link::linkError(u"this studio speaks version %1 of the link"_s.arg(link::protocolVersion)));
        return;
    }
    if (!link::sameToken(fields.value("token"_L1).toString().toLatin1(), mToken)) {
        end(link::linkError(u"the token is wrong"_s));
        return;
    }
    mStranger.stop();
    mWelcome = true;
    mReader.setLimits({});
    mName = fields.value("program"_L1).toString(u"?"_s).left(80);
    link::Message welcome(u"welcome"_s);
    welcome.set(u"version"_s, link::protocolVersion);
    welcome.set(u"program"_s, u"Autocuts %1"_s.arg(QCoreApplication::applicationVersion()));
    welcome.set(u"model"_s, mModel);
    send(welcome);
    Q_EMIT welcomed();
}

} // namespace autocuts
