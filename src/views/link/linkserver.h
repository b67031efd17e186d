// Lets other programs of the user in.
#pragma once

#include "link/linkplace.h"
#include "views/link/linkclient.h"

#include <memory>
#include <vector>

class QLocalServer;

namespace autocuts {

//! Listens at a socket in a folder of the user; the place file there tells programs where and with which
//! token. Nothing listens beyond the machine.
class LinkServer final : public QObject
{
    Q_OBJECT

public:
    explicit LinkServer(QObject *parent = nullptr);
    ~LinkServer() override;

    //! Starts with a new token. \param folder of the place file, see link::LinkPlace::userFolder()
    Result<Done> listen(const QString &folder);
    //! Lets all programs go and removes the place file.
    void close();
    bool isListening() const;
    //! Names the model of the document in the place file, so that programs find their studio again.
    void setModel(const QString &model);
    //! The programs that were let in.
    std::vector<LinkClient *> clients() const;

Q_SIGNALS:
    void joined(autocuts::LinkClient *client);
    //! \param client is deleted after this
    void parted(autocuts::LinkClient *client);
    void received(autocuts::LinkClient *client, const autocuts::link::Message &message);

private:
    void takeConnection();
    void forget(LinkClient *client);

    QLocalServer *mServer;
    link::LinkPlace mPlace;
    QByteArray mToken;
    QString mModel;
    std::vector<LinkClient *> mClients; //!< also those that have not shown the token
};

} // namespace autocuts
