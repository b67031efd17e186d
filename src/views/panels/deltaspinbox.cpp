#include "views/panels/deltaspinbox.h"

#include <QLineEdit>
#include <QStyleOptionSpinBox>

#include <cmath>

namespace autocuts {

DeltaSpinBox::DeltaSpinBox(QWidget *parent) : QDoubleSpinBox(parent)
{
    // QDoubleSpinBox rounds values to this many decimals.
    setDecimals(15);
}

void DeltaSpinBox::stepBy(int steps)
{
    setValue(std::ldexp(value(), steps));
    selectAll();
}

QSize DeltaSpinBox::sizeHint() const
{
    // The inherited size hint has space for all decimals.
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const QSize text(fontMetrics().horizontalAdvance(QStringLiteral("8.888e-08")) + 8,
                     lineEdit()->sizeHint().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, text, this);
}

QString DeltaSpinBox::textFromValue(double value) const
{
    return locale().toString(value, 'g', 4);
}

double DeltaSpinBox::valueFromText(const QString &text) const
{
    return locale().toDouble(text);
}

QValidator::State DeltaSpinBox::validate(QString &text, int &) const
{
    bool isNumber = false;
    const double value = locale().toDouble(text, &isNumber);
    if (isNumber && value >= minimum() && value <= maximum())
        return QValidator::Acceptable;
    // The input may be incomplete: "1e-".
    return QValidator::Intermediate;
}

} // namespace autocuts
