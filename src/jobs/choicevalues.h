// Writes and reads the numbers, switches and texts of choices, for sessions.
#pragma once

#include <QCborMap>
#include <QVariant>

namespace autocuts::jobs {

//! \param visit calls its argument with each value and the name of that value in files
template <typename Choice, typename Visit>
QCborMap valuesOf(const Choice &choice, Visit visit)
{
    QCborMap map;
    visit(choice, [&map](const char *name, const auto &value) { map[QLatin1StringView(name)] = value; });
    return map;
}

//! Values that are missing from the map or have another type stay as they are. \param visit as above
template <typename Choice, typename Visit>
void takeValues(const QCborMap &map, Choice &choice, Visit visit)
{
    visit(choice, [&map]<typename Value>(const char *name, Value &value) {
        const QVariant read = map.value(QLatin1StringView(name)).toVariant();
        if (read.canConvert<Value>())
            value = read.value<Value>();
    });
}

//! Takes the number of an enumerator. A value that is missing or is no number from 0 to that of `last` leaves
//! the choice as it is.
template <typename Enum>
void takeEnumerator(const QCborMap &map, QLatin1StringView name, Enum last, Enum &choice)
{
    const QCborValue read = map.value(name);
    if (read.isInteger() && read.toInteger() >= 0 && read.toInteger() <= static_cast<qint64>(last))
        choice = static_cast<Enum>(read.toInteger());
}

} // namespace autocuts::jobs
