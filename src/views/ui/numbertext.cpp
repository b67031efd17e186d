#include "views/ui/numbertext.h"

#include <QLocale>

#include <cmath>

namespace autocuts {

QString missingText()
{
    return QStringLiteral("–");
}

QString fixedText(double value, int decimals)
{
    if (!std::isfinite(value))
        return missingText();
    // Such values are outside the useful range; many digits would only break the layout.
    if (std::abs(value) >= 1e7)
        return QLocale().toString(value, 'g', 3);
    return QLocale().toString(value, 'f', decimals);
}

QString significantText(double value, int digits)
{
    if (!std::isfinite(value))
        return missingText();
    // More digits in front of the point than that are written out; exponents are for what is far out of
    // range.
    const double size = std::abs(value);
    const bool whole = size >= std::pow(10, digits) - 0.5 && size < 1e9;
    return whole ? QLocale().toString(value, 'f', 0) : QLocale().toString(value, 'g', digits);
}

QString countText(qint64 count)
{
    return count < 0 ? missingText() : QLocale().toString(count);
}

QString percentText(double share)
{
    return std::isfinite(share) ? QStringLiteral("%1 %").arg(QLocale().toString(100 * share, 'f', 1))
                                : missingText();
}

QString figureLine(QString text)
{
    text.replace(QLatin1Char(' '), QChar::Nbsp);
    return text.replace(QStringLiteral(",\u00a0"), QStringLiteral(", "));
}

} // namespace autocuts
