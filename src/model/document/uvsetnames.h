// Names of UV sets that differ from each other.
#pragma once

#include <QHash>
#include <QSet>
#include <QString>

namespace autocuts {

//! The names that are in use. Finding a new one takes constant time, however often the same name is wanted.
class UvSetNames
{
public:
    //! The wanted name, cut to its permitted length and with a number behind it where it is in use; from now
    //! on it is.
    QString take(const QString &wanted);
    void insert(const QString &name) { mTaken.insert(name); }

private:
    QSet<QString> mTaken;
    QHash<QString, int> mNumbers; //!< the last number given, by the name before it
};

} // namespace autocuts
