// What files need of the operating system beyond Qt.
#pragma once

#include <QFile>
#include <QString>

namespace autocuts {

//! What a file was when it was read or written. Another one with the same name, and one that was changed,
//! differ.
struct FileStamp
{
    qint64 size = -1;    //!< -1: there is no file
    qint64 modified = 0; //!< nanoseconds
    quint64 device = 0, number = 0;

    static FileStamp of(const QString &path);
    bool exists() const { return size >= 0; }
    bool operator==(const FileStamp &) const = default;
};

namespace filecalls {

//! Forces delayed writes, so that an error such as a full disk is noticed. Qt does not. False with errno
//! where data was lost; some file systems cannot do it, which is no error.
bool reachesDisk(const QFile &file);
//! True for an errno that says that there is no space left, or none that the user may use.
bool isOutOfSpace(int systemError);
//! Locks a file until it is closed. False when another program has locked it.
bool lockUntilClosed(const QFile &file);
bool belongsToUser(const QFile &file);
//! Lets as many files be open as the system allows.
void allowManyFiles();
//! Gives a file the permissions that new files of the user have.
void setPermissionsOfNewFile(const QFile &file);

} // namespace filecalls

} // namespace autocuts
