// A program at the other end of the live link.
#pragma once

#include "link/framereader.h"
#include "link/linkmap.h"
#include "model/plain/statetoken.h"
#include "views/ui/task.h"

#include <QObject>
#include <QTimer>

#include <memory>

class QLocalSocket;

namespace autocuts {

//! When a program gets maps: all, also those of a running solve; those in the document while nothing is
//! solved; or only when it asks.
enum class LinkMode { Live, Pause, Request };

//! Reads the messages of a program, one at a time, and writes to it. A program that shows no token is told
//! why and let go, and so is one that sends something else than messages.
class LinkClient final : public QObject
{
    Q_OBJECT

public:
    //! Takes the socket. \param token what the program has to show \param model of the document, for its
    //! welcome
    LinkClient(QLocalSocket *socket, const QByteArray &token, const QString &model, QObject *parent);

    bool isWelcome() const { return mWelcome; }
    //! How the program calls itself.
    const QString &name() const { return mName; }
    LinkMode mode() const { return mMode; }
    void setMode(LinkMode mode) { mMode = mode; }
    //! True when what was sent has left.
    bool isIdle() const;

    void send(const link::Message &message) { sendBytes(message.encoded()); }
    void sendBytes(const QByteArray &frames);
    //! Says that something was not done. \param serial of the model that it was about
    void refuse(int serial, const Error &error);
    //! Writes as much as fits at once, in place of when the event loop comes to it.
    void flush();
    //! Says why, and ends the connection.
    void end(const Error &reason);
    //! Ends the connection because the user wants it.
    void leave();
    //! The last message was dealt with: the next one may come.
    void next();

    //! What the program shares with the document. Who changes it raises the revision.
    link::SharedModel shared;
    int revision = 0;
    bool asks = false;    //!< it has asked for a map
    Task sending;         //!< puts together what it gets
    Task reading;         //!< the model that it has handed over
    bool isLate = false;  //!< something has changed since then
    bool wasLeft = false; //!< it knows that the document has another model
    //! What was compared last with what it has.
    struct Seen
    {
        StateToken token;
        QList<int> faces;
        std::shared_ptr<const void> map; //!< of a solve
        bool solving = false;
        int revision = -1;

        bool operator==(const Seen &) const = default;
    };
    Seen seen;

Q_SIGNALS:
    void welcomed();
    //! \pre what was received before was dealt with
    void received(const autocuts::link::Message &message);
    //! All that was sent has left.
    void drained();
    //! The connection has ended. Nothing else is emitted afterwards.
    void left();

private:
    void close();
    void read();
    void deal(const link::Message &message);
    void greet(const link::Message &hello);

    QLocalSocket *mSocket;
    QByteArray mToken;
    QString mModel, mName;
    link::FrameReader mReader;
    QTimer mStranger; //!< runs until the program has shown the token
    LinkMode mMode = LinkMode::Pause;
    bool mWelcome = false, mBusy = false, mEnding = false;
};

} // namespace autocuts
