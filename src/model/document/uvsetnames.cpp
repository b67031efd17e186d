#include "model/document/uvsetnames.h"

#include "model/document/constraints.h"

#include <algorithm>

namespace autocuts {

QString UvSetNames::take(const QString &wanted)
{
    const QString base = wanted.left(maxNameLength - 20); // room for the number
    QString name = base;
    if (mTaken.contains(name)) {
        int &number = mNumbers[base];
        number = std::max(number, 1);
        do
            name = QStringLiteral("%1.%2").arg(base).arg(++number);
        while (mTaken.contains(name));
    }
    mTaken.insert(name);
    return name;
}

} // namespace autocuts
