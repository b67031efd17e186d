// Where a studio listens for other programs.
#pragma once

#include "model/document/result.h"

#include <QByteArray>
#include <QString>

namespace autocuts::link {

//! The file by which programs of the same user find a studio and show that they may talk to it. Only the user
//! can read it.
struct LinkPlace
{
    QString folder;
    qint64 process = 0; //!< of the studio

    //! The folder for all places of the user: below the one for sockets of the running session.
    static QString userFolder();
    QString socket() const { return path(QLatin1StringView("socket")); }
    QString file() const { return path(QLatin1StringView("json")); }
    //! Makes the folder for this user only, and removes what a process of the same number left behind.
    Result<Done> prepare() const;
    //! Writes the file. \param token what programs have to show \param model that is open; may be empty
    Result<Done> write(const QByteArray &token, const QString &model) const;
    void remove() const;

private:
    QString path(QLatin1StringView suffix) const;
};

//! 256 random bits, as text.
QByteArray newToken();
//! True when both are equal. Takes the same time wherever they differ.
bool sameToken(const QByteArray &a, const QByteArray &b);

} // namespace autocuts::link
