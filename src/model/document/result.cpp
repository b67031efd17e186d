#include "model/document/result.h"

namespace autocuts {

QString Error::toString() const
{
    QString text;
    if (!file.isEmpty()) {
        text += file;
        if (line > 0)
            text += QLatin1Char(':') + QString::number(line);
        text += QLatin1String(": ");
    }
    text += message;
    if (!remedy.isEmpty())
        text += QLatin1String(". ") + remedy;
    return text;
}

} // namespace autocuts
