// Gives maps and marks of the document to other programs.
#pragma once

#include "views/control/session/studiocontext.h"
#include "views/link/linkclient.h"

#include <QTimer>

#include <functional>
#include <vector>

namespace autocuts {

//! Compares what programs have with the document and the running solve, on other threads, and sends the
//! difference. A program that reads slowly gets the newest map only, when it has read the one before.
class LinkSending final : public QObject
{
    Q_OBJECT

public:
    using Clients = std::function<std::vector<LinkClient *>()>;
    LinkSending(const StudioContext &context, Clients clients, QObject *parent = nullptr);

public Q_SLOTS:
    //! Compares soon: what happens within a moment is sent together.
    void sendSoon();

private:
    void sendNow();
    void tellLeft(LinkClient &client);
    void sendTo(LinkClient &client);
    link::MapToSend mapFor(const LinkClient &client) const;

    StudioContext mContext;
    Clients mClients;
    QTimer mSoon;
};

} // namespace autocuts
