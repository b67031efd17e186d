#include "views/link/linkcontroller.h"

#include "views/control/session/workspace.h"
#include "views/link/linkmerging.h"
#include "views/ui/preferences.h"

#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

LinkController::LinkController(const StudioContext &context, std::function<bool()> mayLeave, QObject *parent)
    : QObject(parent), mContext(context), mSending(context, [this] { return mServer.clients(); }),
      mTaking(context, std::move(mayLeave))
{
    connect(&mServer, &LinkServer::joined, this, &LinkController::join);
    connect(&mServer, &LinkServer::parted, this, [this](LinkClient *client) {
        Q_EMIT said(tr("%1 is no longer linked").arg(client->name()));
        // It is still in the list.
        QMetaObject::invokeMethod(this, &LinkController::changed, Qt::QueuedConnection);
    });
    connect(&mServer, &LinkServer::received, this, &LinkController::receive);
    connect(&mTaking, &LinkTaking::taken, &mSending, &LinkSending::sendSoon);
    connect(&mContext.workspace, &Workspace::documentReplaced, this, &LinkController::nameModel);
    connect(&mContext.preferences, &Preferences::changed, this, &LinkController::followPreferences);
}

void LinkController::listen(const QString &folder)
{
    mFolder = folder;
    followPreferences();
}

void LinkController::followPreferences()
{
    const bool wanted = !mFolder.isEmpty() && mContext.preferences.values().letProgramsIn;
    if (wanted == isListening())
        return;
    if (!wanted) {
        mServer.close();
    } else if (const Result<Done> listening = mServer.listen(mFolder); !listening) {
        mFolder.clear(); // not again with every change of the preferences
        Q_EMIT failed(listening.error());
    }
    Q_EMIT changed();
}

void LinkController::nameModel()
{
    const Document *document = mContext.workspace.document();
    mServer.setModel(document ? document->state().scene.path : QString());
}

void LinkController::join(LinkClient *client)
{
    connect(client, &LinkClient::drained, &mSending, [this, client] {
        if (std::exchange(client->isLate, false))
            mSending.sendSoon();
    });
    Q_EMIT said(tr("%1 is linked").arg(client->name()));
    Q_EMIT changed();
}

void LinkController::sendMap()
{
    for (LinkClient *client : mServer.clients())
        client->asks = true;
    mSending.sendSoon();
}

void LinkController::endAll()
{
    for (LinkClient *client : mServer.clients())
        client->leave();
}

void LinkController::receive(LinkClient *client, const link::Message &message)
{
    if (message.type() == "mesh"_L1) {
        mTaking.take(client, message); // asks for the next message when that is done
        return;
    }
    if (message.type() == "marks"_L1) {
        takeMarks(*client, message);
    } else if (message.type() == "textures"_L1) {
        takeTextures(*client, message);
    } else if (message.type() == "want"_L1) {
        const QString mode = message.fields().value("mode"_L1).toString();
        if (mode != "live"_L1 && mode != "pause"_L1 && mode != "request"_L1) {
            client->end(link::linkError(u"there is no mode \"%1\""_s.arg(mode)));
            return;
        }
        client->setMode(mode == "live"_L1    ? LinkMode::Live
                        : mode == "pause"_L1 ? LinkMode::Pause
                                             : LinkMode::Request);
        client->seen = {};
    } else if (message.type() == "send"_L1) {
        client->asks = true;
        client->wasLeft = false; // it is told again
    } else {
        client->end(link::linkError(u"there are no messages \"%1\""_s.arg(message.type())));
        return;
    }
    mSending.sendSoon();
    client->next();
}

//! True when a message is about the mesh of the document. Otherwise the program is told.
bool LinkController::isShared(LinkClient &client, const link::Message &message) const
{
    const Document *document = mContext.workspace.document();
    const link::SharedModel &shared = client.shared;
    if (document && shared.mesh && document->state().scene.mesh == shared.mesh &&
        link::serialOf(message) == shared.serial)
        return true;
    client.refuse(link::serialOf(message), link::otherModel());
    return false;
}

void LinkController::takeTextures(LinkClient &client, const link::Message &message)
{
    if (!isShared(client, message))
        return;
    const auto materials = link::NamedTextures::read(message.fields().value("materials"_L1));
    client.shared.textures = materials.written();
    ++client.revision;
    applyTextures(*mContext.workspace.document(), materials);
}

void LinkController::takeMarks(LinkClient &client, const link::Message &message)
{
    if (!isShared(client, message))
        return;
    link::SharedModel &shared = client.shared;
    const MeshData &mesh = *shared.mesh;
    const Result<link::MarkChanges> changes =
        link::MarkChanges::read(message, int(mesh.positions.rows()), mesh.cornerCount(), mesh.faceCount());
    if (!changes) {
        client.end(changes.error());
        return;
    }
    shared.marks.apply(changes.value());
    ++client.revision;
    applyMarks(*mContext.workspace.document(), *shared.edges, changes.value());
}

} // namespace autocuts
