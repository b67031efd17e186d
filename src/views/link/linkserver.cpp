#include "views/link/linkserver.h"

#include <QCoreApplication>
#include <QLocalServer>
#include <QLocalSocket>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr std::size_t mostClients = 32; // chosen by hand

} // namespace

LinkServer::LinkServer(QObject *parent) : QObject(parent), mServer(new QLocalServer(this))
{
    mServer->setSocketOptions(QLocalServer::UserAccessOption);
    connect(mServer, &QLocalServer::newConnection, this, [this] {
        while (mServer->hasPendingConnections())
            takeConnection();
    });
}

LinkServer::~LinkServer()
{
    blockSignals(true); // who hears them may be gone
    close();
}

Result<Done> LinkServer::listen(const QString &folder)
{
    close();
    mPlace = {folder, QCoreApplication::applicationPid()};
    if (Result<Done> prepared = mPlace.prepare(); !prepared)
        return prepared;
    if (!mServer->listen(mPlace.socket()))
        return Error{u"Other programs cannot be linked: %1"_s.arg(mServer->errorString()), mPlace.socket(), 0,
                     u"Set XDG_RUNTIME_DIR to a folder with a short path"_s};
    mToken = link::newToken();
    Result<Done> written = mPlace.write(mToken, mModel);
    if (!written)
        close();
    return written;
}

void LinkServer::close()
{
    if (!mServer->isListening())
        return;
    mServer->close();
    mPlace.remove();
    for (LinkClient *client : std::exchange(mClients, {})) {
        client->disconnect(this);
        client->send(link::Message(u"bye"_s));
        client->flush();
        Q_EMIT parted(client);
        client->deleteLater();
    }
}

bool LinkServer::isListening() const
{
    return mServer->isListening();
}

void LinkServer::setModel(const QString &model)
{
    if (model == std::exchange(mModel, model) || !isListening())
        return;
    // Without the name programs still find the studio.
    std::ignore = mPlace.write(mToken, mModel);
}

std::vector<LinkClient *> LinkServer::clients() const
{
    std::vector<LinkClient *> result;
    std::copy_if(mClients.begin(), mClients.end(), std::back_inserter(result),
                 [](const LinkClient *client) { return client->isWelcome(); });
    return result;
}

void LinkServer::takeConnection()
{
    QLocalSocket *socket = mServer->nextPendingConnection();
    auto *client = new LinkClient(socket, mToken, mModel, this);
    mClients.push_back(client);
    connect(client, &LinkClient::welcomed, this, [this, client] { Q_EMIT joined(client); });
    connect(client, &LinkClient::received, this,
            [this, client](const link::Message &message) { Q_EMIT received(client, message); });
    connect(client, &LinkClient::left, this, [this, client] { forget(client); });
    if (mClients.size() > mostClients)
        client->end({u"too many programs are linked"_s, {}, 0, u"End one of them"_s});
}

void LinkServer::forget(LinkClient *client)
{
    if (std::erase(mClients, client) == 0)
        return;
    if (client->isWelcome())
        Q_EMIT parted(client);
    client->deleteLater();
}

} // namespace autocuts
