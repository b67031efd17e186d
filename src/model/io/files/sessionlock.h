// Sessions that more than one program uses at once: what changed on disk, and who has a session open.
#pragma once

#include "model/io/files/filecalls.h"

#include <QString>

#include <memory>

class QLockFile;

namespace autocuts {

//! Says by a file beside a session, .NAME.lock, that this program has it open. Nothing is locked where such a
//! file cannot be written. The file goes with the object; one that was left by a crash counts for nothing.
class SessionLock
{
public:
    explicit SessionLock(const QString &session);
    ~SessionLock();

    //! Who else has the session open, for the user; empty: nobody.
    const QString &holder() const { return mHolder; }

private:
    std::unique_ptr<QLockFile> mFile;
    QString mHolder;
};

} // namespace autocuts
