#include "views/link/linksending.h"

#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/link/linkmerging.h"

#include <QPointer>

#include <algorithm>
#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int togetherFor = 40; // milliseconds; chosen by hand

struct Compared
{
    link::SharedModel shared; //!< what the program will have
    QByteArray frames;
};

} // namespace

LinkSending::LinkSending(const StudioContext &context, Clients clients, QObject *parent)
    : QObject(parent), mContext(context), mClients(std::move(clients))
{
    mSoon.setSingleShot(true);
    connect(&mSoon, &QTimer::timeout, this, &LinkSending::sendNow);
    connect(&mContext.workspace, &Workspace::documentReplaced, this, &LinkSending::sendSoon);
    connect(&mContext.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        // Tokens say nothing of textures.
        if (event.type == ChangeEvent::Type::Textures) {
            for (LinkClient *client : mClients())
                client->seen = {};
        }
        sendSoon();
    });
    connect(&mContext.workspace, &Workspace::selectionChanged, this, &LinkSending::sendSoon);
    connect(&mContext.solver, &SolverController::statusChanged, this, &LinkSending::sendSoon);
    connect(&mContext.solver, &SolverController::stateChanged, this, &LinkSending::sendSoon);
}

void LinkSending::sendSoon()
{
    const std::vector<LinkClient *> clients = mClients();
    if (std::ranges::any_of(clients, [](const LinkClient *client) { return client->asks; }))
        mSoon.start(0);
    else if (!mSoon.isActive())
        mSoon.start(togetherFor);
}

void LinkSending::sendNow()
{
    const Document *document = mContext.workspace.document();
    for (LinkClient *client : mClients()) {
        if (client->shared.serial == 0) {
            client->asks = false;
        } else if (!document || document->state().scene.mesh != client->shared.mesh) {
            client->asks = false; // there is nothing to answer with
            tellLeft(*client);
        } else if (client->sending.isRunning() || !client->isIdle()) {
            client->isLate = true;
        } else if (client->asks || client->mode() != LinkMode::Request) {
            sendTo(*client);
        }
    }
}

//! The document has another model, or another state of it, than the program.
void LinkSending::tellLeft(LinkClient &client)
{
    if (std::exchange(client.wasLeft, true))
        return;
    link::Message left(u"left"_s);
    left.set(u"serial"_s, client.shared.serial);
    left.set(u"model"_s, mContext.workspace.document() ? mContext.workspace.name() : QString());
    client.send(left);
}

//! What is to be compared for a program: the newest map, or none while it waits for a pause.
link::MapToSend LinkSending::mapFor(const LinkClient &client) const
{
    const Document &document = *mContext.workspace.document();
    const SolverController &solver = mContext.solver;
    const bool solving = solver.isRunning() || solver.isPausing();
    link::MapToSend send = toSend(document);
    send.always = client.asks;
    send.solving = solving;
    if (solving && solver.map() && (client.asks || client.mode() == LinkMode::Live))
        send.uv = solver.map()->uv;
    else if (!solving || client.asks)
        send.uv = document.uv();
    return send;
}

void LinkSending::sendTo(LinkClient &client)
{
    client.wasLeft = false;
    const SolverController &solver = mContext.solver;
    const Document &document = *mContext.workspace.document();
    const LinkClient::Seen now{document.token(), document.selection().faces, solver.map(),
                               solver.isRunning() || solver.isPausing(), client.revision};
    if (std::exchange(client.seen, now) == now && !client.asks)
        return;
    auto work = [shared = client.shared, send = mapFor(client)](const std::atomic<bool> &) {
        Compared compared{shared, {}};
        compared.frames = link::messagesFor(compared.shared, send);
        return compared;
    };
    client.asks = false;
    const auto take = [self = QPointer(this), to = &client, revision = client.revision](Compared compared) {
        if (to->revision == revision) {
            to->shared = std::move(compared.shared);
            to->sendBytes(compared.frames);
            to->flush();
        }
        if (self && (std::exchange(to->isLate, false) || to->revision != revision))
            self->sendSoon();
    };
    client.sending.start(std::move(work), take,
                         [to = &client](const QString &problem) { to->end(link::linkError(problem)); });
}

} // namespace autocuts
