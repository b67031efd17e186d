// The live link of the window: lets programs in, and does what they say.
#pragma once

#include "views/link/linksending.h"
#include "views/link/linkserver.h"
#include "views/link/linktaking.h"

#include <functional>

namespace autocuts {

//! Connects programs with the document. docs/link.md says what their messages mean.
class LinkController final : public QObject
{
    Q_OBJECT

public:
    //! \param mayLeave see LinkTaking
    LinkController(const StudioContext &context, std::function<bool()> mayLeave, QObject *parent = nullptr);

    //! Lets programs in, as long as the preferences want that. \param folder see LinkServer::listen()
    void listen(const QString &folder);
    bool isListening() const { return mServer.isListening(); }
    std::vector<LinkClient *> clients() const { return mServer.clients(); }
    //! Sends the map to all programs, whatever they wait for.
    void sendMap();
    //! Lets all programs go; they may come back.
    void endAll();

Q_SIGNALS:
    //! Programs came or went, or listening began or ended.
    void changed();
    //! \param message translated, one line
    void said(const QString &message);
    void failed(const autocuts::Error &error);

private:
    void followPreferences();
    void nameModel();
    void join(LinkClient *client);
    void receive(LinkClient *client, const link::Message &message);
    bool isShared(LinkClient &client, const link::Message &message) const;
    void takeTextures(LinkClient &client, const link::Message &message);
    void takeMarks(LinkClient &client, const link::Message &message);

    StudioContext mContext;
    QString mFolder; //!< empty: programs are not let in
    LinkServer mServer;
    LinkSending mSending;
    LinkTaking mTaking;
};

} // namespace autocuts
